//! Acne in whole pictures.

use super::{
    Coarse, changed, codes, judged, judged_with, picture, random, right, size, turned, whole,
};
use crate::conformance::diagnosis::clauses::with;
use crate::conformance::diagnosis::finding::Estimate;
use crate::conformance::diagnosis::loss::{Loss, Lossless};
use crate::conformance::diagnosis::recipe::Recipe;
use crate::conformance::diagnosis::surface::Object;
use crate::conformance::diagnosis::{Code, Sampling, Verdict};
use crate::picture::Picture;

/// A picture of which a part of an object's lit pixels is black, and the places of those.
fn speckled(recipe: &Recipe, wide: u32, objects: [bool; 2], part: f64) -> (Picture, Vec<usize>) {
    let size = size(wide, wide * 2 / 3);
    let right = picture(recipe, size);
    let drawn = whole(&right, &Lossless).drawn(recipe).expect("a viewpoint");
    let mut random = random(9);
    let black: Vec<bool> = drawn
        .iter()
        .map(|pixel| {
            let may = pixel.object.index().is_some_and(|index| objects[index]);
            may && pixel.is_lit && random() < part
        })
        .collect();
    let places =
        (0..drawn.len()).filter(|&at| black[at] && drawn[at].rgb.into_iter().max() > Some(2));
    let places = places.collect();
    let speckled = changed(&right, |at, rgb| if black[at] { [0; 3] } else { rgb });
    (speckled, places)
}

/// Acne is where light should be and is not, on the objects that have it; the part of their pixels
/// is told.
fn acne_is_found(objects: [bool; 2], which: &'static str, part: f64) {
    let (picture, places) = speckled(&right("3c"), 96, objects, part);
    // What is off in another way is not acne: too bright, of another hue, or on another object.
    let stray = changed(&picture, |at, [red, green, blue]| {
        let is_lit = at % 96 > 20 && green == 0 && red.max(blue) > 40 && red.max(blue) < 200;
        match at % 700 {
            5 if is_lit => [red, 9, blue],
            9 if is_lit => [red.saturating_add(9), green, blue.saturating_add(9)],
            17 if is_lit && red > 0 && !objects[1] => [0; 3],
            _ => [red, green, blue],
        }
    });
    assert!(stray != picture);
    let diagnosis = judged(&stray, "3c");
    assert_eq!(codes(&diagnosis), [Code::Acne], "{which} {part}");
    let [acne] = &diagnosis.findings[..] else {
        panic!("one")
    };
    assert_eq!(acne.places, places);
    assert_eq!(acne.pixels, places.len());
    assert_eq!(acne.estimates[0], ("object", Estimate::Name(which)));
    assert_eq!(acne.estimates.len(), 1 + which.split(" and ").count());
    for (name, estimate) in &acne.estimates[1..] {
        let Estimate::Number(rate) = estimate else {
            panic!("{estimate:?}")
        };
        assert!((rate - part).abs() < 0.1, "{name}: {rate} of {part}");
        let percent = format!("{} %", (1000.0 * rate).round() / 10.0);
        assert!(acne.message.contains(&percent), "{}", acne.message);
        assert!(acne.message.contains("are falsely black"));
    }
    assert!(!diagnosis.shown.contains(&"4.3"));
}

#[test]
fn acne_of_both_is_found() {
    acne_is_found([true; 2], "sphere and plane", 0.3);
}

#[test]
fn acne_of_the_sphere_is_found() {
    acne_is_found([true, false], "sphere", 0.8);
}

#[test]
fn acne_of_the_plane_is_found() {
    acne_is_found([false, true], "plane", 0.5);
}

/// A picture in which an object's lit pixels are averages: of so many samples each, of which a part has
/// light.
fn averaged(sampling: Sampling, object: Object, samples: u32, part: f64) -> Picture {
    let expected = turned(&right("3c"), |r| r.viewpoint.sampling = sampling);
    let size = size(80, 54);
    let drawn = whole(&Picture::black(size), &Lossless).drawn(&expected);
    let drawn = drawn.expect("a viewpoint");
    let mut random = random(12);
    let mut share = || (0..samples).filter(|_| random() < part).count() as f64 / f64::from(samples);
    let shares: Vec<f64> = drawn.iter().map(|_| share()).collect();
    changed(&picture(&expected, size), |at, rgb| {
        let is_averaged = drawn[at].object == object && drawn[at].is_lit;
        let share = if is_averaged { shares[at] } else { 1.0 };
        rgb.map(|byte| (f64::from(byte) * share) as u8)
    })
}

