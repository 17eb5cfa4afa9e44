//! Nearest and any hit of whole scenes.

use crate::exact::exact;
use crate::property::{Sample, for_all, is_unit, number, positive, ray, vector};
use ombrage::{Invalid, Plane, PointLight, Quality, Ray, Scene, Shape, Span, Sphere, Vector};
use proptest::prelude::*;
use std::cell::Cell;

/// The shapes of a scene; their colours play no part.
#[derive(Clone, Debug)]
struct Shapes<F: Sample> {
    spheres: Vec<Sphere<F>>,
    planes: Vec<Plane<F>>,
}

impl<F: Sample> Shapes<F> {
    fn scene(&self) -> Result<Scene<F>, TestCaseError> {
        let build = || -> Result<_, Invalid> {
            let black = F::Vector::constant((), [0.0; 3]);
            let mut scene = Scene::new(black, F::from_f64(1000.0))?;
            for sphere in &self.spheres {
                scene = scene.with_sphere(*sphere, black)?;
            }
            for plane in &self.planes {
                scene = scene.with_plane(*plane, black)?;
            }
            Ok(scene)
        };
        build().map_err(|error| TestCaseError::fail(error.to_string()))
    }
}

fn shapes<F: Sample>() -> impl Strategy<Value = Shapes<F>> {
    use proptest::collection::vec;
    let sphere = (vector::<F>(-4..5), positive::<F>(-2..3));
    let sphere = sphere.prop_filter_map("a sphere", |(c, r)| Sphere::new(c, r).ok());
    let plane = (vector::<F>(-2..6), vector::<F>(-3..3));
    let plane = plane.prop_filter_map("a plane", |(q, n)| Plane::new(q, n).ok());
    let parts = (vec(sphere, 0..5), vec(plane, 0..2));
    parts.prop_map(|(spheres, planes)| Shapes { spheres, planes })
}

fn spans<F: Sample>() -> impl Strategy<Value = Span<F>> {
    let start = prop_oneof![Just(F::default()), number::<F>(-4..2)];
    (start, positive::<F>(-3..6)).prop_map(|(min, length)| Span::new(min, min + length))
}

pub fn any_hit_is_whether_a_nearest_hit_exists<F: Sample>() {
    for_all(
        (shapes::<F>(), ray::<F>(-4..5), spans::<F>()),
        |(shapes, ray, span)| {
            let scene = shapes.scene()?;
            let nearest = scene.intersect(&ray, &span, Quality::Textbook);
            prop_assert_eq!(
                scene.intersect_any(&ray, &span, Quality::Textbook),
                nearest.mask
            );
            if nearest.mask {
                let only = Span::new(nearest.distance, nearest.distance);
                prop_assert!(
                    scene.intersect_any(&ray, &only, Quality::Textbook),
                    "no hit at the nearest hit's t"
                );
                prop_assert!(span.contains(nearest.distance));
            }
            Ok(())
        },
    );
}

/// What a plane or sphere does to a stretch of a ray, by another geometry than the kernels', in
/// `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Oracle {
    Hit,
    Miss,
    /// A decision is nearer to its border than the kernels' rounding may carry it.
    Unsure,
}

/// Where t certainly lies, if it is known to `slack`.
fn on_stretch(t: f64, [min, max]: [f64; 2], slack: f64) -> Oracle {
    if t > min + slack && t < max - slack {
        Oracle::Hit
    } else if t < min - slack || t > max + slack {
        Oracle::Miss
    } else {
        Oracle::Unsure
    }
}

type Three = [f64; 3];

fn f64s<F: Sample>(v: F::Vector) -> Three {
    v.to_array().map(ombrage::Scalar::to_f64)
}

fn dot(a: Three, b: Three) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn sub(a: Three, b: Three) -> Three {
    std::array::from_fn(|i| a[i] - b[i])
}

/// By the heights over the plane of two points of the ray.
fn plane_oracle(q: Three, n: Three, o: Three, d: Three, stretch: [f64; 2]) -> Oracle {
    let height = |p| dot(sub(p, q), n) / dot(n, n).sqrt();
    let start = height(o);
    let sinks = start - height(std::array::from_fn(|i| o[i] + d[i]));
    if sinks.abs() < 1e-3 * dot(d, d).sqrt() {
        return Oracle::Unsure;
    }
    let t = start / sinks;
    on_stretch(t, stretch, 1e-3 * (1.0 + t.abs()) + 1e-2 / sinks.abs())
}

