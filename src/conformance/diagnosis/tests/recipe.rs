//! Faults as knobs of a recipe, and curves.

use super::{right, turned};
use crate::conformance::diagnosis::Code;
use crate::conformance::diagnosis::clauses::with;
use crate::conformance::diagnosis::recipe::{Recipe, Rounding, Transfer};
use crate::film::Film;

const FIGURES: [&str; 5] = ["1", "2a", "2b", "3a", "3c"];

/// A recipe with one fault of each code that it can have.
fn faulty(recipe: &Recipe) -> Vec<(Code, Recipe)> {
    let with = |code| with(recipe, code).map(|faulty| (code, faulty));
    let mut all: Vec<_> = Code::ALL.into_iter().filter_map(with).collect();
    if recipe.viewpoint.shadow.is_some() && recipe.acne == [false; 2] {
        for acne in [[true; 2], [true, false], [false, true]] {
            all.push((Code::Acne, turned(recipe, |r| r.acne = acne)));
        }
        let light = |r: &mut Recipe| {
            if let Some(ray) = &mut r.viewpoint.shadow {
                ray.light = [0.0, 0.5];
            }
        };
        all.push((Code::ShadowShifted, turned(recipe, light)));
    }
    let other_eye = |r: &mut Recipe| r.light_at_eye = !r.light_at_eye;
    all.push((Code::OtherFigure, turned(recipe, other_eye)));
    all
}

/// Codes of which the films of the figures allow one.
fn is_of_the_film(code: Code) -> bool {
    matches!(code, Code::Wrapped | Code::Clamped | Code::Saturated)
}

/// A recipe with one fault has that fault and no other, and without it is right again; without
/// another it stays as it is.
#[test]
fn one_fault_is_one_fault() {
    for figure in FIGURES {
        let right = right(figure);
        assert_eq!((right.faults(&right), right.knobs(&right)), (vec![], 0));
        for (code, faulty) in faulty(&right) {
            let words = format!("{figure} {code:?}");
            if faulty == right {
                continue;
            }
            let found = faulty.faults(&right);
            if code == Code::OtherFigure {
                assert!(found.contains(&code), "{words}: {found:?}");
            } else if is_of_the_film(code) {
                let expected = match right.film {
                    Film::Clamp => Code::Wrapped,
                    Film::Wrap => Code::Clamped,
                };
                assert_eq!(found, [expected], "{words}");
            } else {
                assert_eq!(found, [code], "{words}");
                let knobs = if code == Code::WrongColour { 2 } else { 1 };
                assert_eq!(faulty.knobs(&right), knobs, "{words}");
            }
            assert_eq!(faulty.without(code, &right), right, "{words}");
            for other in Code::ALL {
                let same_knob = faulty.without(other, &right) == right;
                let means = |one: Code| match one {
                    Code::Saturated | Code::Clamped => Code::Wrapped,
                    Code::ExtraPi => Code::WrongPower,
                    Code::LinearFalloff => Code::NoFalloff,
                    one => one,
                };
                let pair = [code, other];
                // Another figure's shadow takes everything along that is wrong with it.
                let of_figures = [Code::OtherFigure, Code::NoShadow];
                let takes_more = of_figures.iter().any(|code| pair.contains(code));
                let is_same = means(code) == means(other);
                assert!(same_knob == is_same || takes_more, "{words} {other:?}");
            }
        }
    }
}

/// Two faults of two knobs are both there, and the one stays when the other goes.
#[test]
fn faults_do_not_hide_each_other() {
    let right = right("3c");
    let depends = |code| matches!(code, Code::OtherFigure | Code::NoShadow | Code::Acne);
    for (first, once) in faulty(&right) {
        for (second, twice) in Code::ALL
            .into_iter()
            .filter_map(|code| Some((code, with(&once, code)?)))
        {
            if depends(first) || depends(second) || once == right || twice == once {
                continue;
            }
            let without = twice.without(second, &right);
            if without == right {
                continue;
            }
            let found = twice.faults(&right);
            let named = [first, second].iter().all(|code| found.contains(code));
            assert!(named, "{first:?} {second:?}: {found:?}");
            assert_eq!(without, once, "{first:?} {second:?}");
        }
    }
}

