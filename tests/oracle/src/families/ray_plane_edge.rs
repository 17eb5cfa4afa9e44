//! Rays and planes: parallels, the ends of the interval, and the edges of the format.

use super::case::{AHEAD, Case, Ends, Line};
use super::draw::{Draw, add, cross, scale, sub};
use super::{Family, family};
use crate::{Plane, Ray};

pub fn families() -> Vec<Family> {
    vec![
        family("parallel", 4, |d| parallel(d, [0.0, 1.0, 0.0])),
        family("parallel_in_plane", 4, |d| parallel(d, [0.0, 0.0, 0.0])),
        family("parallel_cancelling", 5, |d| cancelling(d, 0)),
        family("almost_parallel_cancelling", 8, |d| {
            let ulps = d.turn(&[1, -1, 2, -2, 3, -3, 8, -8]);
            cancelling(d, ulps).note("ulp", ulps)
        }),
        family("parallel_inexact_products", 6, inexact_products),
        family("parallel_inexact_products3", 6, inexact_products3),
        family("behind", 4, |d| straight(d, 1.0, 1.0, AHEAD)),
        family("back_face", 4, |d| straight(d, -1.0, 1.0, AHEAD)),
        family("at_tmax", 9, |d| at_end(d, |end| [0.0, end])),
        family("at_tmin", 9, |d| at_end(d, |end| [end, 10.0])),
        family("at_tmax_rounded", 9, at_tmax_rounded),
        family("nonfinite", 12, nonfinite),
        family("zero_direction", 4, zero_direction),
        family("zero_normal", 3, |d| {
            let normal = d.turn(&[[0.0; 3], [-0.0; 3], [0.0, -0.0, 0.0]]);
            Case::ray_plane(DOWN, [0.0; 3], normal, AHEAD)
        }),
        family("denormal_direction", 5, |d| {
            let direction = d.turn(&[1.0, 2.0, 3.0, 1000.0, 4_000_000.0]) * d.tiniest();
            vertical(1.0, -direction, 1.0)
        }),
        family("denormal_origin", 4, |d| {
            vertical(d.turn(&[1.0, 2.0, 7.0, 1e6]) * d.tiniest(), -1.0, 1.0)
        }),
        family("denormal_normal", 4, |d| {
            vertical(1.0, -1.0, d.turn(&[1.0, 2.0, 5.0, -3.0]) * d.tiniest())
        }),
        family("denormal_products", 5, |d| {
            let direction = d.turn(&[1.0, 0.5, 2.0, 0.75, 1.5]) * d.smallest();
            vertical(1.0, -direction, d.smallest())
        }),
        family("overflow_products", 5, |d| {
            let huge = d.by(1e30, 1e300) * d.turn(&[1.0, 10.0, 0.1, 3.0, 7.0]);
            vertical(huge, -1.0, huge)
        }),
        family("negzero_direction", 5, negzero_direction),
        // New.
        family("negzero_inputs", 4, negzero_inputs),
        family("subnormal_cosine", 5, |d| {
            // The product of direction and normal is subnormal, or 0 in floats, and not 0.
            let root = d.turn(&[1.0, 0.25, 1e-2, 1e-3, 1e-4]) * d.by(1e-20, 1e-155);
            vertical(1.0, -root, root)
        }),
        family("overflow_difference", 4, |d| {
            let huge = d.largest() * d.turn(&[1.0, 0.75]);
            let sign = if d.index < 2 { -1.0 } else { 1.0 };
            let line = Line::new([0.0, huge, 0.0], [0.0, sign, 0.0]);
            Case::ray_plane(line, [0.0, -huge, 0.0], [0.0, 1.0, 0.0], AHEAD)
        }),
        family("overflow_in_one_product", 4, |d| {
            // Two huge products cancel; the small one decides.
            let huge = d.by(1e25, 1e200);
            let line = Line::new(
                [0.0, d.turn(&[1.0, 2.0, 0.5, 3.0]), 0.0],
                [huge, -1.0, huge],
            );
            Case::ray_plane(line, [0.0; 3], [huge, 1.0, -huge], AHEAD)
        }),
        family("reversed_interval", 3, |d| {
            let ends = d.turn(&[[5.0, 0.0], [9.0, 2.0], [d.largest(), 0.0]]);
            straight(d, 1.0, -1.0, ends)
        }),
        family("point_interval", 9, |d| at_end(d, |end| [end, end])),
        family("negative_interval", 6, |d| {
            let ends = d.turn(&[[-10.0, 10.0], [-10.0, -0.5], [-0.25, 10.0]]);
            straight(d, 1.0, 1.0, ends)
        }),
        family("largest_tmax", 4, |d| {
            let t = d.turn(&[1.0, 0.5]);
            let line = Line::new([0.0, t * d.largest(), 0.0], [0.0, -1.0, 0.0]);
            let tmax = if d.index < 2 {
                d.largest()
            } else {
                d.step(t * d.largest(), -1)
            };
            Case::ray_plane(line, [0.0; 3], [0.0, 1.0, 0.0], [0.0, tmax])
        }),
        family("in_tilted_plane", 6, in_tilted_plane),
    ]
}

