//! How well a recipe explains a whole picture.

use super::{changed, everything, picture, right, size, turned};
use crate::conformance::diagnosis::evidence::Evidence;
use crate::conformance::diagnosis::fit::{Fit, around, difference};
use crate::conformance::diagnosis::loss::{Loss, Lossless};
use crate::conformance::diagnosis::recipe::Recipe;
use crate::conformance::diagnosis::shade::Drawn;
use crate::conformance::diagnosis::surface::{Object, Region};
use crate::picture::Picture;
use proptest::collection::btree_set;
use proptest::prelude::*;

const SIZE: (u32, u32) = (64, 48);

/// A loss that changes nothing, but for what may be off.
struct Harmless(u8);

impl Loss for Harmless {
    fn degrade(&self, _: u32, _: u32, _: &mut [[u8; 3]]) {}

    fn tolerance(&self) -> u8 {
        self.0
    }
}

/// How well the recipe of Figure 3(c) explains a picture.
fn fit(picture: &Picture, loss: &dyn Loss) -> (Fit, bool) {
    fit_of(&right("3c"), picture, loss)
}

fn fit_of(recipe: &Recipe, picture: &Picture, loss: &dyn Loss) -> (Fit, bool) {
    let evidence = Evidence::new(picture, vec![everything(picture.size())], loss);
    let fit = Fit::of(
        &evidence,
        recipe,
        &evidence.predicted(recipe).expect("a viewpoint"),
    );
    (fit, fit.is_good(&evidence, recipe))
}

fn figure() -> Picture {
    picture(&right("3c"), size(SIZE.0, SIZE.1))
}

/// A byte so much brighter or darker.
fn moved(byte: u8, by: i32) -> u8 {
    (i32::from(byte) + by).clamp(0, 255) as u8
}

/// What a recipe draws it explains, with any loss.
#[test]
fn its_own_picture_is_explained() {
    for tolerance in [0, 6] {
        let (fit, is_good) = fit(&figure(), &Harmless(tolerance));
        let nothing = Fit {
            unexplained: 0.0,
            inside: 0.0,
            bias: 0.0,
        };
        assert_eq!((fit, is_good), (nothing, true));
    }
}

/// Pixels of another colour are unexplained, each of them and no other; three in a thousand make a
/// picture another one, and where there is loss eight.
#[test]
fn strange_pixels_are_unexplained() {
    let right = figure();
    for (tolerance, most) in [(0, 0.003), (6, 0.008)] {
        for count in [1, 8, 9, 10, 23, 24, 25, 26, 60] {
            // One in each row of the sky and of the plane's border, away from each other.
            let green = changed(&right, |at, rgb| {
                let is_one = at % 7 == 3 && at / 7 < count;
                if is_one { [0, 255, 0] } else { rgb }
            });
            let (fit, is_good) = fit(&green, &Harmless(tolerance));
            let part = count as f64 / f64::from(SIZE.0 * SIZE.1);
            assert!((fit.unexplained - part).abs() < 1e-12, "{count}: {fit:?}");
            let off = fit.inside <= 0.5 && fit.bias <= 0.12;
            assert!(!is_good || part <= most, "{count}: {fit:?}");
            assert!(is_good || part > most || !off, "{count}: {fit:?}");
        }
    }
}

/// A silhouette may lie a pixel beside where it should, and two where there is loss, but no
/// further.
#[test]
fn silhouettes_may_be_a_pixel_off() {
    let right = figure();
    let (width, height) = (SIZE.0 as i32, SIZE.1 as i32);
    let pixels = right.bytes().as_chunks::<3>().0;
    for (by, lossless, lossy) in [(1, true, true), (2, false, true), (3, false, false)] {
        for (across, down) in [(by, 0), (-by, 0), (0, by), (0, -by)] {
            let shifted = changed(&right, |at, rgb| {
                let (x, y) = (at as i32 % width - across, at as i32 / width - down);
                let is_inside = x >= 0 && y >= 0 && x < width && y < height;
                if is_inside {
                    pixels[(y * width + x) as usize]
                } else {
                    rgb
                }
            });
            for (loss, is_explained) in [(Harmless(0), lossless), (Harmless(1), lossy)] {
                let unexplained = fit(&shifted, &loss).0.unexplained;
                let words = format!("{across} {down} {}: {unexplained}", loss.0);
                assert_eq!(unexplained < 0.003, is_explained, "{words}");
            }
        }
    }
}

