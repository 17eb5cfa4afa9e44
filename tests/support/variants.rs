//! Right pictures in every convention, and pictures with two faults.

use crate::naive::Naive;

/// The right pictures in every convention.
pub fn conventions(name: &str, width: u32, height: u32) -> Vec<(String, Naive)> {
    let right = Naive::figure(name, width, height);
    let mut all = vec![];
    for round in [false, true] {
        for t_max in [1000.0, f32::INFINITY] {
            for (words, sampled) in [
                ("corner", right),
                (
                    "middle",
                    Naive {
                        middle: true,
                        over_width: true,
                        ..right
                    },
                ),
                (
                    "middle of steps",
                    Naive {
                        middle: true,
                        ..right
                    },
                ),
                (
                    "2x2 random",
                    Naive {
                        side: 2,
                        random: true,
                        over_width: true,
                        ..right
                    },
                ),
                (
                    "4x4 random of steps",
                    Naive {
                        side: 4,
                        random: true,
                        ..right
                    },
                ),
                (
                    "4x4 regular",
                    Naive {
                        side: 4,
                        over_width: true,
                        ..right
                    },
                ),
                (
                    "one random of steps",
                    Naive {
                        side: 1,
                        random: true,
                        ..right
                    },
                ),
            ] {
                let words = format!("{words}, round {round}, t_max {t_max}");
                all.push((
                    words,
                    Naive {
                        round,
                        t_max,
                        ..sampled
                    },
                ));
            }
        }
    }
    all
}

/// What makes a right picture wrong.
pub type Change = fn(&mut Naive);

/// Faults as changes of a right picture.
pub const CHANGES: [(&str, Change); 18] = [
    ("WRAPPED", |n| n.clamp = false),
    ("NO_SHADOW", |n| n.shadows = false),
    ("ACNE", |n| n.acne = [true; 2]),
    ("OFFSET_TOO_LARGE", |n| n.offset = 0.3),
    ("SHADOW_SHIFTED", |n| n.shift = [0.3, 0.0, 0.2]),
    ("NO_FALLOFF", |n| n.falloff = 0),
    ("LINEAR_FALLOFF", |n| n.falloff = 1),
    ("WRONG_POWER", |n| n.power = 40.0),
    ("EXTRA_PI", |n| n.over_pi = true),
    ("PLANE_MISSING", |n| n.plane = false),
    ("NORMAL_FLIPPED", |n| n.flip = true),
    ("MIRRORED", |n| n.mirror = true),
    ("UPSIDE_DOWN", |n| n.upside_down = true),
    ("GAMMA", |n| n.gamma = 1),
    ("RED_BLUE_SWAPPED", |n| n.swap = true),
    ("WRONG_COLOUR", |n| n.plane_color = [0.1, 0.7, 0.2]),
    ("WRONG_BACKGROUND", |n| n.background = [0.1, 0.2, 0.4]),
    ("WRONG_FOV", |n| n.fov = 45.0),
];

/// Pairs of faults that both show in a figure: the codes, the figure, the picture.
pub fn pairs(width: u32, height: u32) -> Vec<(&'static str, &'static str, &'static str, Naive)> {
    // One hides the other: nothing is left that would show it.
    let hidden = |a: &str, b: &str, swapped: bool| {
        let (a, b) = if swapped { (b, a) } else { (a, b) };
        matches!(
            (a, b),
            ("NORMAL_FLIPPED", _)
                | ("NO_SHADOW", "ACNE" | "OFFSET_TOO_LARGE" | "SHADOW_SHIFTED")
                | ("ACNE", "OFFSET_TOO_LARGE" | "SHADOW_SHIFTED")
                | ("OFFSET_TOO_LARGE", "SHADOW_SHIFTED")
                | ("NO_FALLOFF", "LINEAR_FALLOFF" | "WRONG_POWER" | "EXTRA_PI")
                | ("WRONG_POWER", "EXTRA_PI" | "WRAPPED")
                | ("EXTRA_PI", "WRAPPED")
                | (
                    "PLANE_MISSING",
                    "NO_SHADOW" | "OFFSET_TOO_LARGE" | "SHADOW_SHIFTED"
                )
                | (
                    "PLANE_MISSING",
                    "WRONG_COLOUR" | "NO_FALLOFF" | "LINEAR_FALLOFF"
                )
        )
    };
    let mut pairs = vec![];
    for (number, (a, first)) in CHANGES.iter().enumerate() {
        for (b, second) in &CHANGES[number + 1..] {
            if hidden(a, b, false) || hidden(a, b, true) {
                continue;
            }
            let mut naive = Naive::figure("3c", width, height);
            first(&mut naive);
            second(&mut naive);
            pairs.push((*a, *b, "3c", naive));
        }
    }
    pairs
}