/// By the point of the ray nearest to the centre and half of the chord.
fn sphere_oracle(c: Three, r: f64, o: Three, d: Three, stretch: [f64; 2]) -> Oracle {
    let (to_center, length) = (sub(c, o), dot(d, d).sqrt());
    let along = dot(to_center, d) / length;
    let far = dot(to_center, to_center);
    let chord = r * r - (far - along * along);
    if chord.abs() < 1e-4 * (far + r * r) {
        return Oracle::Unsure;
    }
    if chord < 0.0 {
        return Oracle::Miss;
    }
    let half = chord.sqrt();
    let slack = 1e-3 * (1.0 + far.sqrt() + r) / length;
    let roots = [along - half, along + half].map(|way| on_stretch(way / length, stretch, slack));
    match roots {
        [Oracle::Hit, _] | [_, Oracle::Hit] => Oracle::Hit,
        [Oracle::Miss, Oracle::Miss] => Oracle::Miss,
        _ => Oracle::Unsure,
    }
}

/// The rounding of `f32` carries t by some 1e-5 of the distances here; the margins are 1e-3 and
/// more.
pub fn any_hit_is_that_of_a_naive_oracle<F: Sample>() {
    let (cases, hits, misses) = (Cell::new(0), Cell::new(0), Cell::new(0));
    for_all(
        (shapes::<F>(), ray::<F>(-4..5), spans::<F>()),
        |(shapes, ray, span)| {
            let (o, d) = (f64s::<F>(ray.origin), f64s::<F>(ray.direction));
            let stretch = [span.min.to_f64(), span.max.to_f64()];
            let spheres = shapes.spheres.iter().map(|sphere| {
                sphere_oracle(
                    f64s::<F>(sphere.center()),
                    sphere.radius().to_f64(),
                    o,
                    d,
                    stretch,
                )
            });
            let planes = shapes.planes.iter();
            let planes = planes.map(|plane| {
                plane_oracle(
                    f64s::<F>(plane.point()),
                    f64s::<F>(plane.normal()),
                    o,
                    d,
                    stretch,
                )
            });
            let answers: Vec<Oracle> = spheres.chain(planes).collect();
            cases.set(cases.get() + 1);
            let any = shapes
                .scene()?
                .intersect_any(&ray, &span, Quality::Textbook);
            if answers.contains(&Oracle::Hit) {
                hits.set(hits.get() + 1);
                prop_assert!(any, "a hit is missed: {answers:?}");
            } else if !answers.contains(&Oracle::Unsure) {
                misses.set(misses.get() + 1);
                prop_assert!(!any, "a miss is a hit: {answers:?}");
            }
            Ok(())
        },
    );
    let (hits, misses, enough) = (hits.get(), misses.get(), cases.get() / 16);
    assert!(
        hits > enough && misses > enough,
        "{hits} sure hits and {misses} sure misses"
    );
}

pub fn any_hit_does_not_depend_on_the_order_of_objects<F: Sample>() {
    let inputs = (shapes::<F>(), ray::<F>(-4..5), spans::<F>(), 0..4usize);
    for_all(inputs, |(mut shapes, ray, span, turn)| {
        let any = shapes
            .scene()?
            .intersect_any(&ray, &span, Quality::Textbook);
        let nearest = shapes.scene()?.intersect(&ray, &span, Quality::Textbook);
        let turn = turn % shapes.spheres.len().max(1);
        shapes.spheres.rotate_left(turn);
        shapes.planes.reverse();
        prop_assert_eq!(
            shapes
                .scene()?
                .intersect_any(&ray, &span, Quality::Textbook),
            any
        );
        let turned = shapes.scene()?.intersect(&ray, &span, Quality::Textbook);
        prop_assert_eq!(turned.mask, nearest.mask);
        prop_assert!(!any || turned.distance == nearest.distance);
        Ok(())
    });
}

pub fn any_hit_grows_with_t_max<F: Sample>() {
    let inputs = (
        shapes::<F>(),
        ray::<F>(-4..5),
        spans::<F>(),
        positive::<F>(-3..6),
    );
    for_all(inputs, |(shapes, ray, span, more)| {
        let scene = shapes.scene()?;
        let longer = Span::new(span.min, span.max + more);
        let grows = !scene.intersect_any(&ray, &span, Quality::Textbook)
            || scene.intersect_any(&ray, &longer, Quality::Textbook);
        prop_assert!(grows, "a hit is lost in a longer interval");
        let (first, then) = (
            scene.intersect(&ray, &span, Quality::Textbook),
            scene.intersect(&ray, &longer, Quality::Textbook),
        );
        prop_assert!(
            !first.mask || first.distance == then.distance,
            "the nearest hit moves"
        );
        Ok(())
    });
}

/// The scalar product with the ray is not above 0 as the kernel computes it, to the bit.
pub fn normals_face_the_ray_and_have_unit_length<F: Sample>() {
    for_all(
        (shapes::<F>(), ray::<F>(-4..5), spans::<F>()),
        |(shapes, ray, span)| {
            let hit = shapes.scene()?.intersect(&ray, &span, Quality::Textbook);
            if hit.mask {
                let along = hit.normal.dot(ray.direction);
                prop_assert!(
                    along <= F::default(),
                    "the normal points along the ray: {along:e}"
                );
                is_unit::<F>(hit.normal)?;
            }
            Ok(())
        },
    );
}

