//! Rays and spheres: sizes, distances, tangents and surfaces.

use super::case::{AHEAD, Case, Line};
use super::draw::{Draw, add, along, scale, sub, unit};
use super::{Family, family, family_of};

pub fn families() -> Vec<Family> {
    let mut families = vec![
        family("generic", 10, |d| aimed(d, 1.0)),
        family("behind", 5, behind),
        family("tangent_axis_ulp", 13, tangent_axis),
        family("tangent_radius_ulp", 9, tangent_radius),
        family("near_tangent", 10, near_tangent),
        family_of("tiny_far_r1e-3_at1e4", 8, 1e4, |d| far(d, 1e-3)),
        family("huge_r1e6_axis", 5, |d| {
            let height = d.turn(&[1.0, 0.0625, 100.0, 0.1, 3.0]);
            Case::ray_sphere(
                Line::new([0.0, height, 0.0], [0.0, -1.0, 0.0]),
                [0.0, -1e6, 0.0],
                1e6,
                AHEAD,
            )
        }),
        family("origin_inside", 8, origin_inside),
        family("origin_rounded_on_surface_out", 6, |d| {
            on_rounded_surface(d, 1.0)
        }),
        family("origin_rounded_on_surface_in", 6, |d| {
            on_rounded_surface(d, -1.0)
        }),
        family("origin_exactly_on_surface", 8, exactly_on_surface),
        family("origin_at_centre", 5, |d| {
            let (center, radius) = (d.point(10.0), d.number(0.5, 3.0));
            let direction = if d.index == 0 {
                [1.0, 0.0, 0.0]
            } else {
                d.unit()
            };
            Case::ray_sphere(Line::new(center, direction), center, radius, AHEAD)
        }),
        family("nonunit_direction", 8, |d| {
            let length = d.turn(&[1e-6, 1e3, 0.1, 1e7, 3.0]);
            aimed(d, length)
        }),
        family("unit_direction_off_by_ulps", 6, off_by_ulps),
        // New.
        family("direction_1e15", 5, |d| aimed(d, 1e15)),
        family("direction_1e-15", 5, |d| aimed(d, 1e-15)),
        family("inside_huge_r1e6", 5, inside_huge),
        family("huge_radius_origin_on_surface", 6, huge_on_surface),
        family("needle", 5, needle),
        family("exact_tangent", 6, exact_tangent),
        family("rational_roots", 6, rational_roots),
        family("mixed_scales", 5, mixed_scales),
    ];
    families.extend(FAR_ORIGIN.map(|(name, distance)| {
        family_of(name, 5, distance, |d| {
            let radius = d.number(0.5, 3.0);
            far(d, radius)
        })
    }));
    families.extend(HUGE_ALTITUDE.map(|(name, altitude)| family_of(name, 5, altitude, above_huge)));
    families.extend(HUGE_COORDS.map(|(name, size)| family_of(name, 5, size, huge_coords)));
    families
}

const FAR_ORIGIN: [(&str, f64); 4] = [
    ("far_origin_1e3", 1e3),
    ("far_origin_1e4", 1e4),
    ("far_origin_1e5", 1e5),
    ("far_origin_1e6", 1e6),
];

const HUGE_ALTITUDE: [(&str, f64); 5] = [
    ("huge_r1e6_alt1e-2", 1e-2),
    ("huge_r1e6_alt1e-1", 1e-1),
    ("huge_r1e6_alt1e0", 1.0),
    ("huge_r1e6_alt1e1", 10.0),
    ("huge_r1e6_alt1e2", 100.0),
];

const HUGE_COORDS: [(&str, f64); 4] = [
    ("huge_coords_1e4", 1e4),
    ("huge_coords_1e5", 1e5),
    ("huge_coords_1e6", 1e6),
    ("huge_coords_1e7", 1e7),
];

/// From `distance` away toward a point at `miss` from the centre.
fn toward(d: &mut Draw, center: [f64; 3], distance: f64, miss: f64) -> Line {
    let direction = d.exact_unit();
    let side = d.across(direction);
    let target = along(center, miss, side);
    let o = d.rounded(along(target, -distance, direction));
    Line::new(o, unit(sub(target, o)))
}

/// A ray that crosses a sphere of radius about 1, with a direction of the given length.
fn aimed(d: &mut Draw, length: f64) -> Case {
    let (center, radius) = (d.point(10.0), d.number(0.5, 3.0));
    let (distance, miss) = (d.number(4.0, 20.0), d.number(0.0, 0.95) * radius);
    let line = toward(d, center, distance, miss);
    Case::ray_sphere(
        Line {
            d: scale(line.d, length),
            ..line
        },
        center,
        radius,
        AHEAD,
    )
}

