//! Colours and the light's power, measured on pictures.

use super::{changed, picture, random, right, size, turned, whole};
use crate::conformance::diagnosis::evidence::Evidence;
use crate::conformance::diagnosis::loss::Lossless;
use crate::conformance::diagnosis::measure;
use crate::conformance::diagnosis::recipe::{Recipe, Rounding, Sampling, Transfer};
use crate::conformance::diagnosis::surface::{Object, Region, Surfel};
use crate::error::Invalid;
use crate::film::Film;
use crate::picture::{Picture, Size};

const TRANSFERS: [Transfer; 3] = [Transfer::Linear, Transfer::Srgb, Transfer::Power];

fn small() -> Size {
    size(64, 48)
}

/// What is measured in a picture of one recipe by another.
fn measured<T>(
    drawn: &Picture,
    by: &Recipe,
    measure: impl Fn(&Evidence, &Recipe) -> Result<T, Invalid>,
) -> T {
    measure(&whole(drawn, &Lossless), by).expect("a viewpoint")
}

/// Falsely black pixels, one in so many.
fn speckled(picture: &Picture, part: f64) -> Picture {
    let black: Vec<bool> = {
        let mut random = random(7);
        (0..picture.size().pixels())
            .map(|_| random() < part)
            .collect()
    };
    changed(picture, |at, rgb| if black[at] { [0; 3] } else { rgb })
}

/// A background is measured to half a level, whatever encodes it, if most of it is what it should
/// be.
#[test]
fn backgrounds() {
    let mut random = random(1);
    for transfer in TRANSFERS {
        for (rounding, swapped) in [(Rounding::Truncate, false), (Rounding::Nearest, true)] {
            let knobs = turned(&right("2b"), |r| {
                (r.transfer, r.rounding, r.swapped) = (transfer, rounding, swapped);
            });
            let color = [random(), random(), random()];
            let drawn = picture(&turned(&knobs, |r| r.background = color), small());
            for drawn in [speckled(&drawn, 0.3), drawn] {
                let found = measured(&drawn, &knobs, measure::background).expect("a background");
                for (found, drawn) in found.iter().zip(color) {
                    let off = (transfer.encode(*found) - transfer.encode(drawn)).abs();
                    assert!(
                        off <= 0.51 / 255.0,
                        "{transfer:?} {rounding:?}: {found} {drawn}"
                    );
                }
            }
        }
    }
}

/// What fewer than two dozen pixels show is not measured.
#[test]
fn few_pixels_measure_nothing() {
    // So dim that nothing is clamped.
    let recipe = turned(&right("2b"), |r| r.power = 0.2);
    let drawn = picture(&recipe, small());
    let row = |width, (left, top)| {
        let region = Region {
            left,
            top,
            width,
            height: 1,
        };
        Evidence::new(&drawn, vec![region], &Lossless)
    };
    for pixels in [0, 1, 23, 24, 25, 64] {
        let sky = measure::background(&row(pixels, (0, 0)), &recipe).expect("a viewpoint");
        assert_eq!(sky.is_some(), pixels >= 24, "{pixels}");
    }
    for (pixels, is_measured) in [(0, false), (1, false), (23, false), (25, true), (40, true)] {
        let part = |left, top| row(pixels, (left, top));
        let floor = measure::color(&part(0, 47), &recipe, Object::Plane).expect("a viewpoint");
        assert_eq!(floor.is_some(), is_measured, "{pixels}");
        let power = measure::power(&part(0, 47), &recipe).expect("a viewpoint");
        assert_eq!(power.is_some(), is_measured, "{pixels}");
        let sphere = measure::color(&part(0, 47), &recipe, Object::Sphere).expect("a viewpoint");
        assert_eq!(sphere, None);
    }
}

/// Colours are measured to a hundredth, and a level of the darkest pixels, with the film of either
/// kind and with a third of the pixels falsely black.
#[test]
fn colors() {
    let mut random = random(2);
    for figure in ["1", "2a", "2b", "3c"] {
        for (transfer, swapped) in [(Transfer::Linear, true), (Transfer::Srgb, false)] {
            let is_linear = transfer == Transfer::Linear;
            if right(figure).film == Film::Wrap && !is_linear {
                continue;
            }
            let knobs = turned(&right(figure), |r| {
                (r.transfer, r.swapped) = (transfer, swapped);
            });
            let colors = [0, 1].map(|_| [random(), random(), random()]);
            let drawn = picture(&turned(&knobs, |r| r.colors = colors), small());
            for drawn in [speckled(&drawn, 0.3), drawn] {
                for (index, object) in [Object::Sphere, Object::Plane].into_iter().enumerate() {
                    let color = |evidence: &Evidence, recipe: &Recipe| {
                        measure::color(evidence, recipe, object)
                    };
                    let found = measured(&drawn, &knobs, color).expect("a colour");
                    for (found, drawn) in found.iter().zip(colors[index]) {
                        let off = (found - drawn).abs();
                        assert!(
                            off <= 0.02 * drawn + 0.006,
                            "{figure} {transfer:?} {object:?}: {found} {drawn}"
                        );
                    }
                }
            }
        }
    }
}

