//! Numbers that are found by trying.

use super::{Coarse, is_near, lossy, picture, right, size, turned, whole};
use crate::conformance::diagnosis::Code;
use crate::conformance::diagnosis::best::Best;
use crate::conformance::diagnosis::color::{self, without_traces};
use crate::conformance::diagnosis::evidence::Evidence;
use crate::conformance::diagnosis::loss::{Loss, Lossless};
use crate::conformance::diagnosis::recipe::{Recipe, Rounding, Sampling, ShadowRay};
use crate::conformance::diagnosis::refine::{factor, refined, snapped};
use crate::conformance::diagnosis::search::in_its_conventions;
use crate::picture::Picture;
use std::f64::consts::PI;

const SIZE: (u32, u32) = (96, 64);

fn drawn(recipe: &Recipe) -> Picture {
    picture(recipe, size(SIZE.0, SIZE.1))
}

/// What a guess becomes, by trying, in the picture of another recipe.
fn refine(guess: &Recipe, of: &Recipe) -> Recipe {
    let expected = right("3c");
    refined(&whole(&drawn(of), &Lossless), *guess, &expected).expect("viewpoints")
}

fn are_near(found: [f64; 3], drawn: [f64; 3]) {
    for (found, drawn) in found.into_iter().zip(drawn) {
        is_near(found, drawn, 0.02);
    }
}

/// A field of view is found from one several degrees beside it; with it, colours that were measured
/// in the wrong one.
#[test]
fn fields_of_view_are_found() {
    let right = right("3c");
    for (fov, from) in [(45.0, 48.0), (70.3, 66.0)] {
        let of = turned(&right, |r| r.viewpoint.fov = fov);
        let guess = turned(&right, |r| r.viewpoint.fov = from);
        let found = refine(&guess, &of);
        is_near(found.viewpoint.fov, fov, 0.1);
        assert_eq!(found.faults(&right), [Code::WrongFov]);
        // Colours and powers that another field of view suggested are no faults.
        let misled = turned(&guess, |r| (r.power, r.colors[1]) = (1.3, [0.7, 0.0, 0.0]));
        let found = refine(&misled, &of);
        is_near(found.viewpoint.fov, fov, 0.1);
        assert_eq!(found.faults(&right), [Code::WrongFov]);
        let color = [0.2, 0.6, 0.3];
        let colored = turned(&of, |r| r.colors[1] = color);
        let guess = turned(&guess, |r| r.colors[1] = [0.25, 0.5, 0.4]);
        let found = refine(&guess, &colored);
        is_near(found.viewpoint.fov, fov, 0.1);
        are_near(found.colors[1], color);
    }
}

/// No small step of a component brings a colour nearer that was found, through a loss or without one.
#[test]
fn a_colour_that_was_found_is_the_nearest() {
    let losses: [&dyn Loss; 3] = [&Lossless, &Coarse(3), &Coarse(8)];
    for (index, color) in [(0, [0.33, 0.12, 0.61]), (1, [0.52, 0.27, 0.08])] {
        for loss in losses {
            let of = turned(&right("3c"), |r| r.colors[index] = color);
            let of = lossy(&drawn(&of), loss);
            let evidence = whole(&of, loss);
            let mut best = Best::of(&evidence, right("3c")).expect("a viewpoint");
            color::refine(&mut best, index).expect("viewpoints");
            for step in [0.01, -0.01, 0.002, -0.002] {
                for component in 0..3 {
                    let moved = turned(&best.recipe, |r| r.colors[index][component] += step);
                    let error = evidence.error(&moved).expect("a viewpoint");
                    assert!(
                        error >= best.error,
                        "{color:?} {component} {step}: {error}, not {}",
                        best.error
                    );
                }
            }
        }
    }
}

/// Powers are found from a tenth beside them; next to the right one they are the right one.
#[test]
fn powers_are_found() {
    let right = right("3c");
    for power in [0.1, 0.9, 4.0] {
        for part in [0.9, 1.0, 1.12] {
            let [of, guess] = [power, power * part].map(|x| turned(&right, |r| r.power = x));
            is_near(refine(&guess, &of).power, power, 0.002 * power);
        }
    }
    for power in [1.0, 1.0 / PI] {
        let of = turned(&right, |r| r.power = power);
        let guess = turned(&right, |r| r.power = 1.008 * power);
        assert_eq!(refine(&guess, &of).power, power);
    }
}

