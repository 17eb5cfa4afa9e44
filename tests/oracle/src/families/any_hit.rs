//! Anything on a ray: surfaces at the origin, ties, and scenes.

use super::case::{AHEAD, Case, Line, Shape, plane, sphere};
use super::draw::{Draw, add, sub, unit};
use super::{Family, family};

pub fn families() -> Vec<Family> {
    vec![
        family("origin_on_plane_t0", 5, |d| {
            let normal = d.turn(&[
                [0.0, 0.0, 1.0],
                [0.0, 0.0, -1.0],
                [0.0, 1.0, 2.0],
                [3.0, 0.0, -0.1],
                [0.0, 0.0, 1e-3],
            ]);
            Case::any_hit(FORWARD, [0.0, 5.0], vec![plane([0.0; 3], normal)])
        }),
        family("origin_on_sphere_t0", 4, |d| on_sphere(d, -1.0, 5.0)),
        family("origin_on_sphere_through", 4, |d| on_sphere(d, 1.0, 5.0)),
        family("origin_on_sphere_far_root_beyond", 4, |d| {
            let tmax = d.turn(&[1.5, 0.9, 1e-3, 0.499]);
            on_sphere(d, 1.0, tmax)
        }),
        family("coincident_planes", 5, |d| {
            let direction = unit([0.3, -1.0, d.turn(&[0.2, -0.7])]);
            let (q, n) = d.turn(&[
                ([5.0, 0.0, 1.0], -2.0),
                ([0.0; 3], 1.0),
                ([1e6, 0.0, -1e6], 1e-3),
            ]);
            let objs = vec![plane([0.0; 3], [0.0, 1.0, 0.0]), plane(q, [0.0, n, 0.0])];
            Case::any_hit(Line::new([0.0, 2.0, 0.0], direction), [0.0, 50.0], objs)
        }),
        family("coincident_spheres", 5, |d| {
            let x = d.turn(&[0.0, 0.3, 0.9, 0.25, -0.7]);
            Case::any_hit(
                Line::new([x, 0.0, -5.0], FORWARD.d),
                [0.0, 50.0],
                vec![sphere([0.0; 3], 1.0), sphere([0.0; 3], 1.0)],
            )
        }),
        family("tie_sphere_plane", 4, |d| {
            tie(d, |r| plane([0.0, 0.0, -r], [0.0, 0.0, -1.0]))
        }),
        family("tie_internally_tangent_spheres", 4, |d| {
            tie(d, |r| sphere([0.0, 0.0, r], 2.0 * r))
        }),
        family("empty", 1, |_| {
            Case::any_hit(FORWARD, [0.0, 10.0], Vec::new())
        }),
        family("behind", 3, |d| {
            let z = d.turn(&[-1.0, -0.25, -7.0]);
            let objs = vec![
                sphere([0.0, 0.0, 5.0 * z], 1.0),
                plane([0.0, 0.0, z], [0.0, 0.0, 1.0]),
            ];
            Case::any_hit(FORWARD, [0.0, 10.0], objs)
        }),
        family("reversed_interval", 4, |d| {
            let ends = d.turn(&[[10.0, 2.0], [6.0, 4.0], [5.0, -1.0], [100.0, 0.0]]);
            Case::any_hit(
                FORWARD,
                ends,
                vec![
                    sphere([0.0, 0.0, 5.0], 1.0),
                    plane([0.0, 0.0, 5.0], [0.0, 0.0, 1.0]),
                ],
            )
        }),
        family("inside_nested", 5, |d| {
            let tmax = d.turn(&[1.5, 2.0, 2.5, 3.0, 10.0]);
            Case::any_hit(
                FORWARD,
                [0.0, tmax],
                vec![sphere([0.0; 3], 3.0), sphere([0.0; 3], 2.0)],
            )
        }),
        family("stack16", 4, stack16),
        family("random6", 12, random6),
        // New.
        family("direction_1e15", 3, |d| lengthened(d, 1e15)),
        family("direction_1e-15", 3, |d| lengthened(d, 1e-15)),
        family("segment_to_light", 10, segment_to_light),
        family("first_object_misses", 4, |d| {
            let missed = d.turn(&[[0.0, 5.0, 5.0], [9.0, 0.0, 1.0]]);
            let target = if d.index < 2 {
                sphere([0.0, 0.0, 5.0], 1.0)
            } else {
                plane([0.0, 0.0, 5.0], [0.0, 1.0, -1.0])
            };
            Case::any_hit(
                FORWARD,
                [0.0, 10.0],
                vec![
                    sphere(missed, 1.0),
                    plane([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]),
                    target,
                ],
            )
        }),
        family("infinite_tmax", 3, |d| {
            let normal = d.turn(&[[0.0, 1.0, 0.0], [0.0, 1.0, -1e-6], [0.0, 1.0, 1e-6]]);
            Case::any_hit(FORWARD, AHEAD, vec![plane([0.0, -2.0, 0.0], normal)])
        }),
        family("near_coincident_planes", 5, |d| {
            let ulps = d.ulps();
            let objs = vec![
                plane([0.0, 0.0, 4.0], [0.0, 0.0, 1.0]),
                plane([0.0, 0.0, d.step(4.0, ulps)], [0.0, 0.0, -1.0]),
            ];
            Case::any_hit(FORWARD, [0.0, 4.0], objs).note("ulp", ulps)
        }),
    ]
}