/// The light's power is measured to a hundredth, on either object.
#[test]
fn powers() {
    for figure in ["1", "2a", "2b", "3c"] {
        // In Figure 1 hardly anything is dim.
        let most = if figure == "1" { 1.8 } else { 3.5 };
        for power in [0.25, 0.4, 1.0, most] {
            for has_plane in [true, false] {
                let knobs = turned(&right(figure), |r| r.viewpoint.has_plane = has_plane);
                let drawn = picture(&turned(&knobs, |r| r.power = power), small());
                for drawn in [speckled(&drawn, 0.3), drawn] {
                    let found = measured(&drawn, &knobs, measure::power).expect("a power");
                    assert!(
                        (found / power - 1.0).abs() < 0.02,
                        "{figure} {power} {has_plane}: {found}"
                    );
                }
            }
        }
    }
    // It is what the colour of the recipe leaves over.
    let dark = turned(&right("3c"), |r| {
        r.colors = [[0.0, 0.0, 0.4], [0.5, 0.0, 0.0]];
    });
    let drawn = picture(&turned(&dark, |r| r.power = 2.0), small());
    let found = measured(&drawn, &dark, measure::power).expect("a power");
    assert!((found - 2.0).abs() < 0.04, "{found}");
    // Averages are measured as such.
    let average = turned(&right("3c"), |r| r.viewpoint.sampling = Sampling::Average);
    let drawn = picture(&turned(&average, |r| r.power = 0.5), small());
    let found = measured(&drawn, &average, measure::power).expect("a power");
    assert!((found - 0.5).abs() < 0.01, "{found}");
    // Also where each of them is.
    let [black, half] = [1e-6, 0.5].map(|power| turned(&average, |r| r.power = power));
    let [black, drawn] = [black, half].map(|recipe| picture(&recipe, size(240, 160)));
    let all = whole(&black, &Lossless).surfels(&average.viewpoint);
    let all = all.expect("a viewpoint");
    let places = (0..160).flat_map(|top| (0..240).map(move |left| (left, top)));
    let is_split = |pixel: &[Surfel]| {
        pixel.len() > 1
            && pixel
                .iter()
                .all(|s| s.object == Object::Plane && !s.is_shadowed)
    };
    let split = places
        .zip(all.pixels())
        .filter(|(_, pixel)| is_split(pixel));
    let regions = split.map(|((left, top), _)| Region {
        left,
        top,
        width: 1,
        height: 1,
    });
    let evidence = Evidence::new(&drawn, regions.collect(), &Lossless);
    let found = measure::power(&evidence, &average)
        .expect("a viewpoint")
        .expect("a power");
    assert!((found - 0.5).abs() < 0.02, "{found}");
    // A black object says nothing; the other one does.
    let black = turned(&right("3c"), |r| r.colors[1] = [0.0; 3]);
    let drawn = picture(&turned(&black, |r| r.power = 0.5), small());
    let found = measured(&drawn, &black, measure::power).expect("a power");
    assert!((found - 0.5).abs() < 0.01, "{found}");
    let all = turned(&black, |r| r.colors[0] = [0.0; 3]);
    assert_eq!(measured(&drawn, &all, measure::power), None);
}

/// Bright pixels that wrap around say nothing: dim ones tell how bright they would be.
#[test]
fn what_wraps_around_is_not_measured() {
    for figure in ["2a", "2b", "3c"] {
        let knobs = turned(&right(figure), |r| r.film = Film::Wrap);
        for power in [1.0, 3.0, 8.0] {
            let drawn = picture(&turned(&knobs, |r| r.power = power), small());
            let found = measured(&drawn, &knobs, measure::power).expect("a power");
            assert!(
                (found / power - 1.0).abs() < 0.02,
                "{figure} {power}: {found}"
            );
        }
    }
}