/// There, and elsewhere, levels may be two off, and more through a loss.
#[test]
fn levels_may_be_off() {
    let right = figure();
    let pixels = right.bytes().as_chunks::<3>().0;
    let width = SIZE.0 as usize;
    for (loss, most) in [(Harmless(0), 2), (Harmless(1), 3), (Harmless(6), 8)] {
        for (by, is_explained) in [
            (most, true),
            (-most, true),
            (most + 2, false),
            (-most - 2, false),
        ] {
            // Each pixel is its left neighbour.
            let shifted = changed(&right, |at, rgb| {
                let rgb = if at % width > 0 { pixels[at - 1] } else { rgb };
                rgb.map(|byte| moved(byte, by))
            });
            let unexplained = fit(&shifted, &loss).0.unexplained;
            let words = format!("{by} {}: {unexplained}", loss.0);
            // What is black, and gets no darker, is less than two thirds.
            let is_as_told = if is_explained {
                unexplained == 0.0
            } else {
                unexplained > 0.3
            };
            assert!(is_as_told, "{words}");
        }
    }
}

/// What acne may have darkened is explained, through a loss as well.
#[test]
fn acne_is_explained() {
    let speckled = turned(&right("3c"), |r| r.acne = [true; 2]);
    let dark = changed(&figure(), |at, rgb| {
        if at % 3 == 0 && rgb[1] == 0 {
            [0; 3]
        } else {
            rgb
        }
    });
    for tolerance in [0, 6] {
        let (found, _) = fit_of(&speckled, &dark, &Harmless(tolerance));
        assert_eq!(found.unexplained, 0.0, "{tolerance}");
        let (found, is_good) = fit(&dark, &Harmless(tolerance));
        assert!(
            found.unexplained > 0.05 && !is_good,
            "{tolerance}: {found:?}"
        );
    }
}

/// A picture of whose sky one pixel in so many is off: as many are brighter as darker.
fn noisy(by: i32, every: usize) -> Picture {
    changed(&figure(), |at, rgb| {
        let is_brighter = (at + at / SIZE.0 as usize).is_multiple_of(2);
        let by = if is_brighter { by } else { -by };
        if rgb == [127; 3] && at.is_multiple_of(every) {
            rgb.map(|byte| moved(byte, by))
        } else {
            rgb
        }
    })
}

/// A picture that is one level too bright in one pixel of so many.
fn brighter(every: usize) -> Picture {
    changed(&figure(), |at, rgb| {
        let by = i32::from(at.is_multiple_of(every));
        rgb.map(|byte| moved(byte, by))
    })
}

/// What is brighter everywhere is biased; what is brighter here and darker there is noise. Both are
/// off by as much.
#[test]
fn noise_is_not_bias() {
    let sky = figure()
        .bytes()
        .chunks(3)
        .filter(|rgb| *rgb == [127; 3])
        .count();
    let part = sky as f64 / f64::from(SIZE.0 * SIZE.1);
    for by in [1, 2] {
        let (noise, _) = fit(&noisy(by, 1), &Lossless);
        // Most that is not sky, on the other hand, is near a silhouette.
        let off = part * f64::from(by);
        assert!(noise.bias < 0.02 * off, "{noise:?}");
        assert!(noise.inside > off && noise.inside < 1.5 * off, "{noise:?}");
        assert_eq!(noise.unexplained, 0.0);
    }
    for every in [1, 2, 5] {
        let (bias, _) = fit(&brighter(every), &Lossless);
        let off = 1.0 / every as f64;
        assert!((bias.inside - off).abs() < 0.05 * off, "{bias:?}");
        assert!((bias.bias - off).abs() < 0.05 * off, "{bias:?}");
        assert_eq!(bias.unexplained, 0.0);
    }
}

