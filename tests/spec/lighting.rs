//! Clauses 3.1 to 3.3 and 4.1: direct lighting, bytes, and shadows.

use super::check::{Verdict, agrees, holds, near, ray, shows, vector};
use ombrage::{
    DirectLighting, Figure, Film, Float, Integrator, Invalid, Picture, Plane, PointLight, Quality,
    Ray, Scene, Shadow, ShadowQuery, Size, Span, Sphere, Vector,
};

const COLOR: [f64; 3] = [1.0, 0.5, 0.25];
const GREY: [f64; 3] = [0.5; 3];

/// The plane y = 0 with white lights of these positions and powers.
fn lit_plane<F: Float>(lights: &[([f64; 3], f64)]) -> Result<Scene<F>, Invalid> {
    let plane = Plane::new(vector::<F>([0.0; 3]), vector::<F>([0.0, 1.0, 0.0]))?;
    let scene = Scene::new(vector::<F>(GREY), F::from_f64(1000.0))?;
    let mut scene = scene.with_plane(plane, vector::<F>(COLOR))?;
    for &(position, power) in lights {
        let white = vector::<F>([1.0; 3]);
        scene = scene.with_light(PointLight::new(
            vector::<F>(position),
            white,
            F::from_f64(power),
        )?);
    }
    Ok(scene)
}

/// Clause 3.1: the sum of `color * radiance * max(0, cos)` over all lights.
pub fn check_3_1<F: Float>(radiance: impl Fn(&Scene<F>, &Ray<F>) -> F::Vector) -> Verdict {
    let (above, below) = ([0.0, 2.0, 0.0], [0.0, -2.0, 0.0]);
    let (down, up) = ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
    let aslant = [3.0, 4.0, 0.0];
    let cases: [(&str, &[_], _, _, _); 6] = [
        (
            "light overhead",
            &[(above, 8.0)],
            above,
            down,
            COLOR.map(|c| 2.0 * c),
        ),
        (
            "light aslant",
            &[(aslant, 25.0)],
            above,
            down,
            COLOR.map(|c| 0.8 * c),
        ),
        (
            "light behind the surface",
            &[(below, 8.0)],
            above,
            down,
            [0.0; 3],
        ),
        (
            "eye and light below",
            &[(below, 8.0)],
            below,
            up,
            COLOR.map(|c| 2.0 * c),
        ),
        (
            "two lights",
            &[(above, 8.0), (aslant, 25.0)],
            above,
            down,
            COLOR.map(|c| 2.8 * c),
        ),
        ("nothing hit", &[(above, 8.0)], above, up, GREY),
    ];
    for (name, lights, eye, direction, expected) in cases {
        let scene = lit_plane::<F>(lights).map_err(|error| error.to_string())?;
        let actual = radiance(&scene, &ray(eye, direction));
        // Light and cosine: at most 16 roundings.
        agrees!("3.1", near::<F>(name, expected, actual, 16));
    }
    Ok(())
}

/// Clause 4.1: a light contributes only where it is visible.
pub fn check_4_1<F: Float>(radiance: impl Fn(&Scene<F>, &Ray<F>) -> F::Vector) -> Verdict {
    let (white, number) = (vector::<F>([1.0; 3]), F::from_f64);
    let sphere = |y: f64| Sphere::new(vector::<F>([0.0, y, 0.0]), number(1.0));
    let plane = |y: f64| Plane::new(vector::<F>([0.0, y, 0.0]), vector::<F>([0.0, 1.0, 0.0]));
    let scenes = || -> Result<_, Invalid> {
        let one = || lit_plane::<F>(&[([0.0, 8.0, 0.0], 64.0)]);
        let two = lit_plane::<F>(&[([0.0, 8.0, 0.0], 64.0), ([6.0, 8.0, 0.0], 100.0)])?;
        Ok([
            ("nothing between", one()?, 1.0),
            (
                "a sphere between",
                one()?.with_sphere(sphere(4.0)?, white)?,
                0.0,
            ),
            (
                "a sphere beyond the light",
                one()?.with_sphere(sphere(12.0)?, white)?,
                1.0,
            ),
            (
                "a sphere behind the surface",
                one()?.with_sphere(sphere(-4.0)?, white)?,
                1.0,
            ),
            (
                "a sphere around point and eye",
                {
                    let around = Sphere::new(vector::<F>([0.0; 3]), number(5.0))?;
                    one()?.with_sphere(around, white)?
                },
                0.0,
            ),
            (
                "a plane between",
                one()?.with_plane(plane(4.0)?, white)?,
                0.0,
            ),
            (
                "a plane through the light",
                one()?.with_plane(plane(8.0)?, white)?,
                0.0,
            ),
            (
                "a plane beyond the light",
                one()?.with_plane(plane(9.0)?, white)?,
                1.0,
            ),
            (
                "a plane behind the surface",
                one()?.with_plane(plane(-1.0)?, white)?,
                1.0,
            ),
            (
                "one of two lights is hidden",
                two.with_sphere(sphere(4.0)?, white)?,
                0.8,
            ),
        ])
    };
    for (name, scene, expected) in scenes().map_err(|error| error.to_string())? {
        let actual = radiance(&scene, &ray([0.0, 2.0, 0.0], [0.0, -1.0, 0.0]));
        agrees!(
            "4.1",
            near::<F>(name, COLOR.map(|c| expected * c), actual, 16)
        );
    }
    Ok(())
}

