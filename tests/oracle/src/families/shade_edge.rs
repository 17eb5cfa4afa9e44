//! Shaded rays: where the camera is, the ends of the interval, and what policy ignores.

use super::case::{Case, Ends, Line, Shape, plane, sphere};
use super::draw::{Draw, unit};
use super::shade::{BLUE, ENDS, LAMP, RED, floor, lab, lamp};
use super::{Family, family};

pub fn families() -> Vec<Family> {
    vec![
        family("tmax_at_hit", 9, |d| at_end(d, |end| [0.0, end])),
        // New.
        family("tmin_at_hit", 5, |d| at_end(d, |end| [end, 1000.0])),
        family("reversed_interval", 2, |d| {
            let ends = d.turn(&[[10.0, 1.0], [2.0, 0.0]]);
            Case::shade(DOWN, vec![floor(-2.0)], LAMP, ends)
        }),
        family("camera_on_plane", 6, |d| {
            // The floor is at t = 0, outside the half-open interval.
            let direction = d.turn(&[[0.0, 1.0, 3.0], [0.0, -1.0, 1.0], [0.0, 0.0, 1.0]]);
            let objs = vec![sphere([0.0, -1.0, 3.0], 1.0).colored(BLUE), floor(-2.0)];
            let light = if d.index < 3 {
                LAMP.light
            } else {
                [0.5, -8.0, 0.0]
            };
            Case::shade(
                Line::new([0.0, -2.0, 0.0], direction),
                objs,
                lamp(light),
                ENDS,
            )
        }),
        family("camera_on_sphere", 6, |d| {
            // Inward the ray meets the sphere from inside; outward and along the tangent not at all.
            let direction = d.turn(&[[0.0, 0.0, 1.0], [0.0, 1.0, -1.0], [1.0, 0.0, 0.0]]);
            let light = if d.index < 3 {
                LAMP.light
            } else {
                [0.0, 0.0, 3.5]
            };
            Case::shade(
                Line::new([0.0, 0.0, 2.0], direction),
                lab(),
                lamp(light),
                ENDS,
            )
        }),
        family("camera_below_plane", 4, |d| {
            // The normal that faces the ray points down; the light is above or below.
            let light = d.turn(&[[1.0, 10.0, 1.0], [1.0, -10.0, 1.0]]);
            let line = Line::new(
                [0.0, -5.0, 0.0],
                unit([0.1, 1.0, d.turn(&[0.2, 0.2, -0.9, -0.9])]),
            );
            Case::shade(line, lab(), lamp(light), ENDS)
        }),
        family("tangent_primary_ray", 5, |d| {
            let ulps = d.ulps();
            let line = Line::new([0.0, d.step(1.0, ulps), -2.0], [0.0, 0.0, 1.0]);
            Case::shade(line, lab(), LAMP, ENDS).note("ulp", ulps)
        }),
        family("tie_sphere_plane", 4, |d| {
            // A plane that touches the sphere where the ray hits both, in either order.
            let wall = plane([0.0, 0.0, 2.0], [0.0, 0.0, -1.0]).colored(RED);
            let ball = sphere([0.0, 0.0, 3.0], 1.0).colored(BLUE);
            let objs = if d.index.is_multiple_of(2) {
                vec![ball, wall]
            } else {
                vec![wall, ball]
            };
            let light = if d.index < 2 {
                [1.0, 2.0, -1.0]
            } else {
                [0.0, 0.0, 5.0]
            };
            Case::shade(
                Line::new([0.0, 0.0, -2.0], [0.0, 0.0, 1.0]),
                objs,
                lamp(light),
                ENDS,
            )
        }),
        family("coincident_planes_two_colors", 4, |d| {
            let objs = vec![
                plane([3.0, -2.0, 7.0], [0.0, d.turn(&[-5.0, 1.0]), 0.0]).colored(BLUE),
                floor(-2.0),
            ];
            Case::shade(
                Line::new([0.0, 0.0, -2.0], [[0.0, 1.0][d.index / 2], -1.0, 1.5]),
                objs,
                LAMP,
                ENDS,
            )
        }),
        family("coincident_shells_inside", 3, |d| {
            let shell = || sphere([0.0; 3], 5.0).colored(BLUE);
            let line = Line::new([0.0, 0.3, -3.5], d.unit());
            Case::shade(line, vec![shell(), shell()], lamp([1.0, 2.0, 0.5]), ENDS)
        }),
        family("near_coincident_planes", 6, |d| {
            // A second floor some ulps below or above the first.
            let ulps = d.turn(&[-1, 1, -4, 4, -64, 64]);
            let second = plane([0.0, d.step(-2.1, ulps), 0.0], [0.0, 1.0, 0.0]).colored(BLUE);
            let line = Line::new([0.0, 0.3, -2.0], unit([0.2, -0.6, 1.0]));
            Case::shade(line, vec![floor(-2.1), second], LAMP, ENDS).note("ulp", ulps)
        }),
        family("unnormalised_normal", 5, |d| {
            let n = d.turn(&[1e3, 1e-3, -7.0, 1e15, 1e-15]);
            let tilted = plane([0.3, -2.1, 0.7], [0.1 * n, n, 0.2 * n]).colored(RED);
            let line = Line::new([0.0, 0.0, -2.0], unit([0.1, -0.5, 1.0]));
            Case::shade(line, vec![tilted], LAMP, ENDS)
        }),
        family("negzero_inputs", 3, |d| {
            let zero = -0.0;
            let objs = vec![
                sphere([zero, zero, 3.0], 1.0).colored([zero, zero, 1.0]),
                floor(-2.0),
            ];
            let line = Line::new(
                [zero, zero, d.turn(&[-2.0, zero, zero])],
                [zero, d.turn(&[zero, zero, -1.0]), 1.0],
            );
            Case::shade(line, objs, LAMP, [zero, 1000.0])
        }),
        family("nonfinite_ray", 6, |d| {
            let special = d.turn(&[f64::NAN, f64::INFINITY]);
            let (mut line, mut ends) = (DOWN, ENDS);
            match d.index {
                0 | 1 => line.o[0] = special,
                2 | 3 => line.d[1] = special,
                4 => ends[0] = f64::NAN,
                _ => ends[1] = f64::NAN,
            }
            Case::shade(line, lab(), LAMP, ends)
        }),
        family("zero_direction", 2, |d| {
            let line = Line::new([0.0, 0.0, 3.0], d.turn(&[[0.0; 3], [-0.0; 3]]));
            Case::shade(line, lab(), LAMP, ENDS)
        }),
        family("ignored_object", 8, |d| {
            let ignored = match d.index {
                0 => sphere([0.0, 5.0, 0.0], f64::NAN),
                1 => sphere([f64::INFINITY, 5.0, 0.0], 1.0),
                2 => sphere([0.0, 5.0, 0.0], 0.0),
                3 => sphere([0.0, 5.0, 0.0], -1.0),
                4 => plane([0.0, 5.0, 0.0], [0.0; 3]),
                5 => plane([0.0, f64::NAN, 0.0], [0.0, 1.0, 0.0]),
                6 => plane([0.0, 5.0, 0.0], [0.0, f64::INFINITY, 0.0]),
                _ => sphere([0.0, -1.0, 0.0], f64::INFINITY),
            };
            overhead(ignored)
        }),
        family("infinite_tmax", 3, |d| {
            let direction = d.turn(&[[0.0, 0.0, 1.0], [0.0, -1e-6, 1.0], [0.0, 1e-6, 1.0]]);
            Case::shade(
                Line::new([5.0, 0.0, -2.0], direction),
                lab(),
                LAMP,
                [0.0, f64::INFINITY],
            )
        }),
        family("background", 5, |d| {
            let background = d.turn(&[0.0, 1.0, -0.5, 7.0, 1.0 / 3.0]);
            let up = Line::new([0.0; 3], [0.0, 1.0, 0.0]);
            Case::shade(
                up,
                vec![floor(-2.0)],
                super::case::Lamp { background, ..LAMP },
                ENDS,
            )
        }),
        family("empty", 1, |_| Case::shade(DOWN, Vec::new(), LAMP, ENDS)),
    ]
}

const DOWN: Line = Line::new([0.0; 3], [0.0, -1.0, 0.0]);

/// The plane is hit at exactly 2, the end of the interval some ulps away.
fn at_end(d: &mut Draw, ends: fn(f64) -> Ends) -> Case {
    let ulps = d.ulps();
    Case::shade(DOWN, vec![floor(-2.0)], LAMP, ends(d.step(2.0, ulps))).note("ulp", ulps)
}

/// Straight down at the plane, the light straight above, an object between that policy ignores.
fn overhead(ignored: Shape) -> Case {
    Case::shade(
        DOWN,
        vec![ignored.colored(BLUE), floor(-2.0)],
        lamp([0.0, 10.0, 0.0]),
        ENDS,
    )
}
