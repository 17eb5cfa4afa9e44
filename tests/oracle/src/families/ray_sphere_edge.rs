//! Rays and spheres: the ends of the interval, and the edges of the format.

use super::case::{AHEAD, Case, Ends, Line};
use super::draw::{Draw, scale};
use super::{Family, family};
use crate::{Ray, Real, Sphere};

pub fn families() -> Vec<Family> {
    vec![
        family("at_tmax", 9, |d| at_end(d, 4.0, |end| [0.0, end])),
        family("at_tmin", 9, |d| at_end(d, 4.0, |end| [end, 100.0])),
        family("at_tmin_far_root", 9, |d| {
            at_end(d, 6.0, |end| [end, 100.0])
        }),
        family("nonfinite", 12, nonfinite),
        family("zero_direction", 3, |d| zero_direction(d, [0.0; 3])),
        family("zero_direction_inside", 3, |d| {
            zero_direction(d, [0.0, 0.0, 3.0])
        }),
        family("zero_or_negative_radius", 6, |d| {
            let radius = d.turn(&[0.0, -0.0, -1.0, -d.tiniest(), f64::NAN, f64::NEG_INFINITY]);
            Case::ray_sphere(FORWARD, [0.0, 0.0, 3.0], radius, AHEAD)
        }),
        family("denormal_radius", 5, |d| {
            along_z(
                [1.0, 3.0],
                d.turn(&[1.0, 2.0, 3.0, 1000.0, 4e6]) * d.tiniest(),
            )
        }),
        family("radius_squared_underflows", 5, |d| {
            along_z(
                [1.0, 3.0],
                d.turn(&[1.0, 0.1, 1e-3, 10.0, 1e3]) * d.by(9.358_480_166_273_04e-24, 5.5569e-163),
            )
        }),
        family("all_tiny", 5, |d| {
            let unit = d.smallest();
            along_z([1.0, 8.0 * unit], d.turn(&[1.0, 0.5, 2.0, 7.0, 8.0]) * unit)
        }),
        family("tiny_direction", 5, |d| {
            along_z(
                [d.smallest() * d.turn(&[4.0, 1.0, 64.0, 0.5, 3.0]), 3.0],
                1.0,
            )
        }),
        family("overflow_squares", 5, |d| {
            let size = d.by(1e30, 1e200);
            let line = Line::new([0.0, 0.0, -size], [0.0, 0.0, 1.0]);
            Case::ray_sphere(
                line,
                [0.0; 3],
                size * d.turn(&[0.25, 0.5, 1e-3, 1.0, 2.0]),
                AHEAD,
            )
        }),
        family("overflow_direction", 5, |d| {
            along_z(
                [
                    d.by(1e30, 1e200) * d.turn(&[1.0, 1e-10, 10.0, 1e5, 3.0]),
                    3.0,
                ],
                1.0,
            )
        }),
        family("huge_distance", 5, |d| {
            let distance = d.by(3e19, 3e160) * d.turn(&[1.0, 0.1, 10.0, 1e3, 1e-5]);
            let line = Line::new([0.0, 0.0, -distance], [0.0, 0.0, 1.0]);
            Case::ray_sphere(line, [0.0; 3], d.turn(&[1.0, 1e6]), AHEAD)
        }),
        // New.
        family("at_tmax_far_root_inside", 5, |d| {
            let ulps = d.ulps();
            let line = Line::new([0.0, 0.0, 3.0], [0.0, 0.0, 1.0]);
            Case::ray_sphere(line, [0.0, 0.0, 3.0], 1.0, [0.0, d.step(1.0, ulps)]).note("ulp", ulps)
        }),
        family("at_tmax_rounded", 9, |d| at_rounded_root(d, 0)),
        family("at_tmin_rounded_far_root", 9, |d| at_rounded_root(d, 1)),
        family("point_interval", 5, |d| at_end(d, 4.0, |end| [end, end])),
        family("reversed_interval", 3, |d| {
            Case::ray_sphere(
                FORWARD,
                [0.0, 0.0, 3.0],
                1.0,
                d.turn(&[[5.0, 0.0], [4.0, 2.0], [3.0, 3.0]]),
            )
        }),
        family("negative_interval", 5, |d| {
            let center = [0.0, 0.0, d.turn(&[-3.0, 0.5, 3.0])];
            Case::ray_sphere(
                FORWARD,
                center,
                1.0,
                d.turn(&[
                    [-10.0, 10.0],
                    [-3.0, -1.0],
                    [-10.0, -2.0],
                    [-1.5, 0.0],
                    [-0.5, 1.0],
                ]),
            )
        }),
        family("negzero_inputs", 4, |d| {
            let zero = -0.0;
            let line = Line::new([zero; 3], [zero, zero, d.turn(&[1.0, -1.0])]);
            Case::ray_sphere(
                line,
                [zero, zero, d.turn(&[1.0, 1.0, 3.0, -3.0])],
                1.0,
                [zero, f64::INFINITY],
            )
        }),
        family("subnormal_direction", 6, |d| {
            let length = d.turn(&[1.0, 2.0, 5.0, 1000.0, 1e5, 3e6]) * d.tiniest();
            along_z([length, 3.0], 1.0)
        }),
        family("subnormal_oblique_direction", 5, |d| {
            let direction = d.turn(&[
                [1.0, 2.0, 5.0],
                [0.0, 1.0, 3.0],
                [1.0, -1.0, 9.0],
                [300.0, 100.0, 1000.0],
                [2.0, 0.0, 4.0],
            ]);
            Case::ray_sphere(
                Line::new([0.0; 3], scale(direction, d.tiniest())),
                [0.5, 0.25, 3.0],
                1.0,
                AHEAD,
            )
        }),
        family("overflow_difference", 4, |d| {
            let huge = d.largest() * d.turn(&[1.0, 0.75]);
            let line = Line::new([0.0, 0.0, -huge], [0.0, 0.0, 1.0]);
            Case::ray_sphere(
                line,
                [0.0, 0.0, huge],
                huge * d.turn(&[0.5, 0.5, 1.0, 1.0]),
                AHEAD,
            )
        }),
        family("overflow_product_inside", 4, |d| {
            // |f|² and r² both overflow, their difference decides.
            let size = d.by(1e25, 1e180);
            let line = Line::new(
                [0.0, 0.0, d.turn(&[0.5, 0.999, 1.0, 1.001]) * size],
                [0.0, 0.0, -1.0],
            );
            Case::ray_sphere(line, [0.0; 3], size, AHEAD)
        }),
        family("shell_around_origin_ulp", 5, |d| {
            let ulps = d.ulps();
            let line = Line::new([0.0, 0.0, 1.0], [0.6, 0.0, -0.8]);
            Case::ray_sphere(line, [0.0; 3], d.step(1.0, ulps), AHEAD).note("ulp", ulps)
        }),
    ]
}

