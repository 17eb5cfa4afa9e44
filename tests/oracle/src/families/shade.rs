//! Shaded rays: the lab's scene, moved and scaled, and the other scenes that strategies were measured on.

use super::case::{Case, Ends, Lamp, Line, Shape, plane, sphere};
use super::draw::{Draw, add, along, cross, scale, sub, unit};
use super::{Family, family, family_of};
use serde_json::json;

pub fn families() -> Vec<Family> {
    vec![
        family("base_scene_grid", 24, |d| {
            base([
                d.turn(&[0, 200, 285, 310, 599]),
                [0, 140, 210, 290, 399][d.index / 5],
            ])
        }),
        family("base_scene_centre_column", 16, |d| {
            let row = d.turn(&[
                118, 128, 130, 134, 139, 150, 170, 200, 201, 205, 230, 250, 270, 282, 300, 399,
            ]);
            base([300, row])
        }),
        family_of("translated_1e3", 6, 1e3, |d| moved(d, d.parameter)),
        family_of("translated_1e4", 6, 1e4, |d| moved(d, d.parameter)),
        family_of("translated_1e5", 6, 1e5, |d| moved(d, d.parameter)),
        family("gap_1e-3_under_roof", 5, |d| under_roof(d, -1.9995)),
        family("gap_1e-3_above_roof", 5, |d| under_roof(d, 0.0)),
        family("thin_gap_two_planes", 6, thin_gap),
        family("coincident", 6, |d| {
            let objs = vec![
                sphere([0.1, 0.0, 3.0], 1.0).colored(BLUE),
                sphere([0.1, 0.0, 3.0], 1.0).colored(BLUE),
                floor(-2.1),
                floor(-2.1),
            ];
            view(
                d,
                [0.0, 0.3, -2.0],
                [0.0, 0.3, 79.0],
                objs,
                [1.0, 10.0, 1.0],
            )
        }),
        family("contact_tiny_r1e-2", 8, |d| {
            let objs = vec![sphere([0.0, -1.99, 0.0], 0.01).colored(BLUE), floor(-2.0)];
            let o = [0.0, -1.9, -0.3];
            let target = add(
                [0.0, -2.0, 0.0],
                [d.number(-0.02, 0.02), 0.0, d.number(-0.02, 0.02)],
            );
            Case::shade(Line::new(o, unit(sub(target, o))), objs, LAMP, ENDS)
        }),
        family("planet_r1e6", 8, |d| {
            let objs = vec![
                sphere([0.0, -1e6 - 2.0, 3.0], 1e6).colored(RED),
                sphere([0.0, -1.0, 3.0], 1.0).colored(BLUE),
            ];
            let o = [0.0, 0.0, -2.0];
            let target = [d.number(-2.0, 2.0), d.number(-2.0, 0.0), 3.0];
            Case::shade(
                Line::new(o, unit(sub(target, o))),
                objs,
                lamp([4.0, 10.0, 1.0]),
                [0.0, 1e5],
            )
        }),
        family("stack5", 8, |d| {
            let mut objs: Vec<Shape> = (0..5)
                .map(|k| sphere([0.0, 2.0 * f64::from(k) - 1.0, 8.0], 1.0).colored(BLUE))
                .collect();
            objs.push(floor(-2.0));
            let o = [0.0, 3.0, -4.0];
            let target = [d.number(-1.5, 1.5), d.number(-2.5, 8.0), 8.0];
            Case::shade(
                Line::new(o, unit(sub(target, o))),
                objs,
                lamp([0.3, 20.0, 7.0]),
                ENDS,
            )
        }),
        family("grazing_light", 8, |d| {
            let objs = vec![floor(-2.0), sphere([0.0, -1.5, 6.0], 0.4).colored(BLUE)];
            let light = [6.0, d.turn(&[-1.9, -1.99, -1.999, -1.9999]), 6.0];
            let o = [0.0, 0.0, -2.0];
            let target = [d.number(-4.0, 4.0), -2.0, d.number(2.0, 6.5)];
            Case::shade(Line::new(o, unit(sub(target, o))), objs, lamp(light), ENDS)
        }),
        // New.
        family_of("translated_1e7", 6, 1e7, |d| moved(d, d.parameter)),
        family_of("scaled_1e-6", 6, 1e-6, scaled),
        family_of("scaled_1e6", 6, 1e6, scaled),
        family("direction_1e15", 4, |d| lengthened(d, 1e15)),
        family("direction_1e-15", 4, |d| lengthened(d, 1e-15)),
        family("grazing_camera", 6, |d| {
            let objs = vec![sphere([0.0, -1.0, 5.0], 1.0).colored(BLUE), floor(-2.0)];
            let direction = unit([d.number(-0.5, 0.5), -d.turn(&[1e-2, 1e-3, 1e-4]), 1.0]);
            Case::shade(
                Line::new([0.0, -1.995, -2.0], direction),
                objs,
                lamp([3.0, 10.0, 1.0]),
                ENDS,
            )
        }),
        family("shadow_edge", 10, shadow_edge),
        family("random_scene", 12, random_scene),
    ]
}

