//! Parts of a picture, and how far recipes are from them.

use super::{changed, everything, picture, right, size, turned, whole};
use crate::conformance::diagnosis::evidence::{Evidence, TILE, distance, tiles_of};
use crate::conformance::diagnosis::loss::{Loss, Lossless};
use crate::conformance::diagnosis::shade::Drawn;
use crate::conformance::diagnosis::surface::{Object, Region};
use crate::film::Film;
use crate::picture::{Picture, Size};

/// A loss that leaves the size of the part in every pixel, and the pixel's number in it.
struct Numbers(u8);

impl Loss for Numbers {
    fn degrade(&self, width: u32, height: u32, pixels: &mut [[u8; 3]]) {
        assert_eq!(pixels.len(), (width * height) as usize);
        for (number, pixel) in pixels.iter_mut().enumerate() {
            *pixel = [width as u8, height as u8, number as u8];
        }
    }

    fn tolerance(&self) -> u8 {
        self.0
    }
}

/// Tiles begin at multiples of their side and cover each pixel once.
#[test]
fn tiles_cover_a_picture_once() {
    for (width, height) in [(1, 1), (15, 17), (16, 16), (33, 32), (64, 47), (100, 1)] {
        let size = size(width, height);
        let mut times = vec![0; size.pixels()];
        for (x, y, region) in tiles_of(size) {
            assert_eq!((region.left, region.top), (x * TILE, y * TILE));
            assert!(region.width <= TILE && region.height <= TILE);
            for (x, y) in region.pixels() {
                times[(y * width + x) as usize] += 1;
            }
        }
        assert!(times.iter().all(|&times| times == 1), "{width}x{height}");
    }
}

const SIZES: [(u32, u32); 8] = [
    (32, 32),
    (160, 107),
    (600, 400),
    (601, 399),
    (1280, 800),
    (2000, 500),
    (500, 2000),
    (3000, 2000),
];

fn sample(size: Size, pixels: usize) -> Evidence<'static> {
    Evidence::sample(&Picture::black(size), pixels, &Lossless)
}

/// A sample has about as many pixels as were asked for: not fewer than a third, and not twice as
/// many, but for the part of the picture that is always in it; a picture that has no more is taken
/// as it is.
#[test]
fn samples_are_as_large_as_asked() {
    for (width, height) in SIZES {
        for pixels in [4_000, 12_000, 40_000] {
            let size = size(width, height);
            let sample = sample(size, pixels);
            let taken = sample.observed.len();
            let all = size.pixels();
            let regions: u32 = sample.regions.iter().map(|r| r.width * r.height).sum();
            assert_eq!(taken, regions as usize);
            // The bright part: a fifth of the width, and the eighth of the height, and tiles that
            // are partly in it.
            let bright = (width / 5 + 2 * TILE) * (height / 7 + 4 * TILE);
            let most = 2 * pixels + bright as usize;
            let words = format!("{width}x{height}: {taken} of {pixels}");
            assert!(taken <= most, "{words}");
            assert!(3 * taken >= pixels.min(all), "{words}");
            assert!(all > pixels || taken == all, "{words}");
        }
    }
}

/// Samples are spread: of two neighbouring columns of tiles one is in them, and of two rows.
#[test]
fn samples_are_spread() {
    for (width, height) in SIZES {
        for pixels in [4_000, 12_000, 40_000] {
            let sample = sample(size(width, height), pixels);
            let has_column = |x: u32| sample.regions.iter().any(|r| r.left == x * TILE);
            let has_row = |y: u32| sample.regions.iter().any(|r| r.top == y * TILE);
            let (columns, rows) = (width.div_ceil(TILE), height.div_ceil(TILE));
            let every = (width * height).div_ceil(pixels as u32);
            let words = format!("{width}x{height}, {pixels} pixels");
            let is_spread =
                |has: &dyn Fn(u32) -> bool, n: u32| (1..n).all(|i| has(i - 1) || has(i));
            assert!(rows < every || is_spread(&has_column, columns), "{words}");
            assert!(columns < every || is_spread(&has_row, rows), "{words}");
        }
    }
}