const FORWARD: Line = Line::new([0.0; 3], [0.0, 0.0, 1.0]);

/// Down the z axis from the origin, with a direction and a centre at the given z.
fn along_z([direction, center]: [f64; 2], radius: f64) -> Case {
    Case::ray_sphere(
        Line::new([0.0; 3], [0.0, 0.0, direction]),
        [0.0, 0.0, center],
        radius,
        AHEAD,
    )
}

/// A root at exactly `t` (4 or 6), the end of the interval some ulps away.
fn at_end(d: &mut Draw, t: f64, ends: fn(f64) -> Ends) -> Case {
    let ulps = d.ulps();
    let line = Line::new([0.0, 0.0, -2.0], [0.0, 0.0, 1.0]);
    Case::ray_sphere(line, [0.0, 0.0, 3.0], 1.0, ends(d.step(t, ulps))).note("ulp", ulps)
}

/// The interval ends where an irrational root rounds to, or an ulp beside: only exact arithmetic can tell.
fn at_rounded_root(d: &mut Draw, which: usize) -> Case {
    let line = Line::new(
        [d.number(-0.8, 0.8), d.number(-0.5, 0.5), -2.0],
        [0.0, 0.0, 1.0],
    );
    let center = [0.0, 0.0, 3.0];
    let ray = Ray::new(line.o, line.d, 0.0, f64::INFINITY);
    let roots = ray
        .zip(Sphere::new(center, 1.0))
        .and_then(|(ray, sphere)| sphere.meet(&ray).roots);
    let t = roots.map_or(0.0, |roots| {
        Real::from(roots[which].clone()).round(d.format)
    });
    let ulps = d.turn(&[0, -1, 1]);
    let end = d.step(t, ulps);
    Case::ray_sphere(
        line,
        center,
        1.0,
        if which == 0 { [0.0, end] } else { [end, 100.0] },
    )
    .note("ulp", ulps)
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
    let (mut line, mut center, mut radius, mut ends) = (FORWARD, [0.0, 0.0, 3.0], 1.0, AHEAD);
    match d.index {
        0..3 => line.o[d.index] = special,
        3..6 => line.d[d.index - 3] = special,
        6..9 => center[d.index - 6] = special,
        9 => radius = f64::INFINITY,
        10 => ends[0] = f64::NAN,
        _ => ends[1] = f64::NAN,
    }
    Case::ray_sphere(line, center, radius, ends)
}

fn zero_direction(d: &mut Draw, o: [f64; 3]) -> Case {
    let direction = d.turn(&[[0.0; 3], [-0.0; 3], [0.0, -0.0, 0.0]]);
    Case::ray_sphere(Line::new(o, direction), [0.0, 0.0, 3.0], 1.0, AHEAD)
}