pub fn kit_unshadowed<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    let direct = DirectLighting {
        quality: Quality::Textbook,
        shadow: None,
        query: ShadowQuery::Any,
    };
    Integrator::DirectLighting(direct).radiance(scene, ray)
}

pub fn kit_by_any_hit<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    let direct = DirectLighting {
        quality: Quality::Textbook,
        shadow: Some(Shadow::UlpOffset),
        query: ShadowQuery::Any,
    };
    Integrator::DirectLighting(direct).radiance(scene, ray)
}

pub fn kit_by_nearest_hit<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    let direct = DirectLighting {
        quality: Quality::Textbook,
        shadow: Some(Shadow::UlpOffset),
        query: ShadowQuery::Nearest,
    };
    Integrator::DirectLighting(direct).radiance(scene, ray)
}

/// A plain loop over the lights, to be bent: `term` is the contribution of one light.
fn bent<F: Float>(
    scene: &Scene<F>,
    ray: &Ray<F>,
    term: impl Fn(&ombrage::HitRecord<F>, &ombrage::LightSample<F>) -> F::Vector,
) -> F::Vector {
    let hit = scene.intersect(
        ray,
        &Span::new(F::default(), scene.t_max()),
        Quality::Textbook,
    );
    if !hit.mask {
        return scene.background();
    }
    let black = vector::<F>([0.0; 3]);
    scene.lights().iter().fold(black, |sum, light| {
        sum + term(&hit, &light.sample(hit.point, Quality::Textbook))
    })
}

fn positive<F: Float>(x: F) -> F {
    F::select(x.gt(F::default()), x, F::default())
}

pub fn cosine_below_zero_kept<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    bent(scene, ray, |hit, light| {
        hit.color * light.radiance * hit.normal.dot(light.direction)
    })
}

pub fn divided_by_pi<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    bent(scene, ray, |hit, light| {
        let cosine = positive(hit.normal.dot(light.direction));
        hit.color * light.radiance * (cosine * F::from_f64(std::f64::consts::FRAC_1_PI))
    })
}

pub fn material_ignored<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    bent(scene, ray, |hit, light| {
        light.radiance * positive(hit.normal.dot(light.direction))
    })
}

pub fn cosine_left_out<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    bent(scene, ray, |hit, light| {
        let faces = hit.normal.dot(light.direction).gt(F::default());
        F::Vector::select(faces, hit.color * light.radiance, vector::<F>([0.0; 3]))
    })
}

pub fn background_black<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    let missed = !scene.intersect_any(
        ray,
        &Span::new(F::default(), scene.t_max()),
        Quality::Textbook,
    );
    F::Vector::select(missed, vector::<F>([0.0; 3]), kit_unshadowed(scene, ray))
}

pub fn only_the_first_light<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    let empty = Scene::new(scene.background(), scene.t_max()).expect("the scene is valid");
    let plane = scene.planes()[0];
    let dimmed = empty
        .with_plane(plane.shape, plane.color())
        .expect("the scene is valid");
    kit_unshadowed(&dimmed.with_light(scene.lights()[0]), ray)
}

/// Shadowed with another interval than [0, distance].
fn shadowed_within<F: Float>(
    scene: &Scene<F>,
    ray: &Ray<F>,
    within: impl Fn(F) -> Span<F>,
) -> F::Vector {
    bent(scene, ray, |hit, light| {
        let shadow = Shadow::UlpOffset.ray(scene, hit, light.direction, light.distance);
        let span = within(light.distance);
        let blocked = scene.intersect_any(&shadow.ray, &span, Quality::Textbook);
        let lit = hit.color * light.radiance * positive(hit.normal.dot(light.direction));
        F::Vector::select(blocked, vector::<F>([0.0; 3]), lit)
    })
}