pub const BLUE: [f64; 3] = [0.0, 0.0, 1.0];
pub const RED: [f64; 3] = [1.0, 0.0, 0.0];

/// The lab's interval.
pub const ENDS: Ends = [0.0, 1000.0];

/// The lab's light.
pub const LAMP: Lamp = Lamp {
    light: [1.0, 10.0, 1.0],
    power: 100.0,
    color: [1.0; 3],
    background: 0.5,
};

/// The lab's light elsewhere.
pub fn lamp(light: [f64; 3]) -> Lamp {
    Lamp { light, ..LAMP }
}

/// A red plane of constant y.
pub fn floor(y: f64) -> Shape {
    plane([0.0, y, 0.0], [0.0, 1.0, 0.0]).colored(RED)
}

/// The lab's sphere and plane.
pub fn lab() -> Vec<Shape> {
    vec![sphere([0.0, 0.0, 3.0], 1.0).colored(BLUE), floor(-2.0)]
}

/// The direction of the lab's camera through a pixel of the picture of 600 x 400.
fn pixel_ray(pixel: [usize; 2]) -> [f64; 3] {
    let [i, j] = pixel.map(|x| x as f64);
    // tan 30° = 1/√3; the right of the picture is -x.
    let half_height = 1.0 / 3f64.sqrt();
    let half_width = 1.5 * half_height;
    unit([
        half_width * (1.0 - 2.0 * i / 599.0),
        half_height * (1.0 - 2.0 * j / 399.0),
        1.0,
    ])
}

/// A pixel of the lab's picture.
fn base(pixel: [usize; 2]) -> Case {
    let line = Line::new([0.0, 0.0, -2.0], pixel_ray(pixel));
    Case::shade(line, lab(), LAMP, ENDS).note("pixel", json!(pixel))
}

/// A pixel whose turn it is: centre, terminator, lit and shadowed plane.
fn some_pixel(d: &Draw) -> [usize; 2] {
    d.turn(&[
        [300, 200],
        [300, 134],
        [250, 160],
        [300, 300],
        [310, 270],
        [420, 250],
    ])
}

/// The lab's scene moved by `offset` along each axis.
fn moved(d: &mut Draw, offset: f64) -> Case {
    let base = [offset; 3];
    let pixel = some_pixel(d);
    let objs = vec![
        sphere(add(base, [0.0, 0.0, 3.0]), 1.0).colored(BLUE),
        plane(add(base, [0.0, -2.0, 0.0]), [0.0, 1.0, 0.0]).colored(RED),
    ];
    let line = Line::new(add(base, [0.0, 0.0, -2.0]), pixel_ray(pixel));
    Case::shade(line, objs, lamp(add(base, LAMP.light)), ENDS).note("pixel", json!(pixel))
}

/// The lab's scene times `parameter`, with a power that keeps the radiance.
fn scaled(d: &mut Draw) -> Case {
    let k = d.parameter;
    let objs = vec![
        sphere([0.0, 0.0, 3.0 * k], k).colored(BLUE),
        floor(-2.0 * k),
    ];
    let line = Line::new([0.0, 0.0, -2.0 * k], pixel_ray(some_pixel(d)));
    let light = Lamp {
        power: 100.0 * k * k,
        ..lamp(scale(LAMP.light, k))
    };
    Case::shade(line, objs, light, stretched(ENDS, k))
}