fn behind(d: &mut Draw) -> Case {
    let (center, radius) = (d.point(10.0), d.number(0.5, 3.0));
    let miss = d.number(0.0, 0.9) * radius;
    let line = toward(d, center, 10.0, miss);
    Case::ray_sphere(
        Line {
            d: scale(line.d, -1.0),
            ..line
        },
        center,
        radius,
        AHEAD,
    )
}

/// Along z, past the unit sphere at a distance some ulps from its radius.
fn tangent_axis(d: &mut Draw) -> Case {
    let ulps = d.turn(&[-8, -4, -3, -2, -1, 0, 1, 2, 3, 4, 8, 64, -64]);
    let o = [0.0, d.step(1.0, ulps), -5.0];
    Case::ray_sphere(Line::new(o, [0.0, 0.0, 1.0]), [0.0; 3], 1.0, AHEAD).note("ulp", ulps)
}

/// Past (3, 4) at distance 5, the radius some ulps from that.
fn tangent_radius(d: &mut Draw) -> Case {
    let ulps = d.ulps();
    let line = Line::new([3.0, 4.0, -20.0], [0.0, 0.0, 1.0]);
    Case::ray_sphere(line, [0.0, 0.0, 7.0], d.step(5.0, ulps), AHEAD).note("ulp", ulps)
}

/// At random, within some roundoffs of a tangent.
fn near_tangent(d: &mut Draw) -> Case {
    let (center, radius) = (d.point(10.0), d.number(0.5, 3.0));
    let slack = d.turn(&[0.0, 4.0, -4.0, 64.0, -64.0]) * d.format.unit_roundoff();
    let distance = d.number(5.0, 30.0);
    let line = toward(d, center, distance, radius * (1.0 + slack));
    Case::ray_sphere(line, center, radius, AHEAD)
}

/// From `parameter` away.
fn far(d: &mut Draw, radius: f64) -> Case {
    let center = d.point(10.0);
    let miss = d.number(0.0, 0.9) * radius;
    let line = toward(d, center, d.parameter, miss);
    Case::ray_sphere(line, center, radius, AHEAD)
}

/// From a height of `parameter` above a sphere of radius 1e6.
fn above_huge(d: &mut Draw) -> Case {
    let up = d.exact_unit();
    let tangent = d.across(up);
    let o = d.rounded(scale(up, 1e6 + d.parameter));
    let slope = d.number(0.1, 3.0);
    Case::ray_sphere(
        Line::new(o, unit(along(tangent, -slope, up))),
        [0.0; 3],
        1e6,
        AHEAD,
    )
}

fn origin_inside(d: &mut Draw) -> Case {
    let (center, radius) = (d.point(10.0), d.number(0.5, 3.0));
    let depth = d.number(0.0, 0.9) * radius;
    let o = along(center, depth, d.exact_unit());
    Case::ray_sphere(Line::new(o, d.unit()), center, radius, AHEAD)
}

/// The origin is a rounded point of the surface; the ray leaves (1) or enters (-1).
fn on_rounded_surface(d: &mut Draw, outward: f64) -> Case {
    let (center, radius) = (d.point(10.0), d.number(0.5, 3.0));
    let normal = d.exact_unit();
    let tangent = d.across(normal);
    let direction = unit(along(scale(normal, outward), d.number(0.0, 5.0), tangent));
    let o = d.rounded(along(center, radius, normal));
    Case::ray_sphere(Line::new(o, direction), center, radius, AHEAD)
}

/// The origin lies on the sphere exactly: leaving, entering, and along the tangent.
fn exactly_on_surface(d: &mut Draw) -> Case {
    let (o, radius) = d.turn(&[
        ([1.0, 0.0, 0.0], 1.0),
        ([3.0, 4.0, 0.0], 5.0),
        ([2.0, -3.0, 6.0], 7.0),
        ([0.0, 0.0, -1024.0], 1024.0),
    ]);
    let direction = if d.index < 4 {
        o
    } else {
        d.turn(&[
            [-1.0, 0.0, 0.0],
            [4.0, -3.0, 0.0],
            [-1.0, 0.5, 0.25],
            [0.0, 1.0, 1.0],
        ])
    };
    Case::ray_sphere(Line::new(o, direction), [0.0; 3], radius, AHEAD)
}

