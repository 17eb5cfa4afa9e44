//! Origins of shadow rays.

use super::case::{Case, Line, Shape, plane, sphere};
use super::draw::{Draw, add, along, scale, sub, unit};
use super::{Family, family, family_of};
use crate::{Object, Plane, Ray, Real, Sphere, Surd};

pub fn families() -> Vec<Family> {
    vec![
        family("plane_generic", 10, |d| {
            let (o, q, n) = (d.point(10.0), d.point(10.0), d.unit());
            onto_plane(d, o, q, n)
        }),
        family("plane_y-2_base", 8, |d| below(d, [0.0, 0.0, -2.0], -2.0)),
        family("plane_y-2.1", 8, |d| below(d, [0.0, 0.3, -2.0], -2.1)),
        family_of("sphere_base", 8, 0.0, sphere_translated),
        family_of("sphere_translated_1e3", 6, 1e3, sphere_translated),
        family_of("plane_tilted_translated_1e3", 6, 1e3, plane_translated),
        family_of("sphere_translated_1e5", 6, 1e5, sphere_translated),
        family_of("plane_tilted_translated_1e5", 6, 1e5, plane_translated),
        family_of("sphere_translated_1e7", 6, 1e7, sphere_translated),
        family_of("plane_tilted_translated_1e7", 6, 1e7, plane_translated),
        family("sphere_r1e6", 6, |d| {
            let o = scale(d.exact_unit(), 1e6 + 5.0);
            let target = scale(o, 1.0 - 5e-6);
            let target = add(target, d.point(3.0));
            onto_sphere(d, o, target, [0.0; 3], 1e6)
        }),
        family("sphere_r1e-3", 6, |d| {
            let (o, center) = (d.point(1.0), d.point(1.0));
            let target = add(center, d.point(4e-4));
            onto_sphere(d, o, target, center, 1e-3)
        }),
        family("near_world_origin", 8, |d| {
            let o = [d.turn(&[0.0, 0.01, -0.02]), 0.5, d.turn(&[0.0, 0.0, 0.003])];
            let direction = [d.number(-0.02, 0.02), -1.0, d.number(-0.02, 0.02)];
            hit_plane(d, Line::new(o, unit(direction)), [0.0; 3], [0.0, 1.0, 0.0])
        }),
        family("sphere_inside", 8, |d| {
            let o = d.point(1.0);
            let target = add(o, d.exact_unit());
            onto_sphere(d, o, target, [0.1, 0.2, 0.3], 4.0)
        }),
        // New.
        family("plane_from_below", 6, |d| {
            let (o, target) = (
                [d.number(-1.0, 1.0), -5.0, 0.5],
                [d.number(-3.0, 3.0), -2.1, d.number(-3.0, 3.0)],
            );
            hit_plane(
                d,
                Line::new(o, unit(sub(target, o))),
                [0.0, -2.1, 0.0],
                [0.0, 1.0, 0.0],
            )
        }),
        family("plane_unnormalised_normal", 6, |d| {
            let length = d.turn(&[1e3, 1e-3, 7.0]);
            let (o, q, n) = (d.point(10.0), d.point(10.0), scale(d.exact_unit(), length));
            onto_plane(d, o, q, n)
        }),
        family("sphere_inside_translated_1e5", 6, |d| {
            let o = add([1e5; 3], d.point(1.0));
            let target = add(o, d.exact_unit());
            onto_sphere(d, o, target, [1e5; 3], 4.0)
        }),
        family("plane_grazing", 6, |d| {
            let direction = unit([d.number(-0.3, 0.3), -d.turn(&[1e-2, 1e-3, 1e-4]), 1.0]);
            hit_plane(
                d,
                Line::new([0.0, -1.9, -2.0], direction),
                [0.0, -2.0, 0.0],
                [0.0, 1.0, 0.0],
            )
        }),
        family("sphere_grazing", 3, |d| {
            let target = [0.0, 1.0 - d.turn(&[1e-2, 1e-4, 1e-5]), 3.0];
            onto_sphere(d, [0.0, 0.0, -2.0], target, [0.0, 0.0, 3.0], 1.0)
        }),
        family_of("scaled_1e-6", 6, 1e-6, scaled),
        family_of("scaled_1e6", 6, 1e6, scaled),
        family("at_the_threshold", 6, |d| {
            // One coordinate straddles 1/32, where the published offset changes its formula.
            let height = d.step(0.03125, d.turn(&[0, -1, 1]));
            let n = if d.index < 3 {
                [0.0, 1.0, 0.0]
            } else {
                [0.0, -1.0, 0.0]
            };
            let line = Line::new([0.0, height + n[1], 0.0], [0.1, -n[1], 0.0]);
            hit_plane(d, line, [0.0, height, 0.0], n)
        }),
        family("camera_on_sphere", 4, |d| {
            let o = d.turn(&[[3.0, 4.0, 0.0], [0.0, 0.0, -5.0]]);
            let target = d.point(2.0);
            onto_sphere(d, o, target, [0.0; 3], 5.0)
        }),
    ]
}

