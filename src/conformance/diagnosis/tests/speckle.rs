//! What speckles are, and what looks like them and is none.

use super::{Coarse, changed, picture, random, right, size, whole};
use crate::conformance::diagnosis::acne::Speckle;
use crate::conformance::diagnosis::loss::{Loss, Lossless};
use crate::conformance::diagnosis::recipe::Recipe;
use crate::conformance::diagnosis::shade::Drawn;
use crate::conformance::diagnosis::surface::Object;
use crate::picture::Picture;

/// Figure 2(b), and what it should be.
struct Case {
    picture: Picture,
    recipe: Recipe,
    drawn: Vec<Drawn>,
}

impl Case {
    fn new(width: u32, height: u32) -> Self {
        let recipe = right("2b");
        let picture = picture(&recipe, size(width, height));
        let drawn = whole(&picture, &Lossless).drawn(&recipe);
        Self {
            drawn: drawn.expect("a viewpoint"),
            recipe,
            picture,
        }
    }

    fn wide() -> Self {
        Self::new(240, 160)
    }

    fn pixels(&self) -> usize {
        self.picture.size().pixels()
    }

    /// What the lit pixels of an object look like, in another picture.
    fn speckle(&self, picture: &Picture, object: Object) -> Speckle {
        let evidence = whole(picture, &Lossless);
        Speckle::of(&evidence, &self.recipe, &self.drawn, object)
    }

    /// The figure with a part of each pixel's light, as it is decided for that pixel.
    fn darkened(&self, share: impl Fn(usize) -> f64) -> Picture {
        let darker = |byte: u8, share: f64| (f64::from(byte) * share) as u8;
        changed(&self.picture, |at, rgb| {
            rgb.map(|byte| darker(byte, share(at)))
        })
    }
}

const OBJECTS: [Object; 2] = [Object::Sphere, Object::Plane];

/// A right picture has all its light, and is smooth.
#[test]
fn a_right_picture_has_no_speckles() {
    let case = Case::wide();
    for object in OBJECTS {
        let found = case.speckle(&case.picture, object);
        assert!(found.lit > 800, "{found:?}");
        assert_eq!((found.dark, found.partly), (0, 0));
        assert_eq!((found.mean, found.roughness), (1.0, 0.0));
        assert!(!found.is_acne(0) && !found.is_averaged());
    }
    let nothing = case.speckle(&case.picture, Object::Background);
    assert_eq!(nothing, Speckle::default());
}

/// Of an object those pixels are looked at that are bright enough, not at the edge of the picture,
/// and all of whose neighbours are lit pixels of the same object: each of them that is black is
/// counted, and no other.
#[test]
fn pixels_inside_are_counted() {
    let (width, height) = (60, 40);
    let case = Case::new(width as u32, height as u32);
    for object in OBJECTS {
        let right = case.speckle(&case.picture, object);
        let is_its = |at: usize| case.drawn[at].object == object && case.drawn[at].is_lit;
        let mut inside = 0;
        for at in 0..case.pixels() {
            let (x, y) = (at % width, at / width);
            let at_edge = x == 0 || y == 0 || x + 1 == width || y + 1 == height;
            let is_bright = case.drawn[at].rgb.into_iter().max() >= Some(24);
            let is_inside = !at_edge
                && is_bright
                && (0..9).all(|n| is_its((y + n / 3 - 1) * width + x + n % 3 - 1));
            inside += usize::from(is_inside);
            let black = case.darkened(|other| f64::from(u8::from(other != at)));
            let found = case.speckle(&black, object);
            assert_eq!(found.dark, usize::from(is_inside), "{x} {y}");
            let mean = 1.0 - found.dark as f64 / found.lit as f64;
            assert!((found.mean - mean).abs() < 1e-9, "{x} {y}");
        }
        assert_eq!(right.lit, inside);
    }
}

/// The more a loss may take from a byte, the brighter are the pixels that say anything.
#[test]
fn dim_pixels_say_nothing_through_a_loss() {
    let case = Case::wide();
    let of = |loss: &dyn Loss| {
        let evidence = whole(&case.picture, loss);
        Speckle::of(&evidence, &case.recipe, &case.drawn, Object::Plane).lit
    };
    let lit = [
        of(&Lossless),
        of(&Coarse(2)),
        of(&Coarse(4)),
        of(&Coarse(8)),
    ];
    assert!(lit.is_sorted_by(|more, fewer| more > fewer), "{lit:?}");
}

