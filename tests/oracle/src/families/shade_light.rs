//! Shaded rays: where the light is.

use super::case::{Case, Lamp, Line, Shape, plane, sphere};
use super::draw::{Draw, sub, unit};
use super::shade::{BLUE, ENDS, LAMP, RED, floor, lab, lamp};
use super::{Family, family};

pub fn families() -> Vec<Family> {
    vec![
        family("inside_light_inside", 6, |d| {
            let inner = sphere([0.0; 3], 1.0).colored(RED);
            inside(
                d,
                vec![shell(), inner],
                d.turn(&[[3.0, 1.0, 0.5], [-2.0, 1.0, -3.0]]),
            )
        }),
        family("inside_light_outside", 4, |d| {
            inside(
                d,
                vec![shell()],
                d.turn(&[[1.0, 20.0, 1.0], [0.0, 0.0, 9.0]]),
            )
        }),
        family("outside_light_inside", 4, |d| {
            let line = Line::new([0.0, d.turn(&[0.3, 0.0, 2.0, -4.0]), -9.0], [0.0, 0.0, 1.0]);
            Case::shade(line, vec![shell()], lamp([1.0, 2.0, 1.0]), ENDS)
        }),
        family("light_inside_sphere", 4, |d| front(d, [0.0, 0.5, 3.0])),
        family("light_behind_plane", 4, |d| front(d, [0.0, -3.0, 3.0])),
        family("light_on_plane", 4, |d| front(d, [2.0, -2.0, 3.0])),
        family("light_on_sphere", 4, |d| front(d, [0.0, 1.0, 3.0])),
        family("light_at_sphere_centre", 4, |d| front(d, [0.0, 0.0, 3.0])),
        family("light_at_hit", 2, |d| {
            let light = d.turn(&[[0.0, 0.0, 2.0], [0.0, -2.0, 1.0]]);
            let direction = if d.index == 1 {
                [0.0, -2.0, 3.0]
            } else {
                [0.0, 0.0, 1.0]
            };
            Case::shade(
                Line::new([0.0, 0.0, -2.0], direction),
                lab(),
                lamp(light),
                ENDS,
            )
        }),
        family("light_at_camera", 4, |d| front(d, [0.0, 0.0, -2.0])),
        family("tangent_occluder", 9, |d| {
            let ulps = d.ulps();
            overhead(sphere([d.step(1.0, ulps), 4.0, 0.0], 1.0)).note("ulp", ulps)
        }),
        family("occluder_behind_light", 9, |d| {
            let ulps = d.ulps();
            overhead(sphere([0.0, d.step(11.0, ulps), 0.0], 1.0)).note("ulp", ulps)
        }),
        family("plane_at_light", 9, |d| {
            let ulps = d.ulps();
            overhead(plane([0.0, d.step(10.0, ulps), 0.0], [0.0, -1.0, 0.0])).note("ulp", ulps)
        }),
        // New.
        family("sphere_around_light", 5, |d| {
            let ulps = d.ulps();
            overhead(sphere([0.0, 10.0, 0.0], d.step(12.0, ulps))).note("ulp", ulps)
        }),
        family("occluder_touches_plane_at_hit", 5, |d| {
            // A sphere that rests on the floor, some ulps above or below, where a ray from below hits.
            let ulps = d.ulps();
            let ball = sphere([0.0, d.step(-1.0, ulps), 0.0], 1.0).colored(BLUE);
            let line = Line::new([0.0, -5.0, 0.0], [0.0, 1.0, 0.0]);
            Case::shade(line, vec![floor(-2.0), ball], lamp([3.0, -9.0, 1.0]), ENDS)
                .note("ulp", ulps)
        }),
        family("light_in_plane_of_hit", 5, |d| {
            // The light is on the plane that is hit, far aside, or some ulps above or below: the cosine is 0 or nearly.
            let ulps = d.ulps();
            let line = Line::new([0.0, 0.0, -2.0], [0.0, -2.0, 3.0]);
            Case::shade(line, lab(), lamp([5.0, d.step(-2.0, ulps), 1.0]), ENDS).note("ulp", ulps)
        }),
        family("light_in_tangent_plane", 5, |d| {
            let ulps = d.ulps();
            front(d, [3.0, 0.0, d.step(2.0, ulps)]).note("ulp", ulps)
        }),
        family("light_on_plane_seen_through_nothing", 3, |d| {
            // The light lies on a wall; the wall alone does not block.
            let wall = plane([0.0, 0.0, 8.0], [0.0, 0.0, -1.0]).colored(BLUE);
            let line = Line::new([0.0, 0.0, -2.0], [0.0, -2.0, d.turn(&[3.0, 5.0, 9.0])]);
            Case::shade(line, vec![floor(-2.0), wall], lamp([1.0, 4.0, 8.0]), ENDS)
        }),
        family("light_on_far_side_of_its_sphere", 3, |d| {
            // The light lies on a sphere that stands between it and the point.
            let ball = sphere([0.0, 4.0, 0.0], 1.0).colored(BLUE);
            let light = d.turn(&[[0.0, 5.0, 0.0], [0.0, 3.0, 0.0], [1.0, 4.0, 0.0]]);
            Case::shade(
                Line::new([0.0; 3], [0.0, -1.0, 0.0]),
                vec![floor(-2.0), ball],
                lamp(light),
                ENDS,
            )
        }),
        family("light_very_far", 3, |d| {
            let far = d.turn(&[1e6, 1e12, 1e15]);
            let line = Line::new([0.0, 0.0, -2.0], unit([0.6, -0.5, 1.0]));
            Case::shade(
                line,
                lab(),
                Lamp {
                    power: far * far,
                    ..lamp([far, 10.0 * far, far])
                },
                ENDS,
            )
        }),
        family("light_very_near", 4, |d| {
            let near = d.turn(&[1e-3, 1e-6, 1e-9, 1e-20]);
            let light = Lamp {
                power: near * near,
                ..lamp([near, 2.0 * near, 0.5 * near])
            };
            Case::shade(
                Line::new([0.0, 1.0, 0.0], [0.0, -1.0, 0.0]),
                vec![floor(0.0)],
                light,
                ENDS,
            )
        }),
        family("colored_light", 3, |d| {
            let color = d.turn(&[[1.0, 0.5, 0.25], [0.0; 3], [3.0, -1.0, 0.1]]);
            lit(Lamp { color, ..LAMP }, [0.5, 1.0, 0.7])
        }),
        family("power", 6, |d| {
            lit(
                Lamp {
                    power: d.turn(&[-100.0, 0.0, 1e-30, 1e30, 250.0, -0.0]),
                    ..LAMP
                },
                [1.0, 0.5, 0.1],
            )
        }),
        family("byte_boundary", 12, byte_boundary),
        family("nonfinite_light", 5, |d| {
            let special = d.turn(&[f64::NAN, f64::INFINITY]);
            let mut light = LAMP;
            match d.index {
                0 | 1 => light.light[1] = special,
                2 | 3 => light.power = special,
                _ => light.color[2] = special,
            }
            lit(light, [1.0; 3])
        }),
        family("nonfinite_color", 3, |d| {
            lit(
                LAMP,
                [
                    1.0,
                    d.turn(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]),
                    0.5,
                ],
            )
        }),
    ]
}

