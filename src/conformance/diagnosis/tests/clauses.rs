//! What a picture shows, what it would show, and what it says nothing of.

use super::{everything, picture, right, size, turned, whole};
use crate::conformance::diagnosis::Code;
use crate::conformance::diagnosis::clauses::{Said, said, with};
use crate::conformance::diagnosis::evidence::{Evidence, distance};
use crate::conformance::diagnosis::loss::Lossless;
use crate::conformance::diagnosis::recipe::Recipe;
use crate::conformance::diagnosis::surface::Region;
use crate::picture::Picture;

const FIGURES: [&str; 5] = ["1", "2a", "2b", "3a", "3c"];

/// The clauses that pictures can show.
const CLAUSES: [&str; 19] = [
    "1.1", "1.2", "1.3", "2.1", "2.2", "2.3", "3.1", "3.2", "3.3", "4.1", "4.2", "4.3", "E.1",
    "E.2", "E.3", "E.4", "E.5", "E.6", "E.7",
];

const SIZE: (u32, u32) = (120, 80);

/// What the picture of a recipe says.
fn says(recipe: &Recipe, expected: &Recipe, shows_t_max: bool) -> Said {
    let drawn = picture(recipe, size(SIZE.0, SIZE.1));
    said(&whole(&drawn, &Lossless), recipe, expected, shows_t_max).expect("viewpoints")
}

/// What a right figure cannot show, because it has no such thing: Figure 1 no light but the eye and
/// no byte above 255, Figures 1 and 2 no shadow, 2(a) no clamp, the others nothing that wraps, 3(a)
/// no shadow ray without acne, and 3(c) none with it.
#[test]
fn a_right_figure_shows_what_it_has() {
    for (figure, has_not) in [
        (
            "1",
            &[
                "2.1", "2.2", "2.3", "3.1", "3.2", "3.3", "4.1", "4.2", "4.3",
            ][..],
        ),
        ("2a", &["3.3", "4.1", "4.2", "4.3", "E.4"]),
        ("2b", &["3.2", "4.1", "4.2", "4.3", "E.4"]),
        ("3a", &["3.2", "4.3", "E.4"]),
        ("3c", &["3.2", "4.2", "E.4"]),
    ] {
        let right = right(figure);
        for shows_t_max in [false, true] {
            let said = says(&right, &right, shows_t_max);
            let (shown, not_shown): (Vec<&str>, Vec<&str>) = CLAUSES
                .into_iter()
                .partition(|clause| !has_not.contains(clause) && (*clause != "E.5" || shows_t_max));
            assert_eq!(said.shown, shown, "{figure}");
            let never = ["5.1", "5.2", "E.8"];
            assert!(never.iter().all(|clause| said.not_shown.contains(clause)));
            let others = said.not_shown.into_iter();
            let others: Vec<&str> = others.filter(|clause| !never.contains(clause)).collect();
            assert_eq!(others, not_shown, "{figure}");
        }
    }
}

/// The faults that a right figure would not show.
#[test]
fn faults_that_would_not_show() {
    let light = [
        Code::CosineUnclamped,
        Code::NoFalloff,
        Code::LinearFalloff,
        Code::WrongPower,
        Code::ExtraPi,
        Code::Mirrored,
    ];
    let film = [Code::Wrapped, Code::Saturated, Code::Clamped];
    let shadow = [
        Code::NoShadow,
        Code::Acne,
        Code::OffsetTooLarge,
        Code::ShadowShifted,
    ];
    for (figure, sets) in [
        ("1", &[&film[..], &shadow, &light][..]),
        ("2a", &[&film[..1], &shadow]),
        // Bytes stop at 0 too.
        ("2b", &[&film[1..], &shadow, &light[..1]]),
        // What is dark in the shadow's place hides the cosines below 0.
        ("3a", &[&film[1..], &[Code::Acne], &light[..1]]),
        ("3c", &[&film[1..], &light[..1]]),
    ] {
        let right = right(figure);
        let hidden = sets.concat();
        let hidden: Vec<Code> = Code::ALL
            .into_iter()
            .filter(|code| hidden.contains(code))
            .collect();
        assert_eq!(says(&right, &right, true).invisible, hidden, "{figure}");
    }
}

/// A fault breaks its clause: that is neither shown nor left open; and a fault that is there is not
/// invisible.
#[test]
fn what_is_broken_is_not_shown() {
    for figure in ["2a", "3a", "3c"] {
        let right = right(figure);
        let hidden = says(&right, &right, true).invisible;
        for code in Code::ALL {
            let Some(faulty) = with(&right, code).filter(|faulty| *faulty != right) else {
                continue;
            };
            let said = says(&faulty, &right, true);
            let words = format!("{figure} {code:?}: {said:?}");
            assert!(!said.invisible.contains(&code), "{words}");
            if !hidden.contains(&code) {
                assert!(!said.shown.contains(&code.clause()), "{words}");
                assert!(!said.not_shown.contains(&code.clause()), "{words}");
            }
        }
    }
}

