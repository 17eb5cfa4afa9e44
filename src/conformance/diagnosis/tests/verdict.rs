//! From a picture to what is said of it.

use super::{
    Coarse, changed, codes, judged, lossy, mixed, picture, random, right, size, turned, whole,
};
use crate::conformance::diagnosis::clauses::with;
use crate::conformance::diagnosis::evidence::distance;
use crate::conformance::diagnosis::finding::Estimate;
use crate::conformance::diagnosis::loss::{Loss, Lossless};
use crate::conformance::diagnosis::recipe::{Recipe, Rounding, ShadowRay};
use crate::conformance::diagnosis::search::search;
use crate::conformance::diagnosis::verdict::{is_better, with_t_max};
use crate::conformance::diagnosis::{Code, Margin, Sampling, Verdict};
use crate::picture::Picture;

/// A fault's places are those where the picture without it is another.
#[test]
fn places_of_a_fault_are_what_it_changes() {
    let size = size(96, 64);
    for code in [
        Code::Mirrored,
        Code::ExtraPi,
        Code::WrongBackground,
        Code::NormalFlipped,
    ] {
        let right = right("3c");
        let faulty = with(&right, code).expect("a fault");
        let [drawn, of] = [right, faulty].map(|recipe| picture(&recipe, size));
        let diagnosis = judged(&of, "3c");
        assert_eq!(codes(&diagnosis), [code]);
        let pairs = drawn.bytes().chunks(3).zip(of.bytes().chunks(3));
        let differ = pairs
            .enumerate()
            .filter(|(_, (a, b))| (0..3).any(|c| a[c].abs_diff(b[c]) > 2));
        let places: Vec<usize> = differ.map(|(at, _)| at).collect();
        assert_eq!(diagnosis.findings[0].places, places, "{code:?}");
        let region = diagnosis.findings[0].region.expect("some pixels");
        assert!(
            places
                .iter()
                .all(|&at| region.pixels().any(|(x, y)| at as u32 == y * 96 + x))
        );
        assert!(!diagnosis.invisible.contains(&code));
        assert_eq!(diagnosis.findings[0].clause(), code.clause());
        // The next explanation is one without it.
        assert!(!diagnosis.margin.runner_up.contains(&code), "{code:?}");
    }
}

/// Numbers are told as they were drawn.
#[test]
fn numbers_are_told() {
    type Turn = fn(&mut Recipe);
    let cases: [(Turn, Code, f64); 2] = [
        (|r| r.viewpoint.fov = 45.3, Code::WrongFov, 45.3),
        (
            |r| {
                r.power = 0.4;
                r.viewpoint.sampling = Sampling::Average;
            },
            Code::WrongPower,
            40.0,
        ),
    ];
    for (turn, code, number) in cases {
        let wrong = turned(&right("3c"), turn);
        let diagnosis = judged(&picture(&wrong, size(96, 64)), "3c");
        assert_eq!(codes(&diagnosis), [code]);
        assert_eq!(diagnosis.conventions.sampling, wrong.viewpoint.sampling);
        let [(_, Estimate::Number(told))] = diagnosis.findings[0].estimates[..] else {
            panic!("{diagnosis:?}");
        };
        assert!((told / number - 1.0).abs() < 0.01, "{told}, not {number}");
    }
}

/// Three faults at once are found as three.
#[test]
fn three_faults_are_found() {
    let codes = [Code::Mirrored, Code::UpsideDown, Code::RedBlueSwapped];
    let expected = right("3c");
    let wrong = codes
        .into_iter()
        .fold(expected, |wrong, code| with(&wrong, code).expect("a fault"));
    let picture = picture(&wrong, size(64, 48));
    let (candidates, ..) = search(&picture, &expected, &[]).expect("viewpoints");
    let mut faults = candidates[0].recipe.faults(&expected);
    faults.sort_unstable();
    let mut codes = codes.to_vec();
    codes.sort_unstable();
    assert_eq!(faults, codes);
}

/// Of two faults either alone may leave a picture as far from this one as it was, or further: nobody
/// comes nearer by one step.
#[test]
fn pairs_are_found_of_which_one_alone_explains_nothing() {
    type Turn = fn(&mut Recipe);
    let pairs: [(&str, Turn, Turn, [Code; 2]); 2] = [
        (
            "3c",
            |r| r.falloff = 0,
            |r| r.swapped = true,
            [Code::NoFalloff, Code::RedBlueSwapped],
        ),
        (
            "2a",
            |r| r.falloff = 1,
            |r| r.viewpoint.mirrored = true,
            [Code::LinearFalloff, Code::Mirrored],
        ),
    ];
    let size = size(96, 64);
    for (figure, one, other, pair) in pairs {
        let expected = right(figure);
        let both = turned(&turned(&expected, one), other);
        let drawn = picture(&both, size);
        let seen = whole(&drawn, &Lossless);
        let error = |recipe: &Recipe| seen.error(recipe).expect("a viewpoint");
        for turn in [one, other] {
            let alone = turned(&expected, turn);
            assert!(1.2 * error(&alone) > error(&expected), "{pair:?}");
        }
        let mut found = codes(&judged(&drawn, figure));
        found.sort_unstable();
        assert_eq!(found, pair);
    }
}