fn shell() -> Shape {
    sphere([0.0; 3], 5.0).colored(BLUE)
}

/// From inside the shell.
fn inside(d: &mut Draw, objs: Vec<Shape>, light: [f64; 3]) -> Case {
    let direction = if d.index == 0 {
        [0.0, 0.0, 1.0]
    } else {
        d.unit()
    };
    Case::shade(
        Line::new([0.0, 0.3, -3.5], direction),
        objs,
        lamp(light),
        ENDS,
    )
}

/// At the lab's sphere: straight at its pole, or aside.
fn front(d: &mut Draw, light: [f64; 3]) -> Case {
    let target = d.turn(&[
        [0.0, 0.0, 3.0],
        [0.3, 0.4, 3.0],
        [0.0, 0.9, 3.0],
        [-0.5, -2.0, 3.0],
    ]);
    let o = [0.0, 0.0, -2.0];
    Case::shade(Line::new(o, sub(target, o)), lab(), lamp(light), ENDS)
}

/// Straight down at the plane, the light straight above, something between or beyond.
fn overhead(other: Shape) -> Case {
    let line = Line::new([0.0; 3], [0.0, -1.0, 0.0]);
    Case::shade(
        line,
        vec![floor(-2.0), other.colored(BLUE)],
        lamp([0.0, 10.0, 0.0]),
        ENDS,
    )
}

/// A lit point of a sphere of the given colour.
fn lit(light: Lamp, color: [f64; 3]) -> Case {
    let line = Line::new([0.0, 0.0, -2.0], unit([0.05, 0.1, 1.0]));
    Case::shade(
        line,
        vec![sphere([0.0, 0.0, 3.0], 1.0).colored(color), floor(-2.0)],
        light,
        ENDS,
    )
}

/// Radiance at k/255 or an ulp beside: the light at the camera, at distance 2 from a plane seen straight on.
fn byte_boundary(d: &mut Draw) -> Case {
    let (k, ulps) = (d.turn(&[1.0, 77.0, 128.0, 255.0]), [-1, 0, 1][d.index / 4]);
    let light = Lamp {
        power: 4.0 * d.step(k / 255.0, ulps),
        ..lamp([0.0; 3])
    };
    let line = Line::new([0.0; 3], [0.0, -1.0, 0.0]);
    Case::shade(
        line,
        vec![plane([0.0, -2.0, 0.0], [0.0, 1.0, 0.0]).colored([1.0, 0.5, 0.25])],
        light,
        ENDS,
    )
    .note("k", k as u8)
    .note("ulp", ulps)
}
