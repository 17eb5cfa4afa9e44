//! The outline of a set of pixels.

use super::canvas::Area;
use tiny_skia::{Path, PathBuilder};

/// The edges between pixels that are in the set and pixels that are not, as a path along the pixels'
/// sides. Pixel (x, y) covers the square from `place(x, y)` to `place(x + 1, y + 1)`.
///
/// Edges in one line are one segment, so a large smooth outline stays a short path.
pub fn outline(
    within: Area,
    in_set: impl Fn(u32, u32) -> bool,
    place: impl Fn(u32, u32) -> [f32; 2],
) -> Option<Path> {
    let Area {
        left,
        top,
        width,
        height,
    } = within;
    let (right, bottom) = (left + width, top + height);
    let inside = |x: i64, y: i64| {
        let (Ok(x), Ok(y)) = (u32::try_from(x), u32::try_from(y)) else {
            return false;
        };
        (left..right).contains(&x) && (top..bottom).contains(&y) && in_set(x, y)
    };
    let mut builder = PathBuilder::new();
    let mut segment = |from: [f32; 2], to: [f32; 2]| {
        builder.move_to(from[0], from[1]);
        builder.line_to(to[0], to[1]);
    };
    for y in top..=bottom {
        let is_edge = |x: u32| {
            let (x, y) = (i64::from(x), i64::from(y));
            inside(x, y - 1) != inside(x, y)
        };
        for [from, to] in runs(left..right, is_edge) {
            segment(place(from, y), place(to, y));
        }
    }
    for x in left..=right {
        let is_edge = |y: u32| {
            let (x, y) = (i64::from(x), i64::from(y));
            inside(x - 1, y) != inside(x, y)
        };
        for [from, to] in runs(top..bottom, is_edge) {
            segment(place(x, from), place(x, to));
        }
    }
    builder.finish()
}

/// The longest runs of numbers for which `holds`, each as its first number and the one after its last.
fn runs(range: std::ops::Range<u32>, holds: impl Fn(u32) -> bool) -> Vec<[u32; 2]> {
    let mut runs: Vec<[u32; 2]> = vec![];
    for number in range.filter(|&number| holds(number)) {
        match runs.last_mut() {
            Some([_, end]) if *end == number => *end += 1,
            _ => runs.push([number, number + 1]),
        }
    }
    runs
}