/// A picture that is too bright by an eighth of a level is another one, however near its pixels
/// are; through a loss a little more is allowed, and speckles hide it.
#[test]
fn bias_is_an_error() {
    for (every, tolerance, is_good) in [
        (2, 0, false),
        (6, 0, false),
        (10, 0, true),
        (3, 4, false),
        (4, 4, true),
        (2, 8, false),
        (3, 8, true),
        (2, 12, true),
        (1, 12, false),
    ] {
        let (fit, good) = fit(&brighter(every), &Harmless(tolerance));
        assert_eq!(good, is_good, "{every} {tolerance}: {fit:?}");
    }
    let speckled = turned(&right("3c"), |r| r.acne = [true; 2]);
    assert!(fit_of(&speckled, &brighter(1), &Lossless).1);
}

/// Noise of half a level is allowed, more of it through a loss, and much more where there are
/// speckles.
#[test]
fn noise_is_an_error_too() {
    let speckled = turned(&right("3c"), |r| r.acne = [true; 2]);
    for (by, every, recipe, tolerance, is_good) in [
        (1, 2, right("3c"), 0, true),
        (1, 1, right("3c"), 0, false),
        (1, 1, right("3c"), 4, false),
        (1, 1, right("3c"), 8, true),
        (2, 1, right("3c"), 32, false),
        (2, 1, right("3c"), 40, true),
        (2, 1, speckled, 0, true),
        (3, 1, speckled, 0, true),
        (3, 1, speckled, 8, true),
    ] {
        let (fit, good) = fit_of(&recipe, &noisy(by, every), &Harmless(tolerance));
        assert_eq!(good, is_good, "{by} {every} {tolerance}: {fit:?}");
    }
}

/// The pixels around which a rectangle is drawn are in it, and touch each of its sides.
#[test]
fn rectangles_are_the_smallest() {
    assert_eq!(around(&[], 7), None);
    let pixels = btree_set(0_usize..90, 1..6);
    proptest!(ProptestConfig { failure_persistence: None, ..Default::default() }, |(pixels in pixels, width in 1_u32..12)| {
        let pixels: Vec<usize> = pixels.into_iter().collect();
        let Region { left, top, width: across, height } = around(&pixels, width).expect("some pixels");
        let columns: Vec<u32> = pixels.iter().map(|&at| at as u32 % width).collect();
        let rows: Vec<u32> = pixels.iter().map(|&at| at as u32 / width).collect();
        prop_assert_eq!(columns.iter().min(), Some(&left));
        prop_assert_eq!(columns.iter().max(), Some(&(left + across - 1)));
        prop_assert_eq!(rows.iter().min(), Some(&top));
        prop_assert_eq!(rows.iter().max(), Some(&(top + height - 1)));
    });
}

/// Pixels differ where a component differs by more than is tolerated.
#[test]
fn differences_are_beyond_the_tolerance() {
    let pixel = |rgb| Drawn {
        rgb,
        object: Object::Plane,
        is_lit: true,
    };
    let a = [[9, 9, 9]; 6].map(pixel);
    let b = [
        [9, 9, 9],
        [9, 9, 12],
        [9, 6, 9],
        [13, 9, 9],
        [9, 5, 9],
        [9, 9, 8],
    ]
    .map(pixel);
    let (places, region) = difference(&a, &b, 3, 3);
    assert_eq!(places, [3, 4]);
    assert_eq!(region, around(&[3, 4], 3));
    assert_eq!(difference(&a, &a, 3, 0), (vec![], None));
}