pub fn no_end_at_the_light<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    shadowed_within(scene, ray, |_| Span::new(F::default(), F::MAX))
}

pub fn no_start_at_the_surface<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    shadowed_within(scene, ray, |distance| Span::new(-F::MAX, distance))
}

pub fn ends_halfway<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    shadowed_within(scene, ray, |distance| {
        Span::new(F::default(), distance * F::from_f64(0.25))
    })
}

/// How radiance becomes bytes, and the figure that shows it.
pub struct Filming<F> {
    /// The byte as a number; what is above 255 would be cut off by a conversion.
    byte: fn(F) -> F,
    figure: fn() -> Picture,
}

/// Clause 3.2: the truncated level, modulo 256.
pub fn check_3_2<F: Float>(filming: impl Fn() -> Filming<F>) -> Verdict {
    let Filming { byte, figure } = filming();
    for (level, expected) in [
        (0.0, 0.0),
        (127.5, 127.0),
        (255.0, 255.0),
        (255.5, 255.0),
        (256.5, 0.0),
        (260.5, 4.0),
        (515.5, 3.0),
    ] {
        let (actual, expected) = (byte(F::from_f64(level / 255.0)), F::from_f64(expected));
        holds!(
            "3.2",
            actual == expected,
            "level {level} is byte {actual} instead of {expected}"
        );
    }
    let right = shows(
        &figure(),
        |seen| seen.direct,
        |level| (level as u64 % 256) as u8,
    );
    holds!(
        "3.2",
        right.is_ok(),
        "Figure 2(a) in {}: {right:?}",
        F::NAME
    );
    Ok(())
}

/// Clause 3.3: each component restricted to [0, 1].
pub fn check_3_3<F: Float>(filming: impl Fn() -> Filming<F>) -> Verdict {
    let Filming { byte, figure } = filming();
    for (x, expected) in [
        (0.0, 0.0),
        (0.5, 127.0),
        (1.0, 255.0),
        (1.02, 255.0),
        (300.0, 255.0),
        (-0.5, 0.0),
    ] {
        let (actual, expected) = (byte(F::from_f64(x)), F::from_f64(expected));
        holds!(
            "3.3",
            actual == expected,
            "{x} is byte {actual} instead of {expected}"
        );
    }
    let right = shows(&figure(), |seen| seen.direct, |level| level as u8);
    holds!(
        "3.3",
        right.is_ok(),
        "Figure 2(b) in {}: {right:?}",
        F::NAME
    );
    Ok(())
}

fn draw<F: Float>(name: &str, film: Option<Film>) -> Picture {
    let figure = Figure::named(name).expect("one of the six figures");
    let film = film.unwrap_or(figure.film);
    Figure { film, ..*figure }
        .draw::<F>(Size::LAB)
        .expect("the lab's scene is valid")
}

fn wrap<F: Float>(x: F) -> F {
    Film::Wrap.byte(x)
}

fn clamp<F: Float>(x: F) -> F {
    Film::Clamp.byte(x)
}

pub fn kit_wrap<F: Float>() -> Filming<F> {
    Filming {
        byte: wrap,
        figure: || draw::<F>("2a", None),
    }
}

pub fn kit_clamp<F: Float>() -> Filming<F> {
    Filming {
        byte: clamp,
        figure: || draw::<F>("2b", None),
    }
}

pub fn saturating_bytes<F: Float>() -> Filming<F> {
    Filming {
        byte: clamp,
        ..kit_wrap()
    }
}

pub fn wrapping_bytes<F: Float>() -> Filming<F> {
    Filming {
        byte: wrap,
        ..kit_clamp()
    }
}

pub fn saturating_figure<F: Float>() -> Filming<F> {
    Filming {
        figure: || draw::<F>("2a", Some(Film::Clamp)),
        ..kit_wrap()
    }
}

pub fn wrapping_figure<F: Float>() -> Filming<F> {
    Filming {
        figure: || draw::<F>("2b", Some(Film::Wrap)),
        ..kit_clamp()
    }
}

pub fn rounding_to_nearest<F: Float>() -> Filming<F> {
    Filming {
        byte: |x| F::from_f64((x.to_f64().clamp(0.0, 1.0) * 255.0).round()),
        ..kit_clamp()
    }
}