/// A fault explains a picture better than its absence where it is nearer by a fifth in the pixels that
/// it changes: five in nine of them, if the others are as without it.
#[test]
fn a_fault_must_explain_more_than_it_spoils() {
    let right = right("3c");
    for code in [Code::Mirrored, Code::WrongBackground, Code::PlaneMissing] {
        let faulty = with(&right, code).expect("a fault");
        let [plain, wrong] = [right, faulty].map(|recipe| picture(&recipe, size(96, 64)));
        for (part, is_one) in [(0.0, false), (0.53, false), (0.6, true), (1.0, true)] {
            let mixed = mixed(&plain, &wrong, part, 6);
            let evidence = whole(&mixed, &Lossless);
            let found = is_better(&evidence, &faulty, &right).expect("viewpoints");
            assert_eq!(found, is_one, "{code:?} {part}");
        }
        // What changes nothing explains nothing.
        let evidence = whole(&plain, &Lossless);
        assert!(!is_better(&evidence, &right, &right).expect("viewpoints"));
    }
}

/// Which largest parameter a picture was drawn with is told where both would not look the same.
#[test]
fn the_largest_parameter_is_told_where_it_shows() {
    let low = right("1");
    for (height, is_shown) in [(310, true), (60, false)] {
        for drawn in [low, low.with_other_t_max()] {
            let picture = picture(&drawn, size(130, height));
            let evidence = whole(&picture, &Lossless);
            for start in [low, low.with_other_t_max()] {
                let (found, shows) = with_t_max(&evidence, start).expect("viewpoints");
                assert_eq!(shows, is_shown);
                assert_eq!(found, if is_shown { drawn } else { start });
            }
            // Neither is a fault, so neither runs up to the other.
            let diagnosis = judged(&picture, "1");
            assert_eq!(diagnosis.verdict, Verdict::Conforms);
            assert!(!diagnosis.margin.runner_up.is_empty());
        }
    }
}

/// What cannot be told from a clamp is named beside it; no other fault has another name.
#[test]
fn a_clamp_may_be_a_conversion_that_saturates() {
    let clamped = judged(&picture(&right("2b"), size(96, 64)), "2a");
    assert_eq!(codes(&clamped), [Code::Clamped]);
    assert_eq!(clamped.findings[0].or, Some(Code::Saturated));
    let mirrored = with(&right("3c"), Code::Mirrored).expect("a fault");
    let mirrored = judged(&picture(&mirrored, size(96, 64)), "3c");
    assert_eq!(mirrored.findings[0].or, None);
}

/// Another figure's places are where it is another.
#[test]
fn places_of_another_figure() {
    let [claimed, drawn] = ["3c", "1"].map(|figure| picture(&right(figure), size(96, 64)));
    let diagnosis = judged(&drawn, "3c");
    assert_eq!(codes(&diagnosis), [Code::OtherFigure]);
    let pairs = claimed.bytes().as_chunks::<3>().0.iter();
    let pairs = pairs.zip(drawn.bytes().as_chunks::<3>().0).enumerate();
    let differ = pairs.filter(|(_, (a, b))| distance(**a, **b) > 2);
    let places: Vec<usize> = differ.map(|(at, _)| at).collect();
    assert_eq!(diagnosis.findings[0].places, places);
}

/// Two findings come with the wider one first.
#[test]
fn the_widest_fault_is_first() {
    let wrong = turned(&right("3c"), |r| {
        r.colors[0] = [0.1, 0.8, 0.4];
        r.background = [0.9, 0.9, 0.2];
    });
    let diagnosis = judged(&picture(&wrong, size(120, 80)), "3c");
    assert_eq!(
        codes(&diagnosis),
        [Code::WrongBackground, Code::WrongColour]
    );
    assert!(diagnosis.findings[0].pixels > diagnosis.findings[1].pixels);
}

/// What nothing explains is unknown, or another scene where the colours are the lab's.
#[test]
fn other_pictures() {
    let size = size(96, 64);
    let mut random = random(11);
    let mut noise = || [random(), random(), random()].map(|x| (255.0 * x) as u8);
    let pixels = (0..size.pixels()).map(|_| noise()).collect();
    let noise = judged(
        &Picture::from_pixels(size, pixels).expect("all pixels"),
        "3c",
    );
    assert_eq!((noise.verdict, noise.findings.len()), (Verdict::Unknown, 0));
    let blank = judged(&Picture::black(size), "3c");
    assert_eq!((blank.verdict, blank.findings.len()), (Verdict::Unknown, 0));
    let stripes = changed(&Picture::black(size), |at, _| match at / 7 % 3 {
        0 => [200, 0, 0],
        1 => [0, 0, 200],
        _ => [127; 3],
    });
    let other = judged(&stripes, "3c");
    assert_eq!(
        (other.verdict, codes(&other)),
        (Verdict::Faults, vec![Code::OtherScene])
    );
    assert_eq!(other.findings[0].pixels, size.pixels());
}

