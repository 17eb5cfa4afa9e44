//! Clauses 5.1 and 5.2: any hit.

use super::check::{Verdict, holds, ray, span, vector};
use super::counted::{Counted, operations};
use ombrage::{
    DirectLighting, Figure, Float, Integrator, Invalid, Picture, Plane, PointLight, Quality, Ray,
    Real, Scene, Shadow, ShadowQuery, Shape, Size, Span, Sphere, Triple, Vector,
};

/// The question for any hit, and what it costs in a scene of so many spheres, the first of them
/// hit.
pub struct Asking<F: Float> {
    any: fn(&Scene<F>, &Ray<F>, &Span<F>) -> bool,
    cost: fn(usize) -> u64,
}

/// Clause 5.1: whether there is any hit in the interval; stops at the first.
pub fn check_5_1<F: Float>(asking: impl Fn() -> Asking<F>) -> Verdict {
    let Asking { any, cost } = asking();
    let scene = || -> Result<Scene<F>, Invalid> {
        let sphere = Sphere::new(vector::<F>([0.0, 0.0, 8.0]), F::from_f64(2.0))?;
        let plane = Plane::new(vector::<F>([0.0, -2.0, 0.0]), vector::<F>([0.0, 1.0, 0.0]))?;
        Scene::new(vector::<F>([0.0; 3]), F::from_f64(1000.0))?
            .with_sphere(sphere, vector::<F>([1.0; 3]))?
            .with_plane(plane, vector::<F>([1.0; 3]))
    };
    let scene = scene().map_err(|error| error.to_string())?;
    let (along, down, o) = ([0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [0.0; 3]);
    let cases = [
        ("both roots", o, along, [0.0, 1000.0], true),
        ("only the near root", o, along, [0.0, 8.0], true),
        ("only the far root", o, along, [8.0, 20.0], true),
        ("between the roots", o, along, [7.0, 9.0], false),
        ("before the sphere", o, along, [0.0, 5.5], false),
        ("ends at the near root", o, along, [0.0, 6.0], true),
        ("starts at the far root", o, along, [10.0, 20.0], true),
        ("beyond the sphere", o, along, [10.5, 20.0], false),
        (
            "behind the origin",
            [0.0, 0.0, 20.0],
            along,
            [0.0, 1000.0],
            false,
        ),
        ("from inside", [0.0, 0.0, 8.0], along, [0.0, 1000.0], true),
        ("the plane", o, down, [0.0, 1000.0], true),
        ("ends at the plane", o, down, [0.0, 2.0], true),
        ("starts at the plane", o, down, [2.0, 3.0], true),
        ("before the plane", o, down, [0.0, 1.5], false),
        (
            "the plane from below",
            [0.0, -4.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 3.0],
            true,
        ),
        (
            "beside everything",
            o,
            [1.0, 0.0, 0.0],
            [0.0, 1000.0],
            false,
        ),
    ];
    for (name, origin, direction, interval, expected) in cases {
        let actual = any(&scene, &ray(origin, direction), &span(interval));
        holds!(
            "5.1",
            actual == expected,
            "{name}: {actual} instead of {expected}"
        );
    }
    let (one, many) = (cost(1), cost(64));
    holds!(
        "5.1",
        one == many,
        "{one} operations with 1 sphere, {many} with 64, the first one hit"
    );
    Ok(())
}

/// Spheres between the plane y = 0 and a light, so that each of them is met by a ray straight up.
fn covered<F: Float>(spheres: usize) -> Result<Scene<F>, Invalid> {
    let (white, up) = (vector::<F>([1.0; 3]), vector::<F>([0.0, 1.0, 0.0]));
    let light = PointLight::new(vector::<F>([0.0, 1000.0, 0.0]), white, F::from_f64(1.0))?;
    let plane = Plane::new(vector::<F>([0.0; 3]), up)?;
    let mut scene = Scene::new(white, F::from_f64(1000.0))?
        .with_plane(plane, white)?
        .with_light(light);
    for i in 0..spheres {
        let center = vector::<F>([0.0, 10.0 + 4.0 * i as f64, 0.0]);
        scene = scene.with_sphere(Sphere::new(center, F::from_f64(1.0))?, white)?;
    }
    Ok(scene)
}

/// A counted ray along the y axis.
fn counted_ray<F: Float>(y: f64, toward: f64) -> Ray<Counted<F>> {
    let on_axis = |y| Triple::constant((), [0.0, y, 0.0]);
    Ray {
        origin: on_axis(y),
        direction: on_axis(toward),
    }
}

fn counted_span<F: Float>() -> Span<Counted<F>> {
    let end = |t| Counted::splat((), F::from_f64(t));
    Span::new(end(0.5), end(900.0))
}

pub fn kit_of_scene<F: Float>() -> Asking<F> {
    Asking {
        any: |scene, ray, span| scene.intersect_any(ray, span, Quality::Textbook),
        cost: |spheres| {
            let scene = covered::<F>(spheres).expect("the scene is valid");
            operations(|| {
                scene.intersect_any(&counted_ray(1.0, 1.0), &counted_span(), Quality::Textbook)
            })
        },
    }
}

pub fn kit_of_shapes<F: Float>() -> Asking<F> {
    Asking {
        any: |scene, ray, span| {
            scene
                .spheres()
                .iter()
                .any(|sphere| sphere.shape.intersect_any(ray, span, Quality::Textbook))
                || scene
                    .planes()
                    .iter()
                    .any(|plane| plane.shape.intersect_any(ray, span, Quality::Textbook))
        },
        ..kit_of_scene()
    }
}

pub fn does_not_stop<F: Float>() -> Asking<F> {
    Asking {
        cost: |spheres| {
            let scene = covered::<F>(spheres).expect("the scene is valid");
            operations(|| {
                scene
                    .intersect(&counted_ray(1.0, 1.0), &counted_span(), Quality::Textbook)
                    .mask
            })
        },
        ..kit_of_scene()
    }
}

pub fn no_end<F: Float>() -> Asking<F> {
    let any = |scene: &Scene<F>, ray: &Ray<F>, span: &Span<F>| {
        scene.intersect_any(
            ray,
            &Span {
                max: F::MAX,
                ..*span
            },
            Quality::Textbook,
        )
    };
    Asking {
        any,
        ..kit_of_scene()
    }
}

pub fn no_start<F: Float>() -> Asking<F> {
    let any = |scene: &Scene<F>, ray: &Ray<F>, span: &Span<F>| {
        scene.intersect_any(
            ray,
            &Span {
                min: -F::MAX,
                ..*span
            },
            Quality::Textbook,
        )
    };
    Asking {
        any,
        ..kit_of_scene()
    }
}

pub fn near_root_only<F: Float>() -> Asking<F> {
    let any = |scene: &Scene<F>, ray: &Ray<F>, span: &Span<F>| {
        let whole = Span::new(-F::MAX, F::MAX);
        span.contains(scene.intersect(ray, &whole, Quality::Textbook).distance)
            && scene.intersect_any(ray, &whole, Quality::Textbook)
    };
    Asking {
        any,
        ..kit_of_scene()
    }
}

/// What Figure 3(c) looks like, and what its shadow rays cost under `usize` spheres.
pub struct Shadowing {
    figure: fn() -> Picture,
    cost: fn(usize) -> u64,
}

/// Clause 5.2: shadow rays ask for any hit, and the picture stays Figure 3(c).
pub fn check_5_2<F: Float>(shadowing: impl Fn() -> Shadowing) -> Verdict {
    let Shadowing { figure, cost } = shadowing();
    let (one, many) = (cost(1), cost(64));
    holds!(
        "5.2",
        one == many,
        "a shadow ray takes {one} operations under 1 sphere, {many} under 64"
    );
    let same = figure() == draw::<F>(Some(ShadowQuery::Nearest));
    holds!(
        "5.2",
        same,
        "the picture is another than by nearest hit ({})",
        F::NAME
    );
    Ok(())
}

/// Figure 3(c), as it is or with another question of its shadow rays.
fn draw<F: Float>(query: Option<ShadowQuery>) -> Picture {
    let figure = Figure::named("3c").expect("one of the six figures");
    let integrator = match query {
        None => figure.integrator,
        Some(query) => {
            let shadow = Some(Shadow::UlpOffset);
            Integrator::DirectLighting(DirectLighting {
                quality: Quality::Textbook,
                shadow,
                query,
            })
        }
    };
    let figure = Figure {
        integrator,
        ..*figure
    };
    figure
        .draw::<F>(Size::LAB)
        .expect("the lab's scene is valid")
}

/// The operations of a pixel's radiance, less those without a shadow ray.
fn cost_of_shadow<F: Float>(integrator: Integrator, spheres: usize) -> u64 {
    let scene = covered::<F>(spheres).expect("the scene is valid");
    let unshadowed = DirectLighting {
        quality: Quality::Textbook,
        shadow: None,
        query: ShadowQuery::Any,
    };
    let ray = counted_ray::<F>(1.0, -1.0);
    let all = operations(|| integrator.radiance(&scene, &ray));
    let lit = operations(|| Integrator::DirectLighting(unshadowed).radiance(&scene, &ray));
    all - lit
}

pub fn kit_figure_3c<F: Float>() -> Shadowing {
    Shadowing {
        figure: || draw::<F>(None),
        cost: |spheres| {
            let figure = Figure::named("3c").expect("one of the six figures");
            cost_of_shadow::<F>(figure.integrator, spheres)
        },
    }
}

pub fn asks_for_the_nearest<F: Float>() -> Shadowing {
    let cost = |spheres| {
        let (shadow, query) = (Some(Shadow::UlpOffset), ShadowQuery::Nearest);
        let integrator = Integrator::DirectLighting(DirectLighting {
            quality: Quality::Textbook,
            shadow,
            query,
        });
        cost_of_shadow::<F>(integrator, spheres)
    };
    Shadowing {
        cost,
        ..kit_figure_3c::<F>()
    }
}

pub fn another_picture<F: Float>() -> Shadowing {
    let figure = || {
        let figure = Figure::named("2b").expect("one of the six figures");
        figure
            .draw::<F>(Size::LAB)
            .expect("the lab's scene is valid")
    };
    Shadowing {
        figure,
        ..kit_figure_3c::<F>()
    }
}