fn stretched(ends: Ends, k: f64) -> Ends {
    ends.map(|end| end * k)
}

fn lengthened(d: &mut Draw, length: f64) -> Case {
    let line = Line::new([0.0, 0.0, -2.0], scale(pixel_ray(some_pixel(d)), length));
    Case::shade(line, lab(), LAMP, stretched(ENDS, 1.0 / length))
}

/// A ray from `o`, looking at `at`, up to 30 degrees aside.
fn view(d: &mut Draw, o: [f64; 3], at: [f64; 3], objs: Vec<Shape>, light: [f64; 3]) -> Case {
    let forward = unit(sub(at, o));
    let right = unit(cross(forward, [0.0, 1.0, 0.0]));
    let up = cross(right, forward);
    let (x, y) = (d.number(-0.4, 0.4), d.number(-0.4, 0.3));
    Case::shade(
        Line::new(o, unit(along(along(forward, x, right), y, up))),
        objs,
        lamp(light),
        ENDS,
    )
}

/// Planes at -2 and -1.999, the camera between them or above.
fn under_roof(d: &mut Draw, height: f64) -> Case {
    let roof = plane([0.0, -1.999, 0.0], [0.0, 1.0, 0.0]).colored(BLUE);
    let direction = unit([
        d.turn(&[0.0, 0.1, -0.3]),
        -1.0,
        d.turn(&[3.0, 0.5, 0.0, 10.0]),
    ]);
    Case::shade(
        Line::new([0.0, height, -2.0], direction),
        vec![floor(-2.0), roof],
        LAMP,
        ENDS,
    )
}

/// Between two planes that come closer and closer.
fn thin_gap(d: &mut Draw) -> Case {
    let gap = d.turn(&[0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6]);
    let roof = plane([0.0, d.round(-2.0 + gap), 0.0], [0.0, 1.0, 0.0]).colored(BLUE);
    let line = Line::new([0.0, -2.0 + gap / 2.0, 0.0], [0.0, -1.0, 0.0]);
    Case::shade(line, vec![floor(-2.0), roof], lamp([0.0, 10.0, 1.0]), ENDS).note("gap", gap)
}

/// Points of a floor within some roundoffs of the edge of the sphere's shadow.
fn shadow_edge(d: &mut Draw) -> Case {
    // The light is at height 10 above a sphere at height 3; tangent is that of the half angle under which it sees it.
    let radius: f64 = d.turn(&[1.0, 0.5, 2.0]);
    let tangent = radius / (49.0 - radius * radius).sqrt();
    let slack = d.turn(&[0.0, 4.0, -4.0, 1e3, -1e3]) * d.format.unit_roundoff();
    let aside = d.exact_unit();
    let aside = unit([aside[0], 0.0, aside[2]]);
    let target = add(
        [0.0, -2.0, 0.0],
        scale(aside, 12.0 * tangent * (1.0 + slack)),
    );
    let o = [0.0, 0.0, -2.0];
    let objs = vec![floor(-2.0), sphere([0.0, 3.0, 0.0], radius).colored(BLUE)];
    Case::shade(
        Line::new(o, sub(target, o)),
        objs,
        lamp([0.0, 10.0, 0.0]),
        ENDS,
    )
}

fn random_scene(d: &mut Draw) -> Case {
    let mut objs: Vec<Shape> = (0..3)
        .map(|_| {
            let color = [(); 3].map(|()| d.number(0.0, 1.0));
            sphere(d.point(3.0), d.number(0.3, 1.5)).colored(color)
        })
        .collect();
    objs.push(plane([0.0, -4.0, 0.0], d.unit()).colored(RED));
    let (o, light) = (d.point(8.0), d.point(8.0));
    let target = d.point(1.5);
    Case::shade(Line::new(o, unit(sub(target, o))), objs, lamp(light), ENDS)
}