/// What is in every sample lies in the middle, from left to right, and from top to bottom.
#[test]
fn what_is_in_every_sample_lies_in_the_middle() {
    for (width, height) in [(640, 480), (1280, 800), (480, 640)] {
        // So few pixels that nothing else is in it, but for the first row or column.
        let regions = sample(size(width, height), 1).regions;
        let inner = |r: &&Region| r.left > 0 && r.top > 0;
        let tiles = regions.iter().filter(inner).map(|r| (r.left, r.top));
        let tiles: Vec<(u32, u32)> = tiles.collect();
        assert!(tiles.len() > 20, "{width}x{height}: {}", tiles.len());
        for &(left, top) in &tiles {
            for other in [(width - TILE - left, top), (left, height - TILE - top)] {
                assert!(tiles.contains(&other), "{width}x{height}: {left} {top}");
            }
        }
    }
}

/// Where bytes wrap is a small part of a picture, and in the sample: the film shows. In a picture
/// of an unusual shape a third of that part is.
#[test]
fn samples_show_the_film() {
    let clamps = right("2b");
    let wraps = turned(&clamps, |r| r.film = Film::Wrap);
    let differing = |evidence: &Evidence| {
        let [a, b] = [clamps, wraps].map(|r| evidence.drawn(&r).expect("a viewpoint"));
        a.iter().zip(&b).filter(|(a, b)| a.rgb != b.rgb).count()
    };
    for (width, height, part) in [
        (600, 400, 1.0),
        (601, 399, 1.0),
        (160, 107, 0.6),
        (300, 1200, 0.3),
    ] {
        let size = size(width, height);
        let in_sample = differing(&sample(size, 4_000)) as f64;
        let in_all = differing(&whole(&Picture::black(size), &Lossless)) as f64;
        assert!(
            in_sample >= part * in_all && in_all > 0.0,
            "{width}x{height}: {in_sample} of {in_all}"
        );
    }
}

/// What has been seen is not seen anew, however many viewpoints came between; and it is the same.
#[test]
fn viewpoints_are_remembered() {
    let recipe = right("3c");
    let sample = sample(size(64, 48), 40_000);
    let first = sample.drawn(&recipe).expect("a viewpoint");
    let before = sample.surfels(&recipe.viewpoint).expect("a viewpoint");
    let again = sample.surfels(&recipe.viewpoint).expect("a viewpoint");
    assert!(std::rc::Rc::ptr_eq(&before, &again));
    for step in 1..100 {
        let other = turned(&recipe, |r| r.viewpoint.fov += f64::from(step) / 10.0);
        assert_ne!(sample.drawn(&other).expect("a viewpoint"), first);
    }
    let again = sample.surfels(&recipe.viewpoint).expect("a viewpoint");
    assert!(std::rc::Rc::ptr_eq(&before, &again));
    assert_eq!(sample.drawn(&recipe).expect("a viewpoint"), first);
}

/// A loss is applied to every part by itself, and only where there is one.
#[test]
fn losses_are_those_of_each_part() {
    let size = size(40, 24);
    let regions: Vec<Region> = tiles_of(size).map(|(.., region)| region).collect();
    let (loss, none) = (Numbers(1), Numbers(0));
    let black = Picture::black(size);
    let lossy = Evidence::new(&black, regions.clone(), &loss);
    let mut predicted = lossy
        .predicted(&right("3c"))
        .expect("a viewpoint")
        .into_iter();
    for region in &regions {
        for number in 0..region.width * region.height {
            let pixel = predicted.next().expect("all pixels").rgb;
            assert_eq!(
                pixel,
                [region.width as u8, region.height as u8, number as u8]
            );
        }
    }
    let lossless = Evidence::new(&black, regions, &none);
    let [drawn, predicted] = [
        lossless.drawn(&right("3c")),
        lossless.predicted(&right("3c")),
    ];
    assert_eq!(drawn, predicted);
}

