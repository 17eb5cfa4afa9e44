//! The hypotheses: each a fault more.

use super::{picture, right, size, turned, whole};
use crate::conformance::diagnosis::Code;
use crate::conformance::diagnosis::changes::changes;
use crate::conformance::diagnosis::clauses::with;
use crate::conformance::diagnosis::loss::Lossless;
use crate::conformance::diagnosis::recipe::{Cosine, Recipe, ShadowRay};
use crate::conformance::diagnosis::search::{Candidate, nearest};
use crate::picture::Picture;

/// The changes of one recipe that a picture of another suggests, where a third is expected.
fn changes_of(drawn: &Recipe, by: &Recipe, expected: &Recipe) -> Vec<Recipe> {
    let picture = picture(drawn, size(72, 48));
    changes(&whole(&picture, &Lossless), by, expected).expect("viewpoints")
}

const FIGURES: [&str; 5] = ["1", "2a", "2b", "3a", "3c"];

/// Faults that one knob makes in a figure.
fn faulty(figure: &str) -> Vec<(Code, Recipe)> {
    let right = right(figure);
    // Saturated is Clamped by another name.
    let all = Code::ALL
        .into_iter()
        .filter(|code| *code != Code::Saturated);
    let faulty = all.filter_map(|code| Some((code, with(&right, code)?)));
    faulty.filter(|(_, faulty)| *faulty != right).collect()
}

/// In the picture of a fault one of the changes is that fault, and nothing else.
#[test]
fn every_fault_is_a_change() {
    for figure in FIGURES {
        let right = right(figure);
        for (code, faulty) in faulty(figure) {
            // One colour at a time is changed, and where a shadow lies is looked for later.
            if [Code::WrongColour, Code::ShadowShifted].contains(&code) {
                continue;
            }
            let found = changes_of(&faulty, &right, &right);
            let is_one = found.iter().any(|change| change.faults(&right) == [code]);
            assert!(is_one, "{figure} {code:?}");
        }
    }
}

/// Every figure may be another: one that is lit at the eye, one with shadows, one without acne.
#[test]
fn other_figures_are_tried() {
    for (claimed, others) in [
        ("1", &["2b", "3c"][..]),
        ("2a", &["1", "3c"]),
        ("2b", &["1", "3c"]),
        ("3a", &["1", "3c"]),
        ("3c", &["1"]),
    ] {
        let claimed = right(claimed);
        let found = changes_of(&claimed, &claimed, &claimed);
        for other in others {
            let other = right(other);
            let is_it = |change: &&Recipe| {
                change.light_at_eye == other.light_at_eye
                    && change.viewpoint.shadow == other.viewpoint.shadow
                    && change.acne == [false; 2]
                    && change.faults(&claimed).contains(&Code::OtherFigure)
            };
            assert_eq!(found.iter().filter(is_it).count(), 1, "{others:?}");
        }
    }
}

/// From one fault the others are a change away, and the fault itself is not.
#[test]
fn every_second_fault_is_a_change() {
    let right = right("3c");
    for (first, once) in faulty("3c") {
        for (second, twice) in faulty("3c") {
            let both = with(&once, second);
            let Some(both) = both.filter(|both| *both != once && *both != twice) else {
                continue;
            };
            let expected = both.faults(&right);
            let skipped = [Code::WrongColour, Code::ShadowShifted, Code::OffsetTooLarge];
            if expected.len() != 2 || skipped.contains(&second) || skipped.contains(&first) {
                continue;
            }
            let powers = [Code::WrongPower, Code::ExtraPi];
            // Through another curve a power is a colour, and what is all dark or too bright has none.
            let hides = [Code::Gamma, Code::NoFalloff, Code::NormalFlipped].contains(&first);
            let found = changes_of(&both, &once, &right);
            let is_one = found.iter().any(|change| change.faults(&right) == expected);
            assert!(
                is_one || hides && powers.contains(&second),
                "{first:?} {second:?}"
            );
        }
    }
}

