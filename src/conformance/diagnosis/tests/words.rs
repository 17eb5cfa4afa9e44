//! What is said of a fault, and of pictures that nothing explains.

use super::{changed, picture, right, size, turned};
use crate::conformance::diagnosis::acne::Speckle;
use crate::conformance::diagnosis::clauses::with;
use crate::conformance::diagnosis::finding::{Estimate, acne, described};
use crate::conformance::diagnosis::loss::{Loss, Lossless};
use crate::conformance::diagnosis::palette::{is_blank, is_the_labs};
use crate::conformance::diagnosis::recipe::{Cosine, Recipe, ShadowRay};
use crate::conformance::diagnosis::{Code, Severity};
use crate::picture::Picture;

/// The estimates of a fault and its sentence.
fn said(code: Code, turn: impl Fn(&mut Recipe)) -> (String, Vec<(&'static str, Estimate)>) {
    let expected = right("3c");
    described(code, &turned(&expected, turn), &expected)
}

fn one(code: Code, turn: impl Fn(&mut Recipe)) -> (String, &'static str, Estimate) {
    let (words, estimates) = said(code, turn);
    let [(name, estimate)] = &estimates[..] else {
        panic!("{estimates:?}");
    };
    (words, name, estimate.clone())
}

/// Numbers have three digits, of which the last is rounded.
#[test]
fn numbers_have_three_digits() {
    for (drawn, told) in [
        (45.04321, "45"),
        (45.06, "45.1"),
        (7.12345, "7.12"),
        (99.96, "100"),
        (101.6, "102"),
        (9.996, "10"),
    ] {
        let (words, name, estimate) = one(Code::WrongFov, |r| r.viewpoint.fov = drawn);
        assert!(words.contains(&format!(" {told} degrees")), "{words}");
        let told = told.parse().expect("a number");
        assert_eq!((name, estimate), ("fov", Estimate::Number(told)));
    }
    for offset in [0.000_123_456, 0.001_234_5, 0.012_345, 0.123_45, 1.2345] {
        let (_, _, estimate) = one(Code::OffsetTooLarge, |r| {
            r.viewpoint.shadow = Some(ShadowRay {
                offset,
                ..ShadowRay::default()
            });
        });
        let Estimate::Number(told) = estimate else {
            panic!("{estimate:?}");
        };
        assert!((told - offset).abs() <= 0.005 * offset && told != offset);
    }
}

/// What a sentence says in numbers is what the estimates say.
#[test]
fn sentences_tell_the_estimates() {
    for figure in ["1", "2a", "2b", "3c"] {
        let right = right(figure);
        for (code, faulty) in Code::ALL
            .into_iter()
            .filter_map(|code| Some((code, with(&right, code)?)))
        {
            let (words, estimates) = described(code, &faulty, &right);
            assert!(words.len() > 10, "{words}");
            for (name, estimate) in estimates {
                let numbers = match estimate {
                    Estimate::Number(number) => vec![number],
                    Estimate::Numbers(numbers) => numbers,
                    Estimate::Name(of) => {
                        let is_told = of.split(" and ").all(|name| words.contains(name));
                        let is_kind = ["cosine", "gamma"].contains(&name);
                        assert!(is_told || is_kind, "{words}: {of}");
                        continue;
                    }
                };
                for number in numbers {
                    assert!(words.contains(&number.to_string()), "{words}: {number}");
                }
            }
        }
    }
}

/// Faults of a kind are told apart.
#[test]
fn kinds_are_told_apart() {
    let name = |code, turn: fn(&mut Recipe)| one(code, turn).2;
    let is = |kind| Estimate::Name(kind);
    let cosine = |cosine| one(Code::CosineUnclamped, |r| r.cosine = cosine).2;
    assert_eq!(cosine(Cosine::Signed), is("signed"));
    assert_eq!(cosine(Cosine::Absolute), is("absolute"));
    for (flipped, which) in [
        ([true; 2], "sphere and plane"),
        ([true, false], "sphere"),
        ([false, true], "plane"),
    ] {
        assert_eq!(
            one(Code::NormalFlipped, |r| r.flipped = flipped).2,
            is(which)
        );
    }
    assert_eq!(name(Code::OtherFigure, |r| r.light_at_eye = true), is("1"));
    assert_eq!(name(Code::OtherFigure, |_| {}), is("3c"));
    for (film, figure) in [(crate::Film::Wrap, "2a"), (crate::Film::Clamp, "2b")] {
        let turn = |r: &mut Recipe| (r.viewpoint.shadow, r.film) = (None, film);
        assert_eq!(one(Code::OtherFigure, turn).2, is(figure));
    }
    let (_, name, _) = one(Code::WrongPower, |r| {
        (r.light_at_eye, r.power) = (true, 0.5);
    });
    assert_eq!(name, "factor");
    let (_, name, estimate) = one(Code::WrongPower, |r| r.power = 0.5);
    assert_eq!((name, estimate), ("power", Estimate::Number(50.0)));
    let displaced = |ray| one(Code::ShadowShifted, |r| r.viewpoint.shadow = Some(ray));
    let exact = ShadowRay::default();
    let (_, name, estimate) = displaced(ShadowRay {
        shift: [0.5, -0.25],
        ..exact
    });
    assert_eq!(
        (name, estimate),
        ("shift", Estimate::Numbers(vec![0.5, -0.25]))
    );
    let (_, name, estimate) = displaced(ShadowRay {
        light: [0.0, 2.0],
        ..exact
    });
    assert_eq!(
        (name, estimate),
        ("light_shift", Estimate::Numbers(vec![0.0, 2.0]))
    );
    let (_, estimates) = said(Code::WrongColour, |r| r.colors[0] = [0.5; 3]);
    let sphere = Estimate::Numbers(vec![0.5; 3]);
    assert_eq!(estimates, [("object", is("sphere")), ("sphere", sphere)]);
}

/// Every fault's clause is one of the specification.
#[test]
fn clauses_are_in_the_specification() {
    let spec = include_str!("../../../../docs/spec.md");
    for code in Code::ALL {
        let heading = format!("\n### {} ", code.clause());
        assert!(spec.contains(&heading), "{code:?}");
    }
}

/// Acne is told as falsely black pixels, or as noise where most have a part of their light and pixels
/// may be averages.
#[test]
fn acne_is_told_by_its_look() {
    let speckle = |partly| Speckle {
        lit: 400,
        dark: 90,
        mean: 0.744,
        partly,
        roughness: 0.5,
    };
    for (partly, may_average, is_noise) in [
        (201, true, true),
        (201, false, false),
        (200, true, false),
        (199, false, false),
    ] {
        let (words, estimates) = acne([None, Some(speckle(partly))], may_average);
        let told = [
            ("object", Estimate::Name("plane")),
            ("plane", Estimate::Number(0.256)),
            ("averaged", Estimate::Name("plane")),
        ];
        assert_eq!(estimates, told[..if is_noise { 3 } else { 2 }]);
        assert!(
            words.contains("25.6 %") && words.contains("plane"),
            "{words}"
        );
        assert_eq!(words.contains("noise"), is_noise, "{words}");
        assert_eq!(words.contains("falsely black"), !is_noise, "{words}");
    }
}

/// Only a colour and the field of view are as one likes: the rest is wrong.
#[test]
fn matters_of_taste_are_warnings() {
    let warnings = Code::ALL
        .into_iter()
        .filter(|code| code.severity() == Severity::Warning);
    let warnings: Vec<&str> = warnings.map(Code::name).collect();
    assert_eq!(warnings, ["WRONG_COLOUR", "WRONG_BACKGROUND", "WRONG_FOV"]);
    assert_eq!(
        [Severity::Warning, Severity::Error].map(Severity::name),
        ["warning", "error"]
    );
}

/// Every fault has a fact and an advice of its own, or shares both with its like.
#[test]
fn every_fault_has_its_words() {
    for (number, code) in Code::ALL.into_iter().enumerate() {
        assert!(
            code.fact().len() > 10 && code.advice().len() > 10,
            "{code:?}"
        );
        for other in &Code::ALL[..number] {
            let is_same = code.advice() == other.advice();
            assert_eq!(code.fact() == other.fact(), is_same, "{code:?} {other:?}");
            assert_ne!(code.name(), other.name());
        }
    }
}

/// A picture of so many pixels of each kind in a hundred, and the rest of the second.
fn painted(parts: &[([u8; 3], usize)], rest: [u8; 3]) -> Picture {
    let mut pixels = vec![];
    for &(color, count) in parts {
        pixels.extend(vec![color; count]);
    }
    pixels.resize(1000, rest);
    Picture::from_pixels(size(40, 25), pixels).expect("all pixels")
}

const GREY: [u8; 3] = [127; 3];
const RED: [u8; 3] = [200, 0, 0];
const BLUE: [u8; 3] = [2, 0, 90];
const GREEN: [u8; 3] = [0, 90, 0];

struct Lossy;

impl Loss for Lossy {
    fn degrade(&self, _: u32, _: u32, _: &mut [[u8; 3]]) {}

    fn tolerance(&self) -> u8 {
        4
    }
}

/// The lab's colours are one grey, pure red, pure blue and black; four strays in a hundred are none,
/// and of colour there are five.
#[test]
fn palettes() {
    let is_labs = |parts: &[([u8; 3], usize)], rest| is_the_labs(&painted(parts, rest), &Lossless);
    for figure in ["1", "2a", "2b", "3c"] {
        let drawn = picture(&right(figure), size(60, 40));
        assert!(is_the_labs(&drawn, &Lossless) && is_the_labs(&drawn, &Lossy));
        assert!(!is_blank(&drawn));
        let green = changed(&drawn, |_, [red, green, blue]| {
            [green, red.max(blue), green]
        });
        assert!(!is_the_labs(&green, &Lossless));
    }
    for stray in [GREEN, [200, 60, 0], [60, 60, 200], [90; 3]] {
        assert!(
            is_labs(&[(RED, 200), (BLUE, 100), (stray, 40), ([0; 3], 100)], GREY),
            "{stray:?}"
        );
        assert!(
            !is_labs(&[(RED, 200), (BLUE, 100), (stray, 41), ([0; 3], 100)], GREY),
            "{stray:?}"
        );
    }
    assert!(is_labs(&[(RED, 25), (BLUE, 25), ([0; 3], 300)], GREY));
    assert!(!is_labs(&[(RED, 25), (BLUE, 24), ([0; 3], 300)], GREY));
    assert!(!is_labs(&[([0; 3], 300)], GREY) && is_labs(&[], RED) && is_labs(&[(GREY, 500)], RED));
    // Greys four levels apart are one; with a tolerance of four more, twelve.
    for (grey, lossless, lossy) in [
        (131, true, true),
        (132, false, true),
        (139, false, true),
        (140, false, false),
    ] {
        let drawn = painted(&[(RED, 200), ([grey; 3], 300)], GREY);
        assert_eq!(is_the_labs(&drawn, &Lossless), lossless, "{grey}");
        assert_eq!(is_the_labs(&drawn, &Lossy), lossy, "{grey}");
    }
    // Black may be two levels bright, or six.
    for (level, lossless, lossy) in [
        (2, true, true),
        (3, false, true),
        (6, false, true),
        (7, false, false),
    ] {
        let drawn = painted(&[(RED, 200), ([level; 3], 300)], GREY);
        assert_eq!(is_the_labs(&drawn, &Lossless), lossless, "{level}");
        assert_eq!(is_the_labs(&drawn, &Lossy), lossy, "{level}");
    }
    for (tint, lossless, lossy) in [
        (2, true, true),
        (4, true, true),
        (5, false, true),
        (12, false, true),
        (13, false, false),
    ] {
        let drawn = painted(&[([200, 0, tint], 200)], GREY);
        assert_eq!(is_the_labs(&drawn, &Lossless), lossless, "{tint}");
        assert_eq!(is_the_labs(&drawn, &Lossy), lossy, "{tint}");
    }
}

/// A picture is blank where all but one pixel in two hundred are the same.
#[test]
fn blanks() {
    assert!(is_blank(&painted(&[], RED)));
    assert!(is_blank(&painted(&[(BLUE, 4)], RED)));
    assert!(!is_blank(&painted(&[(BLUE, 5)], RED)));
}