/// Straight down from above the plane y = 0.
const DOWN: Line = Line::new([0.0, 1.0, 0.0], [0.0, -1.0, 0.0]);

fn vertical(o: f64, d: f64, n: f64) -> Case {
    Case::ray_plane(
        Line::new([0.0, o, 0.0], [0.0, d, 0.0]),
        [0.0; 3],
        [0.0, n, 0.0],
        AHEAD,
    )
}

fn parallel(d: &mut Draw, height: [f64; 3]) -> Case {
    let direction = d.turn(&[
        [1.0, 0.0, 0.0],
        [0.0, 0.0, -2.0],
        [0.3, 0.0, 0.7],
        [1e-30, 0.0, 1e30],
    ]);
    let q = [d.turn(&[0.0, 5.0, -7.0, 0.1]), 0.0, d.turn(&[0.0, 1.0])];
    Case::ray_plane(Line::new(height, direction), q, [0.0, 1.0, 0.0], AHEAD)
}

/// `dot(d, n)` is a difference of equal products, or of products some ulps apart.
fn cancelling(d: &mut Draw, ulps: i64) -> Case {
    let size = d.turn(&[1.0, 3.0, 0.1, 1e5, 1e-5]);
    let direction = [size, d.step(size, ulps), 0.0];
    Case::ray_plane(
        Line::new([0.0, 1.0, 0.0], direction),
        [0.0; 3],
        [1.0, -1.0, 0.0],
        AHEAD,
    )
}

/// Exactly parallel, though the products round.
fn inexact_products(d: &mut Draw) -> Case {
    let (a, b) = d.turn(&[
        (0.1, 0.3),
        (0.7, 0.9),
        (1.0 / 3.0, 1.0 / 7.0),
        (1e-3, 123.4),
        (5.3, 2.9),
        (0.2, 0.6),
    ]);
    Case::ray_plane(
        Line::new([0.0, 1.0, 0.0], [a, b, 0.0]),
        [0.0; 3],
        [b, -a, 0.0],
        AHEAD,
    )
}

fn inexact_products3(d: &mut Draw) -> Case {
    let (a, b, c) = match d.index {
        0 => (1.0 / 3.0, 1.0 / 7.0, 1.0 / 11.0),
        _ => (d.number(0.0, 1.0), d.number(0.0, 1.0), d.number(0.0, 1.0)),
    };
    let normal = d.turn(&[[b, -a, 0.0], [0.0, c, -b], [-c, 0.0, a]]);
    Case::ray_plane(
        Line::new([0.0, 1.0, 0.0], [a, b, c]),
        [1.0, 2.0, 3.0],
        normal,
        AHEAD,
    )
}

/// From above (1) or below (-1) the plane y = 0, up (1) or down (-1).
fn straight(d: &mut Draw, side: f64, direction: f64, ends: Ends) -> Case {
    let height = side * d.turn(&[1.0, 0.3, 7.0, 1e-3]);
    let line = Line::new([0.0, height, 0.0], [0.0, direction, 0.0]);
    Case::ray_plane(
        line,
        [0.0; 3],
        [0.0, if d.index < 2 { 1.0 } else { -1.0 }, 0.0],
        ends,
    )
}

