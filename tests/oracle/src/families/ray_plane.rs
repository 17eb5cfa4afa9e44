//! Rays and planes: where t has a size, near and far, steep and grazing.

use super::case::{AHEAD, Case, Line};
use super::draw::{Draw, add, along, dot, scale, sub, unit};
use super::{Family, family, family_of};

pub fn families() -> Vec<Family> {
    let mut families = vec![
        family("generic", 10, |d| generic(d, 1.0, 1.0)),
        family("axis_aligned", 8, axis_aligned),
        family("nonunit", 8, |d| {
            let (direction, normal) = d.turn(&[
                (0.0625, 0.05),
                (1e3, 1e-3),
                (1e-7, 1e7),
                (1e6, 1e6),
                (1e-3, 1.0),
            ]);
            generic(d, direction, normal)
        }),
        family("origin_near_plane", 8, origin_near_plane),
        family("origin_on_plane_exact", 6, origin_on_plane_exact),
        // New: lengths no one expects, and the plane equation's cancellation.
        family("direction_1e15", 5, |d| generic(d, 1e15, 1.0)),
        family("direction_1e-15", 5, |d| generic(d, 1e-15, 1.0)),
        family("normal_1e15", 5, |d| generic(d, 1.0, 1e15)),
        family("normal_1e-15", 5, |d| generic(d, 1.0, 1e-15)),
        family("far_plane_near_origin", 6, far_plane_near_origin),
        family("mixed_scales", 6, mixed_scales),
    ];
    families.extend(GRAZING.map(|(name, angle)| family_of(name, 6, angle, grazing)));
    families.extend(GRAZING_AXIS.map(|(name, angle)| family_of(name, 5, angle, grazing_axis)));
    families.extend(FAR.map(|(name, distance)| family_of(name, 5, distance, far)));
    families.extend(HUGE_COORDS.map(|(name, size)| family_of(name, 6, size, huge_coords)));
    families
}

/// Angles in radians between the ray and the plane.
const GRAZING: [(&str, f64); 7] = [
    ("grazing_1e-1", 1e-1),
    ("grazing_1e-2", 1e-2),
    ("grazing_1e-3", 1e-3),
    ("grazing_1e-4", 1e-4),
    ("grazing_1e-5", 1e-5),
    ("grazing_1e-6", 1e-6),
    ("grazing_1e-7", 1e-7),
];

const GRAZING_AXIS: [(&str, f64); 7] = [
    ("grazing_axis_1e-1", 1e-1),
    ("grazing_axis_1e-2", 1e-2),
    ("grazing_axis_1e-3", 1e-3),
    ("grazing_axis_1e-4", 1e-4),
    ("grazing_axis_1e-5", 1e-5),
    ("grazing_axis_1e-6", 1e-6),
    ("grazing_axis_1e-7", 1e-7),
];

const FAR: [(&str, f64); 4] = [
    ("far_1e6", 1e6),
    ("far_1e8", 1e8),
    ("far_1e10", 1e10),
    ("far_1e12", 1e12),
];

const HUGE_COORDS: [(&str, f64); 4] = [
    ("huge_coords_1e5", 1e5),
    ("huge_coords_1e6", 1e6),
    ("huge_coords_1e7", 1e7),
    ("huge_coords_1e8", 1e8),
];

/// Everything at random, directions and normals of given lengths; mostly toward the plane.
fn generic(d: &mut Draw, direction: f64, normal: f64) -> Case {
    let (o, q) = (d.point(10.0), d.point(10.0));
    let (n, v) = (d.exact_unit(), d.exact_unit());
    let away = (dot(sub(q, o), n) < 0.0) != (dot(v, n) < 0.0);
    let turn = if away && d.index % 4 != 3 { -1.0 } else { 1.0 };
    Case::ray_plane(
        Line::new(o, scale(v, turn * direction)),
        q,
        scale(n, normal),
        AHEAD,
    )
}

fn axis_aligned(d: &mut Draw) -> Case {
    let normal = d.turn(&[
        [0.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, -1.0],
        [0.0, -1.0, 0.0],
    ]);
    Case::ray_plane(
        Line::new(d.point(10.0), d.unit()),
        d.point(10.0),
        normal,
        AHEAD,
    )
}

/// At an angle of `parameter` to a tilted plane.
fn grazing(d: &mut Draw) -> Case {
    let normal = d.exact_unit();
    let tangent = d.across(normal);
    let o = d.point(15.0);
    let q = along(add(o, d.point(5.0)), d.number(-3.0, -1.0), normal);
    let direction = unit(along(tangent, -d.parameter, normal));
    Case::ray_plane(Line::new(o, direction), q, normal, AHEAD)
}

/// The same, down to the lab's plane y = -2.
fn grazing_axis(d: &mut Draw) -> Case {
    let o = [d.number(-5.0, 5.0), 0.0, -2.0];
    let direction = unit([d.number(-0.3, 0.3), -d.parameter, 1.0]);
    Case::ray_plane(
        Line::new(o, direction),
        [0.0, -2.0, 0.0],
        [0.0, 1.0, 0.0],
        AHEAD,
    )
}

/// A plane met at about `parameter`.
fn far(d: &mut Draw) -> Case {
    let line = Line::new(d.point(10.0), d.unit());
    let distance = d.parameter * d.number(0.5, 2.0);
    Case::ray_plane(line, along(line.o, distance, line.d), d.unit(), AHEAD)
}

/// A generic meeting far from the origin of the world.
fn huge_coords(d: &mut Draw) -> Case {
    let base = scale([1.0, -1.0, 0.5], d.parameter);
    let line = Line::new(add(base, d.point(15.0)), d.unit());
    Case::ray_plane(line, add(base, d.point(15.0)), d.unit(), AHEAD)
}

/// The origin is a rounded point of the plane.
fn origin_near_plane(d: &mut Draw) -> Case {
    let (q, normal) = (d.point(10.0), d.unit());
    let tangent = d.across(normal);
    let o = along(q, d.number(0.5, 3.0), tangent);
    Case::ray_plane(Line::new(o, d.unit()), q, normal, AHEAD)
}

/// The origin lies on the plane exactly: the closed interval has it, the others have not.
fn origin_on_plane_exact(d: &mut Draw) -> Case {
    let (mut o, q) = (d.point(10.0), d.point(10.0));
    o[1] = q[1];
    Case::ray_plane(
        Line::new(o, d.unit()),
        q,
        [0.0, d.turn(&[1.0, -3.0]), 0.0],
        AHEAD,
    )
}

/// A meeting near the camera whose plane is given by a point far away: `dot(q, n) - dot(o, n)` cancels.
fn far_plane_near_origin(d: &mut Draw) -> Case {
    let normal = d.exact_unit();
    let tangent = d.across(normal);
    let o = d.point(1.0);
    let q = along(along(o, d.turn(&[1e3, 1e6, 1e8]), tangent), -1.0, normal);
    Case::ray_plane(
        Line::new(o, unit(along(scale(normal, -1.0), 0.5, tangent))),
        q,
        normal,
        AHEAD,
    )
}

/// Components of very different size.
fn mixed_scales(d: &mut Draw) -> Case {
    let (large, small) = d.turn(&[(1e6, 1e-6), (1e9, 1e-3), (1e3, 1e-9)]);
    let line = Line::new(
        [
            d.number(-large, large),
            d.number(-small, small),
            d.number(-1.0, 1.0),
        ],
        d.unit(),
    );
    let q = [
        d.number(-small, small),
        d.number(-1.0, 1.0),
        d.number(-large, large),
    ];
    Case::ray_plane(line, q, d.unit(), AHEAD)
}
