//! Samples of a point light.

use super::case::Case;
use super::draw::{Draw, add};
use super::{Family, family};

pub fn families() -> Vec<Family> {
    vec![
        family("generic", 12, |d| {
            let color = [(); 3].map(|()| d.number(0.0, 1.0));
            Case::light_sample(d.point(10.0), d.point(10.0), d.number(1.0, 200.0), color)
        }),
        family("base_scene", 5, |d| {
            let p = d.turn(&[
                [0.0, 0.0, 2.0],
                [0.0, -2.0, 5.0],
                [-3.5, -2.0, 1.0],
                [0.0, 1.0, 3.0],
                [0.6, 0.0, 2.2],
            ]);
            sample(p, [1.0, 10.0, 1.0])
        }),
        family("light_at_point", 4, |d| {
            let p = d.turn(&[
                [1.0, 10.0, 1.0],
                [0.0; 3],
                [1e30, -1e-30, 0.1],
                [-0.0, 0.0, -0.0],
            ]);
            sample(p, p.map(|x| if x == 0.0 { 0.0 } else { x }))
        }),
        family("one_ulp_apart", 8, |d| {
            let (p, mut light) = ([1.0, 10.0, 1.0], [1.0, 10.0, 1.0]);
            let axis = d.turn(&[1, 0, 2]);
            light[axis] = d.step(light[axis], d.turn(&[1, -1, 2, -2]));
            sample(p, light)
        }),
        family("one_denormal_apart", 5, |d| {
            let size = d.turn(&[1.0, -1.0, 2.0, 7.0, 1000.0]) * d.tiniest();
            sample([0.0; 3], [0.0, size, 0.0])
        }),
        family("d2_overflow", 10, |d| far(d, d.by(1e18, 1e150))),
        family("d2_underflow", 10, |d| near(d, d.by(1e-18, 1e-150))),
        family("huge_coords", 4, |d| {
            let size = d.turn(&[1e4, 1e5, 1e6, 1e7]);
            let p = [size, -size, size];
            sample(p, add(p, [1.0, 10.0, 1.0]))
        }),
        family("zero_power", 4, |d| {
            Case::light_sample(
                [0.0; 3],
                [1.0, 10.0, 1.0],
                d.turn(&[0.0, -0.0]),
                [[1.0; 3], [0.0; 3]][d.index / 2],
            )
        }),
        family("negative_power", 3, |d| {
            Case::light_sample(
                [0.0; 3],
                [1.0, 10.0, 1.0],
                d.turn(&[-5.0, -1e-3, -100.0]),
                [1.0, 0.5, 0.0],
            )
        }),
        family("nonfinite", 11, nonfinite),
        // New.
        family("pythagorean", 5, |d| {
            let light = d.turn(&[
                [3.0, 4.0, 0.0],
                [1.0, 2.0, 2.0],
                [2.0, 3.0, 6.0],
                [0.0, 0.0, -4.0],
                [-1.0, 4.0, 8.0],
            ]);
            sample([0.0; 3], light)
        }),
        family("difference_overflows", 4, |d| {
            let huge = d.largest() * d.turn(&[1.0, 0.75]);
            sample(
                [0.0, -huge, 0.0],
                [[0.0, huge, 0.0], [huge; 3]][d.index / 2],
            )
        }),
        family("dist_overflows", 3, |d| {
            // Each coordinate is finite; the distance is not.
            let size = d.largest() * d.turn(&[0.75, 1.0, 0.6]);
            sample([0.0; 3], [size, size, size])
        }),
        family("d2_subnormal", 6, |d| near(d, d.by(3e-20, 1e-155))),
        family("radiance_overflows", 4, |d| {
            let power = d.by(1e30, 1e200);
            let light = [
                0.0,
                0.0,
                d.turn(&[1.0, 1e-3, 0.1, 1e-5]) * d.by(1e-4, 1e-50),
            ];
            Case::light_sample([0.0; 3], light, power, [1.0, 0.5, 1e-10])
        }),
        family("radiance_subnormal", 3, |d| {
            let light = [0.0, d.turn(&[1.0, 3.0, 10.0]) * d.by(1e18, 1e153), 1.0];
            Case::light_sample([0.0; 3], light, d.by(1e-4, 1e-8), [1.0, 0.1, 1e-3])
        }),
        family("power_times_color_overflows", 2, |d| {
            // The product is out of range and the quotient in it.
            let huge = d.by(1e30, 1e250) * d.turn(&[1.0, 7.0]);
            Case::light_sample(
                [0.0; 3],
                [0.0, d.by(1e15, 1e130), 3.0],
                huge,
                [huge, 1.0, 0.0],
            )
        }),
        family("mixed_scales", 6, |d| {
            let (large, small) = d.turn(&[(1e6, 1e-6), (1e15, 1.0), (1.0, 1e-18)]);
            sample(
                [0.0; 3],
                [d.number(-large, large), d.number(-small, small), small],
            )
        }),
        family("inexact_subtraction", 6, |d| {
            // The light is lost beside the point.
            let size = d.turn(&[1e8, 1e17, 16_777_216.0]);
            sample(
                [size, 0.5, -size],
                [d.number(0.0, 1.0), 0.25, d.number(0.0, 1.0)],
            )
        }),
        family("negzero_coordinates", 3, |d| {
            sample(
                [-0.0; 3],
                d.turn(&[[0.0, 2.0, -0.0], [-0.0, -0.0, 1.0], [3.0, -0.0, 0.0]]),
            )
        }),
        family("colored_light", 5, |d| {
            let color = d.turn(&[
                [1.0, 0.0, 0.0],
                [0.2, 0.4, 0.8],
                [5.0, 0.0, -1.0],
                [1e-20, 1.0, 1e20],
                [-0.0, 0.5, 1.0],
            ]);
            Case::light_sample(d.point(3.0), [1.0, 10.0, 1.0], 100.0, color)
        }),
    ]
}

/// A white light of power 100.
fn sample(p: [f64; 3], light: [f64; 3]) -> Case {
    Case::light_sample(p, light, 100.0, [1.0; 3])
}

fn far(d: &mut Draw, size: f64) -> Case {
    let size = size * d.turn(&[1.0, 10.0, 100.0, 0.1, 20.0]);
    sample(
        [0.0; 3],
        if d.index < 5 {
            [0.0, size, 0.0]
        } else {
            [size, -0.7 * size, 0.3 * size]
        },
    )
}

fn near(d: &mut Draw, size: f64) -> Case {
    let size = size * d.turn(&[1.0, 0.1, 0.01, 10.0, 0.05]);
    sample(
        [0.0; 3],
        if d.index < 5 {
            [0.0, size, 0.0]
        } else {
            [size, -0.7 * size, 0.3 * size]
        },
    )
}

/// One NaN or infinity, everywhere in turn.
fn nonfinite(d: &mut Draw) -> Case {
    let special = d.turn(&[
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        f64::INFINITY,
    ]);
    let (mut p, mut light, mut power, mut color) = ([0.0; 3], [1.0, 10.0, 1.0], 100.0, [1.0; 3]);
    match d.index {
        0..3 => p[d.index] = special,
        3..6 => light[d.index - 3] = special,
        6..9 => color[d.index - 6] = special,
        _ => power = special,
    }
    Case::light_sample(p, light, power, color)
}