/// Pixels that are black or not, each by itself, are as many as were made black; and as rough as
/// can be.
#[test]
fn random_black_pixels_are_rough() {
    let case = Case::wide();
    for part in [0.03, 0.1, 0.5, 0.9] {
        let mut random = random(3);
        let black: Vec<bool> = (0..case.pixels()).map(|_| random() < part).collect();
        let picture = case.darkened(|at| if black[at] { 0.0 } else { 1.0 });
        for object in OBJECTS {
            let found = case.speckle(&picture, object);
            let dark = found.dark as f64 / found.lit as f64;
            assert!((dark - part).abs() < 0.04, "{part}: {found:?}");
            assert!(
                (found.mean - (1.0 - dark)).abs() < 0.02,
                "{part}: {found:?}"
            );
            assert!((found.roughness - 1.0).abs() < 0.15, "{part}: {found:?}");
            assert_eq!(found.partly, 0);
            assert!(found.is_acne(0) && found.is_acne(6), "{part}: {found:?}");
        }
    }
}

/// One light for all is no acne, nor is a solid shadow, nor are a few black pixels.
#[test]
fn what_is_smooth_is_no_acne() {
    let case = Case::wide();
    let width = case.picture.size().width() as usize;
    let even = case.darkened(|_| 0.6);
    let solid = case.darkened(|at| if at % width < width / 2 { 0.0 } else { 1.0 });
    for object in OBJECTS {
        let found = case.speckle(&even, object);
        assert!(
            (found.mean - 0.6).abs() < 0.01 && found.roughness < 0.06,
            "{found:?}"
        );
        assert!(found.is_averaged() && !found.is_acne(0), "{found:?}");
        let found = case.speckle(&solid, object);
        assert!(
            found.roughness < 0.08 && found.dark * 3 > found.lit,
            "{found:?}"
        );
        assert!(!found.is_acne(0) && !found.is_averaged(), "{found:?}");
    }
}

/// How rough darkened pixels must be to be acne: more where a loss roughens the edge of a shadow, less
/// where it has smoothed what is mostly black.
#[test]
fn roughness_is_judged_by_the_loss() {
    let speckle = |mean, roughness| Speckle {
        lit: 500,
        dark: 0,
        mean,
        partly: 0,
        roughness,
    };
    for (tolerance, mean, rough, smooth) in [
        (0, 0.7, 0.09, 0.07),
        (0, 0.9, 0.09, 0.07),
        (1, 0.7, 0.05, 0.04),
        (1, 0.9, 0.16, 0.14),
    ] {
        assert!(speckle(mean, rough).is_acne(tolerance));
        assert!(!speckle(mean, smooth).is_acne(tolerance));
        // What has its light is not darkened, however rough.
        assert!(!speckle(0.96, rough).is_acne(tolerance));
    }
    // A few dark pixels are acne by themselves only where they are very rough.
    for (dark, roughness, is_acne) in [(12, 0.31, true), (12, 0.29, false), (11, 0.9, false)] {
        let found = Speckle {
            dark,
            ..speckle(0.97, roughness)
        };
        assert_eq!(found.is_acne(0), is_acne, "{found:?}");
    }
    let few = Speckle {
        lit: 11,
        ..speckle(0.5, 1.0)
    };
    assert!(!few.is_acne(0));
}

/// A dozen black pixels are acne, fewer are a rounding here and there.
#[test]
fn few_black_pixels_are_no_acne() {
    let case = Case::wide();
    let width = case.picture.size().width() as usize;
    // In the plane, in a row near the bottom.
    let row = case.pixels() - 8 * width + 10;
    for count in [1, 11, 12, 20] {
        let picture = case.darkened(|at| {
            let is_one = at >= row && at < row + 3 * count && (at - row).is_multiple_of(3);
            if is_one { 0.0 } else { 1.0 }
        });
        let found = case.speckle(&picture, Object::Plane);
        assert_eq!(found.dark, count);
        assert_eq!(found.is_acne(0), count >= 12, "{found:?}");
        assert_eq!(case.speckle(&picture, Object::Sphere).dark, 0);
    }
}

/// Averages over black pixels are acne: noise around less light than there should be.
#[test]
fn noise_of_averages_is_acne() {
    let case = Case::wide();
    let mut random = random(4);
    let share: Vec<f64> = (0..case.pixels())
        .map(|_| {
            (0..16)
                .map(|_| f64::from(u8::from(random() > 0.4)))
                .sum::<f64>()
                / 16.0
        })
        .collect();
    let picture = case.darkened(|at| share[at]);
    for object in OBJECTS {
        let found = case.speckle(&picture, object);
        assert!((found.mean - 0.6).abs() < 0.02, "{found:?}");
        assert!(found.roughness > 0.2 && found.roughness < 0.4, "{found:?}");
        assert!(found.is_averaged() && found.is_acne(0), "{found:?}");
    }
}