/// Offsets are found from a third beside them.
#[test]
fn offsets_are_found() {
    let right = right("3c");
    for offset in [0.25] {
        for part in [0.8, 1.3] {
            let [of, guess] = [offset, offset * part].map(|offset| {
                turned(&right, |r| {
                    r.viewpoint.shadow = Some(ShadowRay {
                        offset,
                        ..ShadowRay::default()
                    });
                })
            });
            // So large that an edge that moves by a tenth of the way is in other pixels.
            let of = picture(&of, size(240, 160));
            let found = refined(&whole(&of, &Lossless), guess, &right).expect("viewpoints");
            let found = found.viewpoint.shadow.expect("a shadow");
            is_near(found.offset, offset, 0.1 * offset);
        }
    }
}

/// What is right stays as it is, and what is wrong otherwise is left alone.
#[test]
fn what_is_right_stays() {
    let right = right("3c");
    let near = turned(&right, |r| {
        r.viewpoint.fov += 0.05;
        r.power = 0.995;
        r.colors = [[0.0, 0.006, 0.995], [0.995, 0.0, 0.004]];
    });
    assert_eq!(refine(&near, &right), right);
    let mirrored = turned(&right, |r| (r.viewpoint.mirrored, r.falloff) = (true, 1));
    assert_eq!(refine(&mirrored, &mirrored), mirrored);
}

/// Two wrong colours are one fault where one explains them: exchanged channels, or another power.
#[test]
fn two_colours_are_one_fault() {
    let right = right("3c");
    for (colors, code) in [
        ([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], Code::RedBlueSwapped),
        ([[0.0, 0.0, 0.5], [0.5, 0.0, 0.0]], Code::WrongPower),
        ([[0.0, 0.0, 1.0 / PI], [1.0 / PI, 0.0, 0.0]], Code::ExtraPi),
        ([[0.0, 0.0, 0.5], [1.0, 0.0, 0.0]], Code::WrongColour),
        ([[0.0, 0.4, 0.5], [0.2, 0.3, 0.0]], Code::WrongColour),
    ] {
        let guess = turned(&right, |r| r.colors = colors);
        let found = refine(&guess, &guess);
        assert_eq!(found.faults(&right), [code], "{colors:?}: {found:?}");
        let [before, after] = [guess, found].map(|recipe| drawn(&recipe));
        let off = before
            .bytes()
            .iter()
            .zip(after.bytes())
            .map(|(a, b)| a.abs_diff(*b))
            .max();
        assert!(off <= Some(1), "{colors:?}: {off:?}");
    }
}

/// A colour is another's multiple where each component is, give or take two hundredths of the
/// brightest, and more through a loss.
#[test]
fn factors_of_colours() {
    let of = [0.16, 0.8, 0.0];
    for by in [0.1, 1.0, 3.0] {
        let color = of.map(|x| by * x);
        let found = factor(color, of, 0).expect("a multiple");
        assert!((found - by).abs() < 1e-12);
        for (off, tolerance, is_one) in [
            (0.019, 0, true),
            (-0.019, 0, true),
            (0.021, 0, false),
            (-0.021, 0, false),
            (0.039, 4, true),
            (0.041, 4, false),
        ] {
            for c in [0, 2] {
                let mut other = color;
                other[c] += off * by;
                assert_eq!(
                    factor(other, of, tolerance).is_some(),
                    is_one,
                    "{by} {off} {tolerance}"
                );
            }
        }
    }
    for nothing in [
        factor([0.0; 3], of, 0),
        factor([-0.2, -1.0, 0.0], of, 0),
        factor(of, [0.0; 3], 0),
    ] {
        assert_eq!(nothing, None);
    }
}

/// The convention in which a picture was drawn is the one that is found, from any other.
#[test]
fn conventions_are_found() {
    let right = right("3c");
    let mut all = vec![];
    for sampling in Sampling::ALL {
        for rounding in [Rounding::Truncate, Rounding::Nearest] {
            all.push(turned(&right, |r| {
                (r.viewpoint.sampling, r.rounding) = (sampling, rounding);
            }));
        }
    }
    for of in &all {
        let picture = drawn(of);
        let evidence = whole(&picture, &Lossless);
        for from in &all {
            let found = in_its_conventions(&evidence, *from).expect("viewpoints");
            assert_eq!(found, *of, "from {from:?}");
        }
    }
    let high = turned(&super::right("1"), |r| r.viewpoint.t_max = f64::INFINITY);
    for of in [high, high.with_other_t_max()] {
        let picture = picture(&of, size(130, 310));
        let evidence = whole(&picture, &Lossless);
        let found = in_its_conventions(&evidence, of.with_other_t_max()).expect("viewpoints");
        assert_eq!(found, of);
    }
}