/// Acne is shown where it should be and is; where there is none, how it goes away. Acne that should not
/// be is a fault of both clauses.
#[test]
fn acne_is_shown_where_it_should_be() {
    let [speckled, clean] = ["3a", "3c"].map(right);
    let has = |clauses: &[&str], clause| clauses.contains(&clause);
    for (recipe, expected, shown, not_shown) in [
        (&speckled, &speckled, Some("4.2"), Some("4.3")),
        (&clean, &clean, Some("4.3"), Some("4.2")),
        (&speckled, &clean, None, None),
        (&clean, &speckled, Some("4.3"), Some("4.2")),
    ] {
        let said = says(recipe, expected, true);
        for clause in ["4.2", "4.3"] {
            let words = format!("{clause}: {said:?}");
            assert_eq!(has(&said.shown, clause), shown == Some(clause), "{words}");
            assert_eq!(
                has(&said.not_shown, clause),
                not_shown == Some(clause),
                "{words}"
            );
        }
    }
}

/// One fault is made, and no other; it is as wrong as its name says.
#[test]
fn faults_are_made_one_by_one() {
    for figure in FIGURES {
        let right = right(figure);
        let casts = right.viewpoint.shadow.is_some();
        for code in Code::ALL {
            let made = with(&right, code);
            let can = match code {
                Code::Acne | Code::OtherFigure | Code::OtherScene => false,
                Code::NoShadow | Code::OffsetTooLarge | Code::ShadowShifted => casts,
                Code::NoFalloff | Code::LinearFalloff | Code::WrongPower | Code::ExtraPi => {
                    !right.light_at_eye
                }
                _ => true,
            };
            assert_eq!(made.is_some(), can, "{figure} {code:?}");
            let Some(faulty) = made.filter(|faulty| *faulty != right) else {
                continue;
            };
            let code = if code == Code::Saturated {
                Code::Clamped
            } else {
                code
            };
            let mut faults = faulty.faults(&right);
            // Without a shadow there is no acne either.
            faults.retain(|fault| *fault != Code::OtherFigure || figure != "3a");
            assert_eq!(faults, [code], "{figure}");
            assert!(faulty.viewpoint.shadow.unwrap_or_default().offset >= 0.0);
        }
    }
}

/// Eight pixels show a fault in which it makes a difference of more than two levels; seven do not,
/// nor does any number of pixels with a difference of two.
#[test]
fn eight_pixels_show_a_fault() {
    let size = size(SIZE.0, SIZE.1);
    let right = right("3c");
    let black = Picture::black(size);
    let whole = whole(&black, &Lossless);
    let drawn = whole.drawn(&right).expect("a viewpoint");
    let mut seen = 0;
    for code in [
        Code::ShadowShifted,
        Code::WrongPower,
        Code::PlaneMissing,
        Code::WrongBackground,
        Code::LinearFalloff,
    ] {
        let faulty = with(&right, code).expect("a fault");
        let wrong = whole.drawn(&faulty).expect("a viewpoint");
        let places = |by: &dyn Fn(u8) -> bool| -> Vec<Region> {
            let pixels = everything(size).pixels().zip(drawn.iter().zip(&wrong));
            let differ = pixels.filter(|(_, (a, b))| by(distance(a.rgb, b.rgb)));
            let one = |((left, top), _)| Region {
                left,
                top,
                width: 1,
                height: 1,
            };
            differ.map(one).collect()
        };
        let is_visible = |regions: &[Region]| {
            let part = Evidence::new(&black, regions.to_vec(), &Lossless);
            let said = said(&part, &right, &right, false).expect("viewpoints");
            !said.invisible.contains(&code)
        };
        for levels in [3, 4, 20] {
            let few = places(&|by| by == levels);
            if few.len() >= 8 {
                seen += 1;
                assert!(is_visible(&few[..8]) && !is_visible(&few[..7]), "{code:?}");
            }
        }
        assert!(!is_visible(&places(&|by| by <= 2)), "{code:?}");
        assert!(is_visible(&places(&|by| by > 2)), "{code:?}");
    }
    assert!(seen >= 3, "{seen}");
}

/// A figure upside down shows what else holds.
#[test]
fn other_clauses_are_still_shown() {
    let right = right("3c");
    let wrong = turned(&right, |r| r.viewpoint.upside_down = true);
    let said = says(&wrong, &right, false);
    let all = says(&right, &right, false).shown.into_iter();
    let others: Vec<&str> = all.filter(|clause| *clause != "E.1").collect();
    assert_eq!(said.shown, others);
}