/// The hit is at exactly 3, the end of the interval some ulps away.
fn at_end(d: &mut Draw, ends: fn(f64) -> Ends) -> Case {
    let ulps = d.ulps();
    let line = Line::new([0.0, 3.0, 0.0], [0.0, -1.0, 0.0]);
    Case::ray_plane(line, [0.0; 3], [0.0, 1.0, 0.0], ends(d.step(3.0, ulps))).note("ulp", ulps)
}

/// The interval ends where t rounds to, or an ulp beside: only exact arithmetic can tell.
fn at_tmax_rounded(d: &mut Draw) -> Case {
    let mut direction = d.unit();
    direction[1] = -d.number(0.05, 0.9);
    let (o, q, n) = ([0.0, 0.0, -2.0], [0.0, -2.0, 0.0], [0.0, 1.0, 0.0]);
    let ray = Ray::new(o, direction, 0.0, f64::INFINITY);
    let t = ray
        .zip(Plane::new(q, n))
        .and_then(|(ray, plane)| plane.meet(&ray).t);
    let ulps = d.turn(&[0, -1, 1]);
    let tmax = d.step(t.map_or(0.0, |t| d.format.round(&t)), ulps);
    Case::ray_plane(Line::new(o, direction), q, n, [0.0, tmax]).note("ulp", ulps)
}

/// One NaN or infinity, everywhere in turn.
fn nonfinite(d: &mut Draw) -> Case {
    let special = d.turn(&[
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        f64::INFINITY,
    ]);
    let (mut line, mut q, mut n, mut ends) = (DOWN, [0.0, -2.0, 0.0], [0.0, 1.0, 0.0], AHEAD);
    match d.index {
        0..3 => line.o[d.index] = special,
        3..6 => line.d[d.index - 3] = special,
        6..8 => q[d.index - 6] = special,
        8..10 => n[d.index - 8] = special,
        10 => ends[0] = f64::NAN,
        _ => ends[1] = f64::NAN,
    }
    Case::ray_plane(line, q, n, ends)
}

fn zero_direction(d: &mut Draw) -> Case {
    let direction = d.turn(&[[0.0; 3], [-0.0; 3], [0.0, -0.0, 0.0]]);
    let o = [0.0, d.turn(&[1.0, 0.0]), 0.0];
    Case::ray_plane(Line::new(o, direction), [0.0; 3], [0.0, 1.0, 0.0], AHEAD)
}

/// A zero of either sign against the normal: parallel.
fn negzero_direction(d: &mut Draw) -> Case {
    let direction = d.turn(&[
        [1.0, 0.0, 0.0],
        [1.0, -0.0, 0.0],
        [-1.0, -0.0, 0.0],
        [-0.0, -0.0, 1.0],
        [1.0, -0.0, -0.0],
    ]);
    Case::ray_plane(
        Line::new([0.0, 1.0, 0.0], direction),
        [0.0; 3],
        [0.0, 1.0, 0.0],
        AHEAD,
    )
}

/// Zeros of the other sign where they change nothing.
fn negzero_inputs(d: &mut Draw) -> Case {
    let zero = -0.0;
    let line = Line::new([zero, d.turn(&[1.0, zero]), zero], [zero, -1.0, zero]);
    let ends = if d.index < 2 {
        [zero, f64::INFINITY]
    } else {
        [zero, zero]
    };
    Case::ray_plane(line, [zero; 3], [zero, 1.0, zero], ends)
}

/// The ray runs inside a plane that is not aligned with any axis; small integers keep it exact.
fn in_tilted_plane(d: &mut Draw) -> Case {
    let whole = |d: &mut Draw| [(); 3].map(|()| d.number(-9.0, 9.0).round());
    let (n, other, q) = (
        add(whole(d), [0.0, 10.0, 0.0]),
        add(whole(d), [10.0, 0.0, 0.0]),
        whole(d),
    );
    let direction = cross(n, other);
    let o = sub(q, scale(direction, d.turn(&[1.0, 0.0, 2.0])));
    Case::ray_plane(Line::new(o, direction), q, n, AHEAD)
}