/// No change leaves a recipe as it is, none comes twice, and each has a fault that was not there.
#[test]
fn changes_add_faults() {
    for figure in FIGURES {
        let expected = right(figure);
        for (code, recipe) in faulty(figure)
            .into_iter()
            .chain([(Code::OtherScene, expected)])
        {
            let found = changes_of(&recipe, &recipe, &expected);
            let before = recipe.faults(&expected);
            for (number, change) in found.iter().enumerate() {
                let after = change.faults(&expected);
                let words = format!("{figure} {code:?}: {before:?} to {after:?}");
                assert_ne!(*change, recipe, "{words}");
                assert!(!found[..number].contains(change), "{words}");
                let adds = after.iter().any(|code| !before.contains(code));
                assert!(adds, "{words}");
            }
        }
    }
}

/// In its own picture no number of a recipe is off: only what is not measured is tried.
#[test]
fn what_is_right_is_not_measured_otherwise() {
    for figure in FIGURES {
        let right = right(figure);
        for change in changes_of(&right, &right, &right) {
            let faults = change.faults(&right);
            for measured in [Code::WrongPower, Code::WrongColour, Code::WrongBackground] {
                assert!(!faults.contains(&measured), "{figure} {faults:?}");
            }
        }
    }
}

/// What was measured and is off by two levels is the same; by more it is another. What is not
/// another keeps its expected component.
#[test]
fn small_differences_are_none() {
    let right = right("3c");
    for (by, is_other) in [
        (1.0, false),
        (2.0, false),
        (4.0, true),
        (-2.0, false),
        (-4.0, true),
    ] {
        let level = by / 255.0;
        let sky = turned(&right, |r| r.background[1] += level);
        let found = changes_of(&sky, &right, &right);
        let other = found
            .iter()
            .find(|change| change.background != right.background);
        assert_eq!(other.is_some(), is_other, "{by}");
        let floor = turned(&right, |r| {
            r.colors[1] = [1.0 - 0.02 * level.abs(), 0.5, 0.0];
        });
        let found = changes_of(&floor, &right, &right);
        let other = found
            .iter()
            .find(|change| change.colors[1] != right.colors[1]);
        let [red, green, blue] = other.expect("another colour").colors[1];
        assert_eq!((red, blue), (1.0, 0.0));
        assert!((green - 0.5).abs() < 0.01);
    }
    for (power, is_other) in [(1.005, false), (0.995, false), (1.03, true), (0.97, true)] {
        for of in [1.0, std::f64::consts::FRAC_1_PI] {
            let drawn = turned(&right, |r| r.power = power * of);
            let found = changes_of(&drawn, &right, &right);
            let is = |change: &Recipe| change.has(Code::WrongPower, &right);
            assert_eq!(found.iter().any(is), is_other, "{power} {of}");
        }
    }
    // A black object has no colour that could be told from a shadow.
    let black = turned(&right, |r| r.colors[1] = [0.0; 3]);
    let found = changes_of(&black, &right, &right);
    assert!(
        found
            .iter()
            .all(|change| change.colors[1] == right.colors[1])
    );
}