/// The error is the mean over the pixels of the largest difference of a component, where 64 is as
/// bad as it gets.
#[test]
fn errors_are_means_of_differences() {
    let (recipe, size) = (right("3c"), size(48, 36));
    let right = picture(&recipe, size);
    let error = |picture: &Picture| {
        whole(picture, &Lossless)
            .error(&recipe)
            .expect("a viewpoint")
    };
    assert_eq!(error(&right), 0.0);
    for (by, levels) in [(1, 1.0), (20, 20.0), (64, 64.0), (100, 64.0)] {
        let off = changed(&right, |at, [red, green, blue]| {
            let green = if at % 2 == 0 { other(green, by) } else { green };
            [red, green, blue]
        });
        assert!((error(&off) - levels / 2.0).abs() < 1e-12, "{by}");
    }
}

/// A byte that is so far away.
fn other(byte: u8, by: u8) -> u8 {
    byte.checked_add(by).unwrap_or_else(|| byte - by)
}

/// Where acne may be, a pixel that is darker in its hue costs little, and less if it is black; one
/// that is brighter or of another hue costs what it is off, and so does every pixel elsewhere.
#[test]
fn acne_costs_less_than_what_nothing_explains() {
    let speckled = turned(&right("3c"), |r| r.acne = [true, false]);
    let size = size(32, 32);
    let (black, few) = (Picture::black(size), Numbers(4));
    let lossless = whole(&black, &Lossless);
    let lossy = Evidence::new(&black, vec![everything(size)], &few);
    let pixel = |object, is_lit| Drawn {
        rgb: [0, 0, 60],
        object,
        is_lit,
    };
    let lit = pixel(Object::Sphere, true);
    let cost =
        |evidence: &Evidence, pixel: &Drawn, seen| evidence.pixel_error(&speckled, pixel, seen);
    let fallen = [[0, 0, 0], [1, 0, 1], [0, 0, 2], [1, 1, 30], [0, 0, 57]];
    let costs = fallen.map(|seen| cost(&lossless, &lit, seen));
    assert!(costs[0] == costs[1] && costs[0] < costs[2], "{costs:?}");
    assert!(costs[2] == costs[3] && costs[2] == costs[4], "{costs:?}");
    // As for its own: the noise of a darker surface is less, what nothing explains is more.
    assert!(costs[2] > 2.0 && costs[2] < 4.0, "{costs:?}");
    for seen in [
        [0, 0, 60],
        [0, 0, 61],
        [0, 0, 58],
        [0, 0, 63],
        [0, 0, 90],
        [2, 0, 30],
        [0, 40, 0],
    ] {
        let off = f64::from(distance(lit.rgb, seen)).min(64.0);
        assert_eq!(cost(&lossless, &lit, seen), off, "{seen:?}");
    }
    for elsewhere in [
        pixel(Object::Sphere, false),
        pixel(Object::Plane, true),
        pixel(Object::Background, false),
    ] {
        for seen in fallen {
            let off = f64::from(distance(lit.rgb, seen));
            assert_eq!(cost(&lossless, &elsewhere, seen), off, "{seen:?}");
        }
    }
    // Through a loss hues bleed, and nothing is sure to be black: the brightest component tells.
    for (seen, is_dark) in [
        ([0, 0, 0], true),
        ([9, 0, 30], true),
        ([68, 0, 0], true),
        ([69, 0, 0], false),
        ([0, 0, 66], false),
        ([0, 0, 55], false),
        ([0, 0, 53], true),
    ] {
        let off = f64::from(distance(lit.rgb, seen)).min(64.0);
        let cost = cost(&lossy, &lit, seen);
        assert_eq!(cost < off, is_dark, "{seen:?}: {cost}");
        assert!(!is_dark || cost > costs[2], "{seen:?}: {cost}");
    }
}