/// A figure with another light, or with a shadow that it should not have, or without acne that it
/// should have, is another figure; a missing shadow is a fault of its own.
#[test]
fn other_figures() {
    for (figure, asked, is_other) in [
        ("1", "2b", true),
        ("1", "3c", true),
        ("2b", "1", true),
        ("2b", "3c", false),
        ("2b", "3a", false),
        ("3c", "1", true),
        ("3c", "2b", true),
        ("3c", "3a", true),
        ("3a", "3c", false),
        ("3a", "3a", false),
    ] {
        let (recipe, asked_for) = (right(figure), right(asked));
        let words = format!("{figure} for {asked}");
        assert_eq!(
            recipe.has(Code::OtherFigure, &asked_for),
            is_other,
            "{words}"
        );
        let lacks_shadow = figure == "2b" && asked.starts_with('3');
        assert_eq!(
            recipe.has(Code::NoShadow, &asked_for),
            lacks_shadow,
            "{words}"
        );
        let has_acne = (figure, asked) == ("3a", "3c");
        assert_eq!(recipe.has(Code::Acne, &asked_for), has_acne, "{words}");
        if is_other {
            let without = recipe.without(Code::OtherFigure, &asked_for);
            assert!(!without.has(Code::OtherFigure, &asked_for), "{words}");
        }
    }
}

/// The other largest parameter of the other is the first again: 1000 and infinity.
#[test]
fn two_largest_parameters() {
    let right = right("1");
    let other = right.with_other_t_max();
    let both = [right, other].map(|r| r.viewpoint.t_max);
    assert_eq!(both, [1000.0, f64::INFINITY]);
    assert_eq!(other.with_other_t_max(), right);
}

const TRANSFERS: [Transfer; 3] = [Transfer::Linear, Transfer::Srgb, Transfer::Power];

/// Each curve rises from 0 to 1, and decoding undoes encoding.
#[test]
fn curves_have_inverses() {
    for transfer in TRANSFERS {
        let mut before = -1.0;
        for step in 0..=1000 {
            let x = f64::from(step) / 1000.0;
            let encoded = transfer.encode(x);
            assert!(encoded > before, "{transfer:?} at {x}");
            assert!(
                (transfer.decode(encoded) - x).abs() < 1e-5,
                "{transfer:?} at {x}"
            );
            before = encoded;
        }
        assert_eq!((transfer.encode(0.0), transfer.decode(0.0)), (0.0, 0.0));
        assert!((before - 1.0).abs() < 1e-12);
    }
    assert_eq!(Transfer::Power.encode(-0.5), -Transfer::Power.encode(0.5));
}

/// The radiance that is said to become a byte becomes that byte, and so do those near it: half a
/// level to each side where bytes are rounded or truncated.
#[test]
fn radiance_of_bytes() {
    for transfer in TRANSFERS {
        for rounding in [Rounding::Truncate, Rounding::Nearest] {
            let recipe = turned(&right("1"), |r| {
                (r.transfer, r.rounding) = (transfer, rounding);
            });
            for byte in 0..=255 {
                let radiance = recipe.radiance_of(byte);
                let background = turned(&recipe, |r| r.background = [radiance; 3]);
                assert_eq!(background.draw(&[]).rgb, [0; 3]);
                let level = transfer.encode(radiance) * 255.0;
                let off = level - f64::from(byte);
                let middle = match rounding {
                    Rounding::Truncate if byte > 0 && byte < 255 => 0.5,
                    _ => 0.0,
                };
                assert!(
                    (off - middle).abs() < 0.01,
                    "{transfer:?} {rounding:?} {byte}"
                );
            }
        }
    }
}

/// Bytes are in the places that the channels say.
#[test]
fn channels_are_where_the_bytes_are() {
    for swapped in [false, true] {
        let recipe = turned(&right("1"), |r| {
            r.swapped = swapped;
            r.background = [0.2, 0.5, 0.8];
        });
        let size = super::size(32, 32);
        let sky = super::picture(&recipe, size).pixel(0, 0).expect("a pixel");
        let seen = recipe.channels().map(|channel| sky[channel]);
        assert_eq!(seen, [51, 127, 204]);
    }
}