/// Unit directions of which one component was moved by a few ulps.
fn off_by_ulps(d: &mut Draw) -> Case {
    let (center, radius) = (d.point(5.0), d.number(0.5, 2.0));
    let (distance, miss) = (d.number(4.0, 10.0), d.number(0.0, 0.9) * radius);
    let line = toward(d, center, distance, miss);
    let mut direction = d.rounded(line.d);
    let axis = d.index % 3;
    direction[axis] = d.step(direction[axis], d.turn(&[1, -2, 3, -5, 8, -13]));
    Case::ray_sphere(
        Line {
            d: direction,
            ..line
        },
        center,
        radius,
        AHEAD,
    )
}

fn huge_coords(d: &mut Draw) -> Case {
    let aside = d.point(10.0);
    let center = d.rounded(add(scale([1.0, -1.0, 0.5], d.parameter), aside));
    let radius = d.number(1.0, 3.0);
    let (distance, miss) = (d.number(5.0, 15.0), d.number(0.0, 0.8) * radius);
    let line = toward(d, center, distance, miss);
    Case::ray_sphere(line, center, radius, AHEAD)
}

/// From inside a sphere of radius 1e6, near its wall.
fn inside_huge(d: &mut Draw) -> Case {
    let up = d.exact_unit();
    let o = d.rounded(scale(up, 1e6 - d.turn(&[0.1, 1.0, 10.0, 1e3, 5e5])));
    Case::ray_sphere(Line::new(o, d.unit()), [0.0; 3], 1e6, AHEAD)
}

/// Standing on planets up to the size where the radius hides the camera: up, down and along the ground.
fn huge_on_surface(d: &mut Draw) -> Case {
    let radius = d.turn(&[1e6, 16_777_216.0, 1e15]);
    let direction = if d.index < 3 {
        [0.0, -1.0, 0.0]
    } else {
        [1.0, d.turn(&[0.0, -1e-3, 1e-3]), 0.0]
    };
    Case::ray_sphere(
        Line::new([0.0; 3], direction),
        [0.0, -radius, 0.0],
        radius,
        AHEAD,
    )
}

/// Radii far below the spacing of floats at the centre, aimed at exactly.
fn needle(d: &mut Draw) -> Case {
    let direction = d.turn(&[
        [1.0, 2.0, 2.0],
        [2.0, -1.0, 2.0],
        [4.0, 4.0, 7.0],
        [1.0, 0.0, 0.0],
        [2.0, 3.0, 6.0],
    ]);
    let radius = d.turn(&[1e-3, 1e-9, 1e-20, 1e-6, 1e-12]);
    Case::ray_sphere(
        Line::new([0.0; 3], direction),
        scale(direction, 4096.0),
        radius,
        AHEAD,
    )
}

/// Tangents whose numbers are all whole: the discriminant is exactly 0 and the sphere is hit.
fn exact_tangent(d: &mut Draw) -> Case {
    let (across, along, radius) = d.turn(&[
        ([3.0, 4.0, 0.0], [0.0, 0.0, 1.0], 5.0),
        ([0.0, 5.0, 12.0], [2.0, 0.0, 0.0], 13.0),
        ([1.0, 2.0, 2.0], [2.0, 1.0, -2.0], 3.0),
    ]);
    let center = d.turn(&[[0.0; 3], [1.0, -7.0, 3.0]]);
    let back = d.turn(&[4.0, 4.0, 4.0, 1.0, 0.0, -2.0]);
    let o = sub(add(center, across), scale(along, back));
    Case::ray_sphere(Line::new(o, along), center, radius, AHEAD)
}

/// Pythagorean chords: both roots are rational.
fn rational_roots(d: &mut Draw) -> Case {
    let (miss, radius) = d.turn(&[
        (3.0, 5.0),
        (5.0, 13.0),
        (7.0, 25.0),
        (8.0, 17.0),
        (0.75, 1.25),
        (0.28, 1.0),
    ]);
    let line = Line::new([miss, 0.0, -40.0], [0.0, 0.0, d.turn(&[1.0, 3.0])]);
    Case::ray_sphere(line, [0.0; 3], radius, AHEAD)
}

fn mixed_scales(d: &mut Draw) -> Case {
    let (large, small) = d.turn(&[(1e6, 10.0), (1e3, 0.1), (1e9, 1e4)]);
    let center = [
        d.number(-large, large),
        d.number(-small, small),
        d.number(-1.0, 1.0),
    ];
    let miss = d.number(0.0, 0.9) * small;
    let line = toward(d, center, 2.0 * large, miss);
    Case::ray_sphere(line, center, small, AHEAD)
}