/// A power that is off by a hundredth, and more through a loss, is the expected one; so are fields of
/// view within a tenth of a degree.
#[test]
fn numbers_that_are_the_same() {
    let right = right("3c");
    for tolerance in [0, 3, 6] {
        let same = 0.012 * (1.0 + f64::from(tolerance) / 3.0);
        for power in [1.0, 1.0 / PI] {
            for part in [-1.05, -0.95, 0.95, 1.05] {
                let off = turned(&right, |r| r.power = power * (1.0 + part * same));
                let is_same = snapped(off, &right, tolerance).power == power;
                assert_eq!(is_same, f64::abs(part) < 1.0, "{tolerance} {power} {part}");
            }
        }
        for (by, is_same) in [(0.09, true), (-0.09, true), (0.11, false), (-0.11, false)] {
            let off = turned(&right, |r| r.viewpoint.fov += by);
            assert_eq!(snapped(off, &right, tolerance) == right, is_same, "{by}");
        }
    }
}

/// Of a colour's small components any may be traces, together or alone; the others are none.
#[test]
fn traces_are_left_out() {
    let recipe = turned(&right("3c"), |r| r.colors[1] = [0.29, 0.3, 0.1]);
    let found: Vec<[f64; 3]> = without_traces(recipe, 1)
        .iter()
        .map(|tried| tried.colors[1])
        .collect();
    for without in [[0.0, 0.3, 0.1], [0.29, 0.3, 0.0], [0.0, 0.3, 0.0]] {
        assert!(found.contains(&without), "{found:?}");
    }
    assert!(found.iter().all(|color| color[1] == 0.3));
    let small = turned(&recipe, |r| r.colors[1] = [0.29, 0.25, 0.1]);
    let mut found = without_traces(small, 1).into_iter();
    assert!(found.any(|tried| tried.colors[1] == [0.0; 3]));
    let others = without_traces(recipe, 1);
    assert!(
        others
            .iter()
            .all(|tried| tried.colors[0] == recipe.colors[0])
    );
}

/// A loss that mixes a little of each channel into its neighbours.
struct Bleeds;

impl Loss for Bleeds {
    fn degrade(&self, _: u32, _: u32, pixels: &mut [[u8; 3]]) {
        for rgb in pixels {
            let mean = rgb.iter().map(|&x| f64::from(x)).sum::<f64>() / 3.0;
            *rgb = rgb.map(|x| (0.9 * f64::from(x) + 0.1 * mean).round() as u8);
        }
    }

    fn tolerance(&self) -> u8 {
        3
    }
}

/// What a loss adds to a measured colour is taken off again.
#[test]
fn colours_through_a_loss() {
    let right = right("3c");
    for (object, color) in [
        (1, [0.4, 0.8, 0.0]),
        (0, [0.9, 0.0, 0.1]),
        (1, [0.0, 0.5, 0.0]),
    ] {
        let of = turned(&right, |r| r.colors[object] = color);
        let black = Picture::black(size(SIZE.0, SIZE.1));
        let seen = Evidence::new(&black, vec![super::everything(black.size())], &Bleeds);
        let seen = seen.predicted(&of).expect("a viewpoint");
        let seen = Picture::from_pixels(black.size(), seen.iter().map(|pixel| pixel.rgb).collect());
        let seen = seen.expect("all pixels");
        let evidence = Evidence::new(&seen, vec![super::everything(seen.size())], &Bleeds);
        let guess = turned(&right, |r| r.colors[object] = color.map(|x| 0.9 * x + 0.04));
        let found = refined(&evidence, guess, &right).expect("viewpoints");
        are_near(found.colors[object], color);
        // Less than a byte's step is left of what bleeds into a component that is 0.
        for (found, drawn) in found.colors[object].iter().zip(color) {
            assert_eq!(*found < 1.0 / 255.0, drawn == 0.0, "{found} {color:?}");
        }
        assert_eq!(found.colors[1 - object], right.colors[1 - object]);
    }
}
