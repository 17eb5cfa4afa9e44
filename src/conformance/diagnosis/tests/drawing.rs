//! What a recipe draws is what a plain ray tracer with the same mistakes draws.

use super::naive::Naive;
use super::{picture, right, size, whole};
use crate::conformance::diagnosis::loss::Lossless;
use crate::conformance::diagnosis::recipe::{
    Cosine, Recipe, Rounding, Sampling, ShadowRay, Transfer, Viewpoint,
};
use crate::conformance::diagnosis::shade::Drawn;
use crate::conformance::diagnosis::surface::{Object, Surfel};
use crate::film::Film;
use crate::picture::{Picture, Size};
use std::f64::consts::PI;

type Turn = (&'static str, fn(&mut Recipe), fn(&mut Naive));

/// A mistake in both renderers.
const MISTAKES: [Turn; 22] = [
    ("none", |_| {}, |_| {}),
    ("Wrap", |r| r.film = Film::Wrap, |n| n.clamp = false),
    ("Clamp", |r| r.film = Film::Clamp, |n| n.clamp = true),
    (
        "no shadow",
        |r| r.viewpoint.shadow = None,
        |n| n.shadows = false,
    ),
    (
        "offset",
        |r| ray(r, |ray| ray.offset = 0.4),
        |n| n.offset = 0.4,
    ),
    (
        "shift",
        |r| ray(r, |ray| ray.shift = [0.5, -0.25]),
        |n| n.shift = [0.5, 0.0, -0.25],
    ),
    (
        "light",
        |r| ray(r, |ray| ray.light = [-2.0, 1.0]),
        |n| n.shadow_light = Some([-1.0, 10.0, 2.0]),
    ),
    (
        "signed",
        |r| r.cosine = Cosine::Signed,
        |n| n.clamp_cosine = false,
    ),
    ("constant", |r| r.falloff = 0, |n| n.falloff = 0),
    ("linear", |r| r.falloff = 1, |n| n.falloff = 1),
    ("power", |r| r.power = 0.4, |n| n.power = 40.0),
    ("pi", |r| r.power = 1.0 / PI, |n| n.over_pi = true),
    (
        "no plane",
        |r| r.viewpoint.has_plane = false,
        |n| n.plane = false,
    ),
    ("flipped", |r| r.flipped = [true; 2], |n| n.flip = true),
    (
        "mirrored",
        |r| r.viewpoint.mirrored = true,
        |n| n.mirror = true,
    ),
    (
        "upside down",
        |r| r.viewpoint.upside_down = true,
        |n| n.upside_down = true,
    ),
    ("sRGB", |r| r.transfer = Transfer::Srgb, |n| n.gamma = 1),
    ("2.2", |r| r.transfer = Transfer::Power, |n| n.gamma = 2),
    ("swapped", |r| r.swapped = true, |n| n.swap = true),
    (
        "colours",
        |r| r.colors = [[0.2, 0.6, 0.9], [0.9, 0.1, 0.3]],
        |n| (n.sphere_color, n.plane_color) = ([0.2, 0.6, 0.9], [0.9, 0.1, 0.3]),
    ),
    (
        "background",
        |r| r.background = [0.1, 0.7, 0.3],
        |n| n.background = [0.1, 0.7, 0.3],
    ),
    ("fov", |r| r.viewpoint.fov = 84.0, |n| n.fov = 84.0),
];

fn ray(recipe: &mut Recipe, turn: fn(&mut ShadowRay)) {
    if let Some(ray) = &mut recipe.viewpoint.shadow {
        turn(ray);
    }
}

type Convention = (fn(&mut Recipe), fn(&mut Naive));

const CONVENTIONS: [Convention; 6] = [
    (|_| {}, |_| {}),
    (|r| r.rounding = Rounding::Nearest, |n| n.round = true),
    (
        |r| r.viewpoint.sampling = Sampling::Center,
        |n| (n.middle, n.over_width) = (true, true),
    ),
    (
        |r| r.viewpoint.sampling = Sampling::CenterOfSteps,
        |n| n.middle = true,
    ),
    (
        |r| r.viewpoint.sampling = Sampling::Average,
        |n| (n.side, n.over_width) = (4, true),
    ),
    (
        |r| r.viewpoint.sampling = Sampling::AverageOfSteps,
        |n| n.side = 4,
    ),
];

const SIZE: (u32, u32) = (48, 36);

/// How far bytes are apart, going round: where they wrap, 255 is next to 0.
fn apart(a: u8, b: u8) -> u8 {
    let off = a.abs_diff(b);
    off.min(off.wrapping_neg())
}

/// The largest part of the pixels that are off by more than `tolerance`.
fn differing(recipe: &Recipe, naive: &Naive, tolerance: u8) -> f64 {
    let drawn = picture(recipe, size(SIZE.0, SIZE.1));
    let traced = naive.draw();
    let pairs = drawn.bytes().chunks(3).zip(traced.chunks(3));
    let differ = pairs.filter(|(a, b)| (0..3).any(|c| apart(a[c], b[c]) > tolerance));
    differ.count() as f64 / f64::from(SIZE.0 * SIZE.1)
}

/// In `f32` a ray may pass where in `f64` it hits, and a number may be truncated to the next byte:
/// one pixel in two hundred.
#[test]
fn every_mistake_in_every_convention() {
    for figure in ["1", "2a", "2b", "3c"] {
        for (name, turn, mistake) in MISTAKES {
            // Which comes first, the clamp or the curve, is a matter of taste above 1.
            let wraps = figure == "2a" && ["sRGB", "2.2"].contains(&name);
            // Figure 1 has no light with a power.
            let dark = figure == "1" && ["power", "pi"].contains(&name);
            // A row of n - 1 steps can be turned around by its place or by its number.
            let turns = ["mirrored", "upside down"].contains(&name);
            for (number, (convene, convention)) in CONVENTIONS.into_iter().enumerate() {
                let averages = number >= 4;
                let of_steps = [3, 5].contains(&number);
                if wraps
                    || dark
                    || turns && of_steps
                    || averages && (figure == "2a" || name == "Wrap")
                {
                    continue;
                }
                let (mut recipe, mut naive) =
                    (right(figure), Naive::figure(figure, SIZE.0, SIZE.1));
                turn(&mut recipe);
                convene(&mut recipe);
                mistake(&mut naive);
                convention(&mut naive);
                // Where a pixel is of one piece, its middle stands for its average.
                let tolerance = if averages { 2 } else { 0 };
                let part = differing(&recipe, &naive, tolerance);
                let words = format!("{figure} {name} in convention {number}: {part}");
                assert!(part <= 0.005, "{words}");
            }
        }
    }
}

/// What a pixel is said to show, and whether it is said to be lit, is what its colour says.
#[test]
fn objects_have_their_colours() {
    for sampling in [Sampling::Corner, Sampling::Center, Sampling::CenterOfSteps] {
        let mut recipe = right("3c");
        recipe.viewpoint.sampling = sampling;
        // So strong that no lit pixel is too dim for a byte.
        recipe.power = 1e6;
        for pixel in drawn(&recipe, size(SIZE.0, SIZE.1)) {
            let [red, green, blue] = pixel.rgb;
            let object = match pixel.rgb {
                [127, 127, 127] => Object::Background,
                [0, 0, 1..=255] => Object::Sphere,
                [1..=255, 0, 0] => Object::Plane,
                _ => pixel.object,
            };
            assert_eq!(pixel.object, object, "{pixel:?}");
            let is_lit = red.max(blue) > 0 && green == 0;
            assert_eq!(pixel.is_lit, is_lit, "{pixel:?}");
        }
    }
}

/// A pixel that is averaged shows what most of its rays meet, and is lit where all of them are: what
/// a picture four times as large shows ray by ray.
#[test]
fn averages_are_of_sixteen_rays() {
    let mut recipe = right("3c");
    recipe.viewpoint.sampling = Sampling::Center;
    let (width, height) = (SIZE.0 as usize, SIZE.1 as usize);
    let rays = drawn(&recipe, size(4 * SIZE.0, 4 * SIZE.1));
    recipe.viewpoint.sampling = Sampling::Average;
    let pixels = drawn(&recipe, size(SIZE.0, SIZE.1));
    let mut wrong = 0;
    for (at, pixel) in pixels.iter().enumerate() {
        let (x, y) = (at % width, at / width);
        let row = |k: usize| &rays[(4 * y + k) * 4 * width + 4 * x..][..4];
        let of: Vec<Drawn> = (0..4).flat_map(row).copied().collect();
        let same = of.iter().filter(|ray| ray.object == pixel.object).count();
        let is_lit = of.iter().all(|ray| ray.is_lit);
        assert!(same >= 7, "{x} {y}: {same} of 16");
        wrong += usize::from(same < 8 || is_lit != pixel.is_lit);
    }
    assert!(200 * wrong <= width * height, "{wrong}");
}

/// A pixel that is averaged is seen once where its corners show one surface in one light, that face it
/// alike and differ in radiance by no more than a tenth; elsewhere it is seen sixteen times. In a square
/// picture of one row and one column more, rays go through the corners.
#[test]
fn pixels_of_one_piece_are_seen_once() {
    let side = 96;
    for (figure, fov) in [("2a", 60.0), ("3c", 60.0), ("3c", 100.0)] {
        let mut view = right(figure).viewpoint;
        view.fov = fov;
        view.sampling = Sampling::Corner;
        let corners = surfels(&view, side + 1);
        view.sampling = Sampling::Average;
        let pixels = surfels(&view, side);
        let mut times = [0; 2];
        for y in 0..side {
            for x in 0..side {
                let corner = |x: u32, y: u32| corners[(y * (side + 1) + x) as usize][0];
                let four = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| corner(x + i, y + j));
                let kind = |s: Surfel| (s.object, s.is_shadowed, s.cosine > 0.0);
                let radiance = four.map(|s| s.cosine / s.distance.powi(2));
                let apart = radiance.map(|r| (r - radiance[0]).abs() / radiance[0].abs());
                let apart = apart.into_iter().fold(0.0, f32::max);
                let is_of_one = four.iter().all(|&s| kind(s) == kind(four[0]));
                let seen = pixels[(y * side + x) as usize].len();
                assert!([1, 16].contains(&seen), "{x} {y}: {seen}");
                // Nearer to a tenth than that, rounding in f32 decides.
                if (apart - 0.1).abs() > 1e-4 {
                    let once = is_of_one && apart < 0.1;
                    assert_eq!(seen == 1, once, "{x} {y}: {four:?}");
                    times[usize::from(once)] += 1;
                }
            }
        }
        assert!(times[0] > 200 && times[1] > 2000, "{times:?}");
    }
}

/// What each pixel of a square picture shows.
fn surfels(viewpoint: &Viewpoint, side: u32) -> Vec<Vec<Surfel>> {
    let black = Picture::black(size(side, side));
    let seen = whole(&black, &Lossless).surfels(viewpoint);
    let seen = seen.expect("a viewpoint");
    seen.pixels().map(<[Surfel]>::to_vec).collect()
}

fn drawn(recipe: &Recipe, size: Size) -> Vec<Drawn> {
    let black = Picture::black(size);
    whole(&black, &Lossless).drawn(recipe).expect("a viewpoint")
}
