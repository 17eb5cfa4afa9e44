//! Anything on a ray: the ends of the interval, tangents, and what policy ignores.

use super::any_hit::FORWARD;
use super::case::{Case, Ends, Line, Shape, plane, sphere};
use super::draw::Draw;
use super::{Family, family};

pub fn families() -> Vec<Family> {
    vec![
        family("sphere_near_root_at_tmax", 5, |d| {
            at_end(d, 4.0, |end| [0.0, end], ball())
        }),
        family("sphere_far_root_at_tmin", 5, |d| {
            at_end(d, 6.0, |end| [end, 100.0], ball())
        }),
        family("sphere_near_root_at_tmin", 5, |d| {
            at_end(d, 4.0, |end| [end, 5.0], ball())
        }),
        family("sphere_far_root_at_tmax_inside", 5, |d| {
            at_end(d, 6.0, |end| [4.5, end], ball())
        }),
        family("interval_inside_sphere", 5, |d| {
            let ulps = d.turn(&[3, 1, 0, -1, 1000]);
            Case::any_hit(
                FORWARD,
                [d.step(4.0, ulps), d.step(6.0, -ulps)],
                vec![ball()],
            )
            .note("ulp", ulps)
        }),
        family("plane_at_tmax", 5, |d| {
            at_end(d, 4.0, |end| [0.0, end], wall())
        }),
        family("plane_at_tmin", 5, |d| {
            at_end(d, 4.0, |end| [end, 9.0], wall())
        }),
        family("tangent_occluder", 7, |d| {
            let ulps = d.ulps();
            Case::any_hit(
                FORWARD,
                [0.0, 10.0],
                vec![sphere([d.step(1.0, ulps), 0.0, 5.0], 1.0)],
            )
            .note("ulp", ulps)
        }),
        family("tangent_occluder_radius", 7, |d| {
            let ulps = d.ulps();
            Case::any_hit(
                FORWARD,
                [0.0, 10.0],
                vec![sphere([3.0, 4.0, 5.0], d.step(5.0, ulps))],
            )
            .note("ulp", ulps)
        }),
        family("occluder_just_behind_light", 5, |d| {
            let steps = d.turn(&[1, 2, 3, 8, 100]);
            Case::any_hit(
                FORWARD,
                [0.0, 10.0],
                vec![sphere([0.0, 0.0, d.step(11.0, steps)], 1.0)],
            )
        }),
        family("occluder_just_before_light", 5, |d| {
            let steps = d.turn(&[1, 2, 3, 8, 100]);
            Case::any_hit(
                FORWARD,
                [0.0, 10.0],
                vec![sphere([0.0, 0.0, d.step(11.0, -steps)], 1.0)],
            )
        }),
        // New.
        family("point_interval", 5, |d| {
            at_end(d, 4.0, |end| [end, end], ball())
        }),
        family("negative_interval", 5, |d| {
            let ends = d.turn(&[
                [-10.0, 0.0],
                [-10.0, -7.0],
                [-5.5, -4.5],
                [-4.0, 4.0],
                [-6.0, -6.0],
            ]);
            Case::any_hit(FORWARD, ends, vec![sphere([0.0, 0.0, -5.0], 1.0)])
        }),
        family("tangent_at_end", 6, |d| {
            let ends = d.turn(&[[0.0, 5.0], [5.0, 10.0], [5.0, 5.0]]);
            let x = if d.index < 3 { 1.0 } else { d.step(1.0, -1) };
            Case::any_hit(FORWARD, ends, vec![sphere([x, 0.0, 5.0], 1.0)])
        }),
        family("ray_in_plane", 3, |d| {
            let normal = d.turn(&[[0.0, 1.0, 0.0], [3.0, -1.0, 0.0], [0.0, -0.1, 0.0]]);
            Case::any_hit(FORWARD, [0.0, 10.0], vec![plane([0.0, 0.0, 4.0], normal)])
        }),
        family("nonfinite_object_ignored", 8, |d| {
            let special = d.turn(&[f64::NAN, f64::INFINITY]);
            let bad = match d.index / 2 {
                0 => sphere([special, 0.0, 5.0], 1.0),
                1 => sphere([0.0, 0.0, 5.0], special),
                2 => plane([0.0, 0.0, special], [0.0, 0.0, 1.0]),
                _ => plane([0.0, 0.0, 4.0], [0.0, special, 1.0]),
            };
            beside(d, bad)
        }),
        family("zero_radius_ignored", 4, |d| {
            let radius = d.turn(&[0.0, -1.0, -0.0, -d.tiniest()]);
            beside(d, sphere([0.0, 0.0, 5.0], radius))
        }),
        family("zero_normal_ignored", 2, |d| {
            let normal = d.turn(&[[0.0; 3], [-0.0; 3]]);
            beside(d, plane([0.0, 0.0, 5.0], normal))
        }),
        family("nonfinite_ray", 6, |d| {
            let special = d.turn(&[f64::NAN, f64::INFINITY]);
            let (mut line, mut ends) = (FORWARD, [0.0, 10.0]);
            match d.index {
                0 | 1 => line.o[1] = special,
                2 | 3 => line.d[2] = special,
                4 => ends[0] = f64::NAN,
                _ => ends[1] = f64::NAN,
            }
            Case::any_hit(line, ends, vec![ball(), wall()])
        }),
        family("zero_direction", 2, |d| {
            let line = Line::new([0.0, 0.0, 5.0], d.turn(&[[0.0; 3], [-0.0; 3]]));
            Case::any_hit(line, [0.0, 10.0], vec![ball()])
        }),
    ]
}

/// Met at 4 and 6 straight ahead.
fn ball() -> Shape {
    sphere([0.0, 0.0, 5.0], 1.0)
}

/// Met at 4 straight ahead.
fn wall() -> Shape {
    plane([0.0, 0.0, 4.0], [0.0, 0.0, -1.0])
}

/// A root at exactly `t`, the end of the interval some ulps away.
fn at_end(d: &mut Draw, t: f64, ends: fn(f64) -> Ends, object: Shape) -> Case {
    let ulps = d.ulps();
    Case::any_hit(FORWARD, ends(d.step(t, ulps)), vec![object]).note("ulp", ulps)
}

/// An object that policy ignores, alone or before one that counts.
fn beside(d: &Draw, ignored: Shape) -> Case {
    let objs = if d.index.is_multiple_of(2) {
        vec![ignored]
    } else {
        vec![ignored, sphere([0.0, 0.0, 8.0], 1.0)]
    };
    Case::any_hit(FORWARD, [0.0, 10.0], objs)
}