/// Averages of acne are acne too, and no darker colour or weaker light.
fn averaged_acne_is_acne(sampling: Sampling, loss: &dyn Loss, is_told: bool) {
    let noisy = averaged(sampling, Object::Plane, 16, 0.6);
    let diagnosis = judged_with(&noisy, loss);
    assert_eq!(codes(&diagnosis), [Code::Acne], "{diagnosis:?}");
    let averaged = ("averaged", Estimate::Name("plane"));
    let estimates = &diagnosis.findings[0].estimates;
    assert_eq!(estimates.contains(&averaged), is_told, "{diagnosis:?}");
}

#[test]
fn averaged_acne_is_acne_without_a_loss() {
    averaged_acne_is_acne(Sampling::Average, &Lossless, true);
    averaged_acne_is_acne(Sampling::Corner, &Lossless, true);
}

#[test]
fn averaged_acne_is_acne_through_a_loss() {
    averaged_acne_is_acne(Sampling::Average, &Coarse(4), true);
    // A loss makes averages too.
    averaged_acne_is_acne(Sampling::Corner, &Coarse(4), false);
}

/// Where a loss smooths speckles that are fine already, they fit a darker colour better, and are acne.
#[test]
fn fine_acne_is_acne_through_a_loss() {
    for part in [0.2, 0.5, 0.8] {
        for by in [3, 8] {
            let picture = averaged(Sampling::Corner, Object::Sphere, 64, part);
            let diagnosis = judged_with(&picture, &Coarse(by));
            assert_eq!(codes(&diagnosis), [Code::Acne], "{part} {by}");
        }
    }
}

/// What is darker without speckles has a darker colour, in whatever sampling and through a loss.
#[test]
fn darker_colours_are_no_acne() {
    let dark = turned(&right("3c"), |r| {
        r.colors[1] = [0.6, 0.0, 0.0];
        r.viewpoint.sampling = Sampling::Average;
    });
    let losses: [&dyn Loss; 2] = [&Lossless, &Coarse(4)];
    for loss in losses {
        let diagnosis = judged_with(&picture(&dark, size(80, 54)), loss);
        assert_eq!(codes(&diagnosis), [Code::WrongColour], "{diagnosis:?}");
    }
}

/// Where most pixels are black, and the others are not, what is left of the light tells its power.
#[test]
fn acne_does_not_hide_the_light() {
    let expected = right("3c");
    for code in [Code::WrongPower, Code::ExtraPi] {
        let wrong = with(&expected, code).expect("a fault");
        let mut both = [code, Code::Acne];
        both.sort_unstable();
        // Through a loss the object without acne tells it.
        let (picture, _) = speckled(&wrong, 120, [true; 2], 0.8);
        let (half, _) = speckled(&wrong, 120, [true, false], 0.3);
        for diagnosis in [judged(&picture, "3c"), judged_with(&half, &Coarse(3))] {
            let mut found = codes(&diagnosis);
            found.sort_unstable();
            assert_eq!(found, both);
        }
    }
}

/// What 3(a) should have, 3(c) should not, and the other way round.
#[test]
fn acne_may_be_missing() {
    let recipe = right("3c");
    let (speckled, _) = speckled(&recipe, 96, [true; 2], 0.6);
    assert_eq!(judged(&speckled, "3a").verdict, Verdict::Conforms);
    let missing = judged(&picture(&recipe, size(96, 64)), "3a");
    assert_eq!(codes(&missing), [Code::OtherFigure]);
    let lit = whole(&speckled, &Lossless)
        .drawn(&recipe)
        .expect("a viewpoint");
    let lit: Vec<usize> = (0..lit.len()).filter(|&at| lit[at].is_lit).collect();
    assert_eq!(missing.findings[0].places, lit);
}
