//! Every mistake that the plain ray tracer can make, one at a time.

use crate::naive::Naive;

/// Every fault of one knob that shows in a figure: its code, the figure, the picture.
pub fn faults(width: u32, height: u32) -> Vec<(&'static str, &'static str, Naive)> {
    let of = |name| Naive::figure(name, width, height);
    let (eye, wraps, clamps, shadows) = (of("1"), of("2a"), of("2b"), of("3c"));
    let averaged = Naive { side: 4, ..shadows };
    vec![
        (
            "WRAPPED",
            "2b",
            Naive {
                clamp: false,
                ..clamps
            },
        ),
        (
            "WRAPPED",
            "3c",
            Naive {
                clamp: false,
                ..shadows
            },
        ),
        (
            "CLAMPED",
            "2a",
            Naive {
                clamp: true,
                ..wraps
            },
        ),
        (
            "SATURATED",
            "2a",
            Naive {
                saturate: true,
                ..wraps
            },
        ),
        (
            "NO_SHADOW",
            "3c",
            Naive {
                shadows: false,
                ..shadows
            },
        ),
        (
            "ACNE",
            "3c",
            Naive {
                acne: [true; 2],
                ..shadows
            },
        ),
        (
            "ACNE",
            "3c",
            Naive {
                acne: [true, false],
                ..shadows
            },
        ),
        (
            "ACNE",
            "3c",
            Naive {
                acne: [false, true],
                ..shadows
            },
        ),
        (
            "ACNE",
            "3c",
            Naive {
                acne: [true; 2],
                ..averaged
            },
        ),
        (
            "ACNE",
            "3c",
            Naive {
                acne: [true, false],
                ..averaged
            },
        ),
        (
            "ACNE",
            "3c",
            Naive {
                acne: [false, true],
                ..averaged
            },
        ),
        (
            "OFFSET_TOO_LARGE",
            "3c",
            Naive {
                offset: 0.05,
                ..shadows
            },
        ),
        (
            "OFFSET_TOO_LARGE",
            "3c",
            Naive {
                offset: 0.1,
                ..shadows
            },
        ),
        (
            "OFFSET_TOO_LARGE",
            "3c",
            Naive {
                offset: 0.5,
                ..shadows
            },
        ),
        (
            "SHADOW_SHIFTED",
            "3c",
            Naive {
                shift: [0.3, 0.0, 0.2],
                ..shadows
            },
        ),
        (
            "SHADOW_SHIFTED",
            "3c",
            Naive {
                shadow_light: Some([-1.0, 10.0, 1.0]),
                ..shadows
            },
        ),
        (
            "COSINE_UNCLAMPED",
            "2a",
            Naive {
                clamp_cosine: false,
                ..wraps
            },
        ),
        (
            "NO_FALLOFF",
            "2a",
            Naive {
                falloff: 0,
                ..wraps
            },
        ),
        (
            "NO_FALLOFF",
            "2b",
            Naive {
                falloff: 0,
                ..clamps
            },
        ),
        (
            "NO_FALLOFF",
            "3c",
            Naive {
                falloff: 0,
                ..shadows
            },
        ),
        (
            "LINEAR_FALLOFF",
            "2a",
            Naive {
                falloff: 1,
                ..wraps
            },
        ),
        (
            "LINEAR_FALLOFF",
            "2b",
            Naive {
                falloff: 1,
                ..clamps
            },
        ),
        (
            "LINEAR_FALLOFF",
            "3c",
            Naive {
                falloff: 1,
                ..shadows
            },
        ),
        (
            "WRONG_POWER",
            "2a",
            Naive {
                power: 50.0,
                ..wraps
            },
        ),
        (
            "WRONG_POWER",
            "2b",
            Naive {
                power: 200.0,
                ..clamps
            },
        ),
        (
            "WRONG_POWER",
            "3c",
            Naive {
                power: 10.0,
                ..shadows
            },
        ),
        (
            "WRONG_POWER",
            "3c",
            Naive {
                power: 1000.0,
                ..shadows
            },
        ),
        (
            "EXTRA_PI",
            "2a",
            Naive {
                over_pi: true,
                ..wraps
            },
        ),
        (
            "EXTRA_PI",
            "3c",
            Naive {
                over_pi: true,
                ..shadows
            },
        ),
        (
            "PLANE_MISSING",
            "1",
            Naive {
                plane: false,
                ..eye
            },
        ),
        (
            "PLANE_MISSING",
            "3c",
            Naive {
                plane: false,
                ..shadows
            },
        ),
        ("NORMAL_FLIPPED", "1", Naive { flip: true, ..eye }),
        (
            "NORMAL_FLIPPED",
            "2b",
            Naive {
                flip: true,
                ..clamps
            },
        ),
        (
            "NORMAL_FLIPPED",
            "3c",
            Naive {
                flip: true,
                ..shadows
            },
        ),
        (
            "MIRRORED",
            "2a",
            Naive {
                mirror: true,
                ..wraps
            },
        ),
        (
            "MIRRORED",
            "2b",
            Naive {
                mirror: true,
                ..clamps
            },
        ),
        (
            "MIRRORED",
            "3c",
            Naive {
                mirror: true,
                ..shadows
            },
        ),
        (
            "UPSIDE_DOWN",
            "1",
            Naive {
                upside_down: true,
                ..eye
            },
        ),
        (
            "UPSIDE_DOWN",
            "3c",
            Naive {
                upside_down: true,
                ..shadows
            },
        ),
        ("GAMMA", "1", Naive { gamma: 1, ..eye }),
        ("GAMMA", "2a", Naive { gamma: 1, ..wraps }),
        (
            "GAMMA",
            "3c",
            Naive {
                gamma: 1,
                ..shadows
            },
        ),
        (
            "GAMMA",
            "3c",
            Naive {
                gamma: 2,
                ..shadows
            },
        ),
        ("RED_BLUE_SWAPPED", "1", Naive { swap: true, ..eye }),
        (
            "RED_BLUE_SWAPPED",
            "3c",
            Naive {
                swap: true,
                ..shadows
            },
        ),
        (
            "WRONG_COLOUR",
            "1",
            Naive {
                sphere_color: [0.0, 1.0, 0.0],
                ..eye
            },
        ),
        (
            "WRONG_COLOUR",
            "3c",
            Naive {
                sphere_color: [0.2, 0.6, 0.9],
                ..shadows
            },
        ),
        (
            "WRONG_COLOUR",
            "3c",
            Naive {
                plane_color: [0.5, 0.5, 0.0],
                ..shadows
            },
        ),
        (
            "WRONG_BACKGROUND",
            "1",
            Naive {
                background: [0.0; 3],
                ..eye
            },
        ),
        (
            "WRONG_BACKGROUND",
            "3c",
            Naive {
                background: [0.2, 0.3, 0.8],
                ..shadows
            },
        ),
        ("WRONG_FOV", "1", Naive { fov: 45.0, ..eye }),
        (
            "WRONG_FOV",
            "3c",
            Naive {
                fov: 70.0,
                ..shadows
            },
        ),
        (
            "OTHER_SCENE",
            "3c",
            Naive {
                sphere: [1.0, 0.0, 4.0, 1.0],
                ..shadows
            },
        ),
        (
            "OTHER_SCENE",
            "3c",
            Naive {
                plane_y: -2.1,
                ..shadows
            },
        ),
        (
            "OTHER_SCENE",
            "3c",
            Naive {
                light: [-2.0, 5.0, 0.0],
                ..shadows
            },
        ),
        (
            "OTHER_SCENE",
            "3c",
            Naive {
                eye: [0.0, 1.0, -3.0],
                ..shadows
            },
        ),
    ]
}