/// A margin is a share of the other explanation's error.
#[test]
fn margins() {
    let margin = |error: f64, runner_up_error: f64| {
        let runner_up = vec![];
        Margin {
            error,
            runner_up,
            runner_up_error,
        }
        .share()
    };
    assert_eq!(
        (margin(0.0, 0.0), margin(3.0, 3.0), margin(4.0, 2.0)),
        (0.0, 0.0, 0.0)
    );
    assert!((margin(1.0, 4.0) - 0.75).abs() < 0.001 && margin(0.0, 50.0) > 0.9999);
    assert!((margin(0.001, 0.003) - 0.5).abs() < 1e-9);
    let names = [Verdict::Conforms, Verdict::Faults, Verdict::Unknown].map(Verdict::name);
    assert_eq!(names, ["conforms", "faults", "unknown"]);
    for sampling in Sampling::ALL {
        let name = sampling.name();
        assert_eq!(name.starts_with("average"), sampling.is_average());
        let same = Sampling::ALL
            .into_iter()
            .filter(|other| other.name() == name);
        assert_eq!(same.count(), 1);
    }
    // A right picture is further from every fault than from itself, in whatever convention.
    for sampling in [Sampling::Corner, Sampling::Center, Sampling::Average] {
        for rounding in [Rounding::Truncate, Rounding::Nearest] {
            let right = turned(&right("3c"), |r| {
                (r.viewpoint.sampling, r.rounding) = (sampling, rounding);
            });
            let diagnosis = judged(&picture(&right, size(96, 64)), "3c");
            assert_eq!(
                (diagnosis.verdict, diagnosis.margin.error),
                (Verdict::Conforms, 0.0)
            );
            assert!(!diagnosis.margin.runner_up.is_empty() && diagnosis.margin.share() > 0.8);
        }
    }
}

/// Of several losses it is the one that a picture had.
#[test]
fn the_loss_is_found() {
    let (expected, size) = (right("3c"), size(96, 64));
    let losses: [&dyn Loss; 2] = [&Coarse(3), &Coarse(8)];
    for (number, loss) in losses.iter().enumerate() {
        for sampling in [Sampling::Corner, Sampling::Center] {
            let recipe = turned(&expected, |r| r.viewpoint.sampling = sampling);
            let picture = lossy(&picture(&recipe, size), *loss);
            let found = search(&picture, &expected, &losses).expect("viewpoints");
            assert_eq!(
                (found.2, found.1.loss.tolerance()),
                (number, loss.tolerance())
            );
        }
    }
}

/// Where shadow rays start or end elsewhere, that is told in numbers, and no more than a pixel's worth
/// is nothing.
#[test]
fn displaced_shadows() {
    let expected = right("3c");
    let of = |ray: ShadowRay| {
        let recipe = turned(&expected, |r| r.viewpoint.shadow = Some(ray));
        judged(&picture(&recipe, size(160, 107)), "3c")
    };
    let exact = ShadowRay::default();
    let offset = of(ShadowRay {
        offset: 0.3,
        ..exact
    });
    assert_eq!(codes(&offset), [Code::OffsetTooLarge]);
    let shift = of(ShadowRay {
        shift: [0.4, -0.3],
        ..exact
    });
    assert_eq!(codes(&shift), [Code::ShadowShifted]);
    let light = of(ShadowRay {
        light: [2.0, -1.5],
        ..exact
    });
    assert_eq!(codes(&light), [Code::ShadowShifted]);
    for (diagnosis, name, by) in [
        (&shift, "shift", [0.4, -0.3]),
        (&light, "light_shift", [2.0, -1.5]),
    ] {
        let [(told, Estimate::Numbers(numbers))] = &diagnosis.findings[0].estimates[..] else {
            panic!("{diagnosis:?}");
        };
        assert_eq!(*told, name);
        for (number, by) in numbers.iter().zip(by) {
            assert!((number - by).abs() < 0.1 * f64::abs(by), "{numbers:?}");
        }
    }
    let [("offset", Estimate::Number(length))] = offset.findings[0].estimates[..] else {
        panic!("{offset:?}");
    };
    assert!((length - 0.3).abs() < 0.03, "{length}");
    assert_eq!(
        of(ShadowRay {
            offset: 0.001,
            ..exact
        })
        .verdict,
        Verdict::Conforms
    );
    // Shadows of no object.
    let none = turned(&expected, |r| r.viewpoint.has_plane = false);
    let diagnosis = judged(&picture(&none, size(96, 64)), "3c");
    assert_eq!(codes(&diagnosis), [Code::PlaneMissing]);
}

/// What runs up to an explanation lacks one of its faults: one more of them would explain no less.
#[test]
fn a_runner_up_lacks_a_fault() {
    for figure in ["2a", "3c"] {
        let expected = right(figure);
        for code in Code::ALL {
            let Some(faulty) = with(&expected, code) else {
                continue;
            };
            let diagnosis = judged(&picture(&faulty, size(96, 64)), figure);
            let found = codes(&diagnosis);
            let lacks = |code: &Code| !diagnosis.margin.runner_up.contains(code);
            assert!(
                found.is_empty() || found.iter().any(lacks),
                "{figure} {code:?}"
            );
        }
    }
}