/// A fault's name, how a recipe gets it, and whether two recipes have it alike.
type Knob = (&'static str, fn(&mut Recipe), fn(&Recipe, &Recipe) -> bool);

/// What cannot be told apart is not asked twice: a recipe that has one of these faults is not given
/// it again, nor one that would hide it.
#[test]
fn what_is_there_is_not_asked_again() {
    let right = right("3c");
    let knobs: [Knob; 12] = [
        (
            "film",
            |r| r.film = crate::Film::Wrap,
            |a, b| a.film == b.film,
        ),
        (
            "acne",
            |r| r.acne = [true, false],
            |a, b| a.acne == b.acne || a.acne == [false; 2],
        ),
        (
            "flipped",
            |r| r.flipped = [true, false],
            |a, b| a.flipped == b.flipped,
        ),
        (
            "cosine",
            |r| r.cosine = Cosine::Absolute,
            |a, b| a.cosine == b.cosine,
        ),
        ("falloff", |r| r.falloff = 1, |a, b| a.falloff == b.falloff),
        (
            "plane",
            |r| r.viewpoint.has_plane = false,
            |a, b| a.viewpoint.has_plane == b.viewpoint.has_plane,
        ),
        (
            "mirrored",
            |r| r.viewpoint.mirrored = true,
            |a, b| a.viewpoint.mirrored == b.viewpoint.mirrored,
        ),
        (
            "upside down",
            |r| r.viewpoint.upside_down = true,
            |a, b| a.viewpoint.upside_down == b.viewpoint.upside_down,
        ),
        (
            "swapped",
            |r| r.swapped = true,
            |a, b| a.swapped == b.swapped,
        ),
        (
            "fov",
            |r| r.viewpoint.fov = 45.0,
            |a, b| a.viewpoint.fov == b.viewpoint.fov,
        ),
        ("power", |r| r.power = 0.5, |a, b| a.power == b.power),
        (
            "sky",
            |r| r.background = [0.1, 0.9, 0.2],
            |a, b| a.background == b.background,
        ),
    ];
    for (name, turn, is_kept) in knobs {
        let once = turned(&right, turn);
        // A picture that has nothing to do with it suggests every number.
        let other = turned(&right, |r| (r.power, r.background) = (0.7, [0.7, 0.2, 0.1]));
        let found = changes_of(&other, &once, &right);
        assert!(found.len() > 10);
        assert!(found.iter().all(|change| is_kept(change, &once)), "{name}");
    }
    let exact = right.viewpoint.shadow;
    let offset = turned(&right, |r| {
        r.viewpoint.shadow = Some(ShadowRay {
            offset: 0.2,
            ..ShadowRay::default()
        });
    });
    let rays: Vec<_> = changes_of(&offset, &offset, &right)
        .iter()
        .map(|r| r.viewpoint.shadow)
        .collect();
    assert!(
        rays.iter()
            .all(|ray| *ray == offset.viewpoint.shadow || ray.is_none() || *ray == exact)
    );
}

/// The candidates that are kept are the best ones, the best first, one of each set of faults, and
/// as many as asked for.
#[test]
fn the_nearest_candidates_are_kept() {
    let right = right("3c");
    let mut random = super::random(5);
    let mut all = vec![];
    for (_, faulty) in faulty("3c") {
        for _ in 0..3 {
            let knobs = faulty.knobs(&right);
            all.push(Candidate {
                recipe: faulty,
                error: 10.0 * random(),
                knobs,
            });
        }
    }
    let kinds = all.len() / 3;
    for most in [1, 5, kinds, kinds + 4] {
        let kept = nearest(all.clone(), &right, most);
        assert_eq!(kept.len(), most.min(kinds));
        assert!(kept.is_sorted_by(|a, b| a.rank() <= b.rank()));
        for candidate in &all {
            let faults = candidate.recipe.faults(&right);
            let same = kept
                .iter()
                .find(|kept| kept.recipe.faults(&right) == faults);
            let better = same.or(kept.last().filter(|_| kept.len() == most));
            assert!(better.expect("some").rank() <= candidate.rank());
        }
    }
}

/// A knob more must explain more: of two that are as near, the simpler is the better one, and one
/// that is a fifth nearer is worth a knob.
#[test]
fn simpler_is_better() {
    let candidate = |error, knobs| Candidate {
        recipe: right("3c"),
        error,
        knobs,
    };
    for error in [0.0, 0.1, 3.0, 20.0] {
        assert!(candidate(error, 1).rank() < candidate(error, 2).rank());
        assert!(candidate(error, 1).rank() < candidate(error * 1.1, 1).rank() || error == 0.0);
    }
    for error in [1.0, 20.0] {
        assert!(candidate(error, 1).rank() < candidate(error / 1.15, 2).rank());
        assert!(candidate(error, 1).rank() > candidate(error / 1.25, 2).rank());
        assert!(candidate(error, 0).rank() > candidate(error / 1.6, 2).rank());
    }
}

/// The horizontal angle may be what the vertical one should be: that one is tried as it is.
#[test]
fn the_field_of_view_of_the_width_is_tried() {
    let right = right("3c");
    for (width, height) in [(72, 48), (48, 72), (128, 32)] {
        let picture = Picture::black(size(width, height));
        let found = changes(&whole(&picture, &Lossless), &right, &right).expect("viewpoints");
        let half = |degrees: f64| (degrees / 2.0).to_radians().tan();
        let is_it = |recipe: &Recipe| {
            let across = half(recipe.viewpoint.fov) * f64::from(width) / f64::from(height);
            (across - half(60.0)).abs() < 1e-12
        };
        assert_eq!(found.iter().filter(|recipe| is_it(recipe)).count(), 1);
    }
}