pub fn the_nearest_hit_is_the_nearest_of_all_objects<F: Sample>() {
    for_all(
        (shapes::<F>(), ray::<F>(-4..5), spans::<F>()),
        |(shapes, ray, span)| {
            let hit = shapes.scene()?.intersect(&ray, &span, Quality::Textbook);
            let spheres = shapes
                .spheres
                .iter()
                .map(|sphere| sphere.intersect(&ray, &span, Quality::Textbook));
            let planes = shapes
                .planes
                .iter()
                .map(|plane| plane.intersect(&ray, &span, Quality::Textbook));
            let hits = spheres
                .chain(planes)
                .enumerate()
                .filter(|(_, hit)| hit.mask);
            let order = |a: &F, b: &F| a.to_f64().total_cmp(&b.to_f64());
            let nearest = hits.min_by(|(_, a), (_, b)| order(&a.t, &b.t));
            prop_assert_eq!(hit.mask, nearest.is_some());
            if let Some((number, nearest)) = nearest {
                prop_assert_eq!(hit.distance, nearest.t);
                prop_assert_eq!(hit.object.to_f64(), number as f64);
                prop_assert_eq!(hit.point, Ray::point_at(&ray, nearest.t));
            }
            Ok(())
        },
    );
}

fn scene_of(color: Three, radius: f64, far: f64, power: f64) -> Result<Scene<f64>, Invalid> {
    let vector = glam::DVec3::from;
    let sphere = Sphere::new(vector([0.1, 0.2, 0.3]), radius)?;
    let plane = Plane::new(vector([far, -2.1, 0.7]), vector([0.1, 1.0, 0.2]))?;
    let light = PointLight::new(vector([1.1, 10.1, far]), vector(color), power)?;
    let scene = Scene::new(vector(color), 1000.1)?;
    Ok(scene
        .with_sphere(sphere, vector(color))?
        .with_plane(plane, vector(color))?
        .with_light(light))
}

/// `Scene::cast` rounds every number to the format, and to `f64` changes nothing.
pub fn cast_rounds_every_number<F: Sample>() {
    let scene = scene_of([0.1, 0.2, 0.7], 0.3, 1e7 + 0.3, 99.9).expect("the scene is valid");
    assert_eq!(scene.cast::<f64>().as_ref(), Ok(&scene));
    let cast = scene
        .cast::<F>()
        .expect("the scene is valid in every format");
    let vector = |v: glam::DVec3| F::Vector::constant((), v.to_array());
    let (sphere, plane, light) = (scene.spheres()[0], scene.planes()[0], scene.lights()[0]);
    let (round, flat, lamp) = (cast.spheres()[0], cast.planes()[0], cast.lights()[0]);
    assert_eq!(cast.background(), vector(scene.background()));
    assert_eq!(cast.t_max(), F::from_f64(scene.t_max()));
    assert_eq!(round.shape.center(), vector(sphere.shape.center()));
    assert_eq!(round.shape.radius(), F::from_f64(sphere.shape.radius()));
    assert_eq!(round.color(), vector(sphere.color()));
    assert_eq!(flat.shape.point(), vector(plane.shape.point()));
    assert_eq!(flat.shape.normal(), vector(plane.shape.normal()));
    assert_eq!(flat.color(), vector(plane.color()));
    assert_eq!(lamp.position(), vector(light.position()));
    assert_eq!(lamp.color(), vector(light.color()));
    assert_eq!(lamp.power(), F::from_f64(light.power()));
    // No f32 is nearer to 0.3 than this one.
    let off = (exact(round.shape.radius()) - exact(0.3))
        .to_f64()
        .value()
        .abs();
    assert!(off <= F::EPSILON / 4.0 * 0.5, "{off:e}");
}

/// What overflows or vanishes on the way is refused, with the field's name.
pub fn cast_refuses_what_the_format_cannot_hold<F: Sample>() {
    let field = |scene: Result<Scene<f64>, Invalid>| {
        scene
            .expect("the scene is valid in f64")
            .cast::<F>()
            .err()
            .map(|error| error.field)
    };
    let color = [0.5; 3];
    let only_in_f32 = |name| (F::PRECISION == 24).then_some(name);
    assert_eq!(field(scene_of(color, 1.0, 0.0, 100.0)), None);
    assert_eq!(
        field(scene_of(color, 1e-60, 0.0, 100.0)),
        only_in_f32("sphere radius")
    );
    assert_eq!(
        field(scene_of(color, 1.0, 1e60, 100.0)),
        only_in_f32("plane point")
    );
    assert_eq!(
        field(scene_of(color, 1.0, 0.0, 1e60)),
        only_in_f32("light power")
    );
    assert_eq!(
        field(scene_of([1e60; 3], 1.0, 0.0, 1.0)),
        only_in_f32("background")
    );
}