/// The rounded hit, and the rounded normal that faces the ray.
fn request(d: &Draw, line: Line, shape: Shape, ray: &Ray, object: &Object, t: &Surd) -> Case {
    let p = ray.at(t);
    let own = object.normal(&p);
    let inverse = Surd::norm(&own).recip();
    let facing = -Surd::dot_rational(&own, &ray.direction).sign();
    let n = own.map(|x| Real::root(x.sign() * facing, &(&x * &x) * &inverse).round(d.format));
    Case::offset(line, shape, p.map(|x| Real::from(x).round(d.format)), n)
}

/// Down the line onto the plane, which it must meet.
fn hit_plane(d: &mut Draw, line: Line, q: [f64; 3], n: [f64; 3]) -> Case {
    let (o, direction, q, n) = (
        d.rounded(line.o),
        d.rounded(line.d),
        d.rounded(q),
        d.rounded(n),
    );
    let ray = Ray::new(o, direction, 0.0, f64::INFINITY).expect("a finite ray");
    let object = Plane::new(q, n).map(Object::Plane).expect("a plane");
    let roots = object.roots(&ray);
    request(
        d,
        Line::new(o, direction),
        plane(q, n),
        &ray,
        &object,
        roots.first().expect("no parallel ray"),
    )
}

/// From `o` toward a random point of the plane.
fn onto_plane(d: &mut Draw, o: [f64; 3], q: [f64; 3], n: [f64; 3]) -> Case {
    let tangent = d.across(unit(n));
    let target = along(q, d.number(0.0, 8.0), tangent);
    hit_plane(d, Line::new(o, unit(sub(target, o))), q, n)
}

/// From `o` toward `target` onto the sphere, which the ray must meet.
fn onto_sphere(d: &mut Draw, o: [f64; 3], target: [f64; 3], c: [f64; 3], r: f64) -> Case {
    let (o, c, r) = (d.rounded(o), d.rounded(c), d.round(r));
    let direction = d.rounded(unit(sub(target, o)));
    let ray = Ray::new(o, direction, 0.0, f64::INFINITY).expect("a finite ray");
    let object = Sphere::new(c, r).map(Object::Sphere).expect("a sphere");
    let roots = object.roots(&ray);
    let ahead = roots.iter().find(|t| t.sign() > 0).expect("a sphere ahead");
    request(
        d,
        Line::new(o, direction),
        sphere(c, r),
        &ray,
        &object,
        ahead,
    )
}

/// Onto the plane at height `y`.
fn below(d: &mut Draw, o: [f64; 3], y: f64) -> Case {
    let target = [d.number(-4.0, 4.0), y, d.number(1.0, 8.0)];
    hit_plane(
        d,
        Line::new(o, unit(sub(target, o))),
        [0.0, y, 0.0],
        [0.0, 1.0, 0.0],
    )
}

/// The lab's sphere and camera, moved by `parameter` along each axis.
fn sphere_translated(d: &mut Draw) -> Case {
    let base = [d.parameter; 3];
    let target = add(add(base, [0.0, 0.0, 3.0]), d.point(0.5));
    onto_sphere(
        d,
        add(base, [0.0, 0.0, -2.0]),
        target,
        add(base, [0.0, 0.0, 3.0]),
        1.0,
    )
}

fn plane_translated(d: &mut Draw) -> Case {
    let base = [d.parameter; 3];
    let (o, n) = (add(base, d.point(3.0)), d.unit());
    onto_plane(d, o, base, n)
}

/// The lab's sphere and camera, everything times `parameter`.
fn scaled(d: &mut Draw) -> Case {
    let target = scale(add([0.0, 0.0, 3.0], d.point(0.5)), d.parameter);
    let [o, c] = [[0.0, 0.0, -2.0], [0.0, 0.0, 3.0]].map(|v| scale(v, d.parameter));
    onto_sphere(d, o, target, c, d.parameter)
}