pub const FORWARD: Line = Line::new([0.0; 3], [0.0, 0.0, 1.0]);

/// From a sphere's surface, out of it (-1) or through it (1).
fn on_sphere(d: &mut Draw, z: f64, tmax: f64) -> Case {
    let radius = d.turn(&[1.0, 0.5, 2.0, 0.25]);
    let line = Line::new([0.0; 3], [0.0, 0.0, z]);
    Case::any_hit(line, [0.0, tmax], vec![sphere([0.0, 0.0, radius], radius)])
}

/// A sphere about the origin and something else that the ray meets at exactly the same t; in either order.
fn tie(d: &mut Draw, other: fn(f64) -> Shape) -> Case {
    let radius = d.turn(&[1.0, 1.0, 0.25, 3.0]);
    let mut objs = vec![sphere([0.0; 3], radius), other(radius)];
    if d.index % 2 == 1 {
        objs.reverse();
    }
    Case::any_hit(Line::new([0.0, 0.0, -5.0], FORWARD.d), [0.0, 50.0], objs)
}

/// Sixteen spheres that touch one another, on a plane.
fn stack16(d: &mut Draw) -> Case {
    let o = [d.number(-0.5, 0.5), 0.0, -5.0];
    let target = [d.number(-1.0, 1.0), d.number(0.0, 16.0), 8.0];
    let mut objs: Vec<Shape> = (0..16)
        .map(|k| sphere([0.0, 2.0 * f64::from(k) - 1.0, 8.0], 1.0))
        .collect();
    objs.push(plane([0.0, -2.0, 0.0], [0.0, 1.0, 0.0]));
    Case::any_hit(Line::new(o, unit(sub(target, o))), [0.0, 40.0], objs)
}

fn random6(d: &mut Draw) -> Case {
    let line = Line::new(d.point(4.0), d.unit());
    let mut objs: Vec<Shape> = (0..6)
        .map(|_| sphere(d.point(6.0), d.number(0.3, 2.0)))
        .collect();
    objs.push(plane([0.0, -7.0, 0.0], [0.0, 1.0, 0.0]));
    Case::any_hit(line, [0.0, d.number(5.0, 20.0)], objs)
}

fn lengthened(d: &mut Draw, length: f64) -> Case {
    let center = d.turn(&[[0.0, 0.0, 5.0], [0.5, 0.0, 5.0], [2.0, 0.0, 5.0]]);
    let line = Line::new([0.0; 3], [0.0, 0.0, length]);
    Case::any_hit(
        line,
        [0.0, 10.0 / length],
        vec![sphere(center, 1.0), plane([0.0, 0.0, 9.0], [0.0, 0.5, 1.0])],
    )
}

/// The direction runs from the point to the light, which is at t = 1.
fn segment_to_light(d: &mut Draw) -> Case {
    let (p, light) = (
        [d.number(-3.0, 3.0), -2.0, d.number(1.0, 6.0)],
        [1.0, 10.0, 1.0],
    );
    let center = add(p, sub(light, p).map(|x| 0.4 * x));
    let objs = vec![
        sphere(add(center, d.point(1.0)), d.number(0.3, 1.0)),
        plane([0.0, -2.0, 0.0], [0.0, 1.0, 0.0]),
    ];
    Case::any_hit(Line::new(p, sub(light, p)), [0.0, 1.0], objs)
}
