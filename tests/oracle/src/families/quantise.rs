//! Components as bytes.

use super::case::Case;
use super::draw::Draw;
use super::{Family, family};

pub fn families() -> Vec<Family> {
    vec![
        family("k_over_255_nearest", 256, |d| {
            Case::quantise(d.index as f64 / 255.0)
        }),
        family("k_over_255_ulps", 96, |d| steps(d, 0.0)),
        family("half_steps", 96, |d| steps(d, 0.5)),
        family("edges", 16, edges),
        // New.
        family("k_over_256", 17, |d| Case::quantise(d.index as f64 / 16.0)),
        family("random", 16, |d| Case::quantise(d.number(0.0, 1.0))),
        family("outside", 12, |d| {
            let size = d.turn(&[1.0, 1e-3, 2.0, 255.0, 256.0, 1e30]);
            Case::quantise(if d.index < 6 {
                -size
            } else {
                size * d.number(1.0, 4.0)
            })
        }),
        family("near_the_ends", 12, |d| {
            let ulps = d.turn(&[0, 1, -1, 2, -2, 64]);
            let x = [1.0, 1.0 / 255.0][d.index / 6];
            Case::quantise(d.step(x, ulps)).note("ulp", ulps)
        }),
        family("subnormal", 6, |d| {
            Case::quantise(d.turn(&[1.0, 2.0, 1e3, -1.0, -2.0, 1e6]) * d.tiniest())
        }),
    ]
}

/// `(k - shift) / 255` for k = 1, 9, 17, …, and the neighbours of its nearest float.
fn steps(d: &mut Draw, shift: f64) -> Case {
    let (k, ulps) = (1 + 8 * (d.index / 3), d.turn(&[-1, 0, 1]));
    Case::quantise(d.step((k as f64 - shift) / 255.0, ulps))
        .note("k", k)
        .note("ulp", ulps)
}

fn edges(d: &mut Draw) -> Case {
    let specials = [
        0.0,
        -0.0,
        1.0,
        d.step(1.0, 1),
        d.step(1.0, -1),
        f64::NAN,
        d.step(0.5, 1),
        f64::INFINITY,
        f64::NEG_INFINITY,
        d.tiniest(),
        -d.tiniest(),
        d.largest(),
        -d.largest(),
        0.5,
        d.step(0.5, -1),
        1.0 / 255.0,
    ];
    Case::quantise(d.turn(&specials))
}
