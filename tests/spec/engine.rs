//! Clauses E.3 to E.8: the rest of the engine underneath.

use super::check::{Verdict, agrees, holds, near, ray, same_t, span, vector};
use crate::report::differs;
use ombrage::{Film, Float, Integrator, Quality, Ray, Scene, Shape, Span, Sphere, Vector, lab};

type Three = [f64; 3];

/// Clause E.3: the nearest root of a sphere in the closed interval.
pub fn check_e_3<F: Float>(t: impl Fn(Three, f64, &Ray<F>, &Span<F>) -> Option<F>) -> Verdict {
    let (c, o, along) = ([0.0, 0.0, 8.0], [0.0; 3], [0.0, 0.0, 1.0]);
    let cases = [
        ("from outside", o, along, [0.0, 1000.0], Some(6.0)),
        ("from inside", c, along, [0.0, 1000.0], Some(2.0)),
        (
            "on the surface, outward",
            [0.0, 0.0, 10.0],
            along,
            [0.0, 1000.0],
            Some(0.0),
        ),
        (
            "a direction of length 2",
            o,
            [0.0, 0.0, 2.0],
            [0.0, 1000.0],
            Some(3.0),
        ),
        (
            "the interval starts between the roots",
            o,
            along,
            [7.0, 1000.0],
            Some(10.0),
        ),
        (
            "the interval starts at the near root",
            o,
            along,
            [6.0, 1000.0],
            Some(6.0),
        ),
        (
            "the interval ends at the near root",
            o,
            along,
            [0.0, 6.0],
            Some(6.0),
        ),
        (
            "the interval ends at the far root",
            o,
            along,
            [7.0, 10.0],
            Some(10.0),
        ),
        ("the interval lies within", o, along, [7.0, 9.0], None),
        ("tangent", [2.0, 0.0, 0.0], along, [0.0, 1000.0], Some(8.0)),
        ("beside it", [2.5, 0.0, 0.0], along, [0.0, 1000.0], None),
        ("behind", [0.0, 0.0, 20.0], along, [0.0, 1000.0], None),
    ];
    for (name, origin, direction, interval, expected) in cases {
        let ray = ray(origin, direction);
        let actual = t(c, 2.0, &ray, &span(interval));
        agrees!("E.3", same_t(name, &ray, expected.map(F::from_f64), actual));
    }
    Ok(())
}

pub fn kit_sphere<F: Float>(c: Three, r: f64, ray: &Ray<F>, span: &Span<F>) -> Option<F> {
    let sphere = Sphere::new(vector::<F>(c), F::from_f64(r)).ok()?;
    let hit = sphere.intersect(ray, span, Quality::Textbook);
    hit.mask.then_some(hit.t)
}

pub fn near_root_only<F: Float>(c: Three, r: f64, ray: &Ray<F>, span: &Span<F>) -> Option<F> {
    let t = kit_sphere(c, r, ray, &Span::new(-F::MAX, F::MAX))?;
    span.contains(t).then_some(t)
}

pub fn far_root_first<F: Float>(c: Three, r: f64, ray: &Ray<F>, span: &Span<F>) -> Option<F> {
    let near = kit_sphere(c, r, ray, span)?;
    let beyond = Span::new(near.step(F::from_f64(1.0)), span.max);
    kit_sphere(c, r, ray, &beyond).or(Some(near))
}

pub fn open_at_its_end<F: Float>(c: Three, r: f64, ray: &Ray<F>, span: &Span<F>) -> Option<F> {
    kit_sphere(c, r, ray, span).filter(|t| *t < span.max)
}

/// Clause E.4: `color * max(0, dot(normal, -direction))`, or the background.
pub fn check_e_4<F: Float>(radiance: impl Fn(&Scene<F>, &Ray<F>) -> F::Vector) -> Verdict {
    let scene = lab::scene::<F>().map_err(|error| error.to_string())?;
    let cases = [
        (
            "straight at the sphere",
            [0.0, 0.0, -2.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, 1.0],
        ),
        (
            "straight down",
            [5.0, 0.0, 0.0],
            [0.0, -1.0, 0.0],
            [1.0, 0.0, 0.0],
        ),
        ("aslant", [5.0, 0.0, 0.0], [0.8, -0.6, 0.0], [0.6, 0.0, 0.0]),
        (
            "from below the plane",
            [5.0, -5.0, 0.0],
            [0.0, 0.6, 0.8],
            [0.6, 0.0, 0.0],
        ),
        ("nothing hit", [0.0, 2.0, 0.0], [0.0, 1.0, 0.0], [0.5; 3]),
    ];
    for (name, origin, direction, expected) in cases {
        let actual = radiance(&scene, &ray(origin, direction));
        agrees!("E.4", near::<F>(name, expected, actual, 4));
    }
    Ok(())
}

pub fn kit_ray_cast<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    Integrator::RayCast(Quality::Textbook).radiance(scene, ray)
}

pub fn flat_color<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    let hit = scene.intersect(
        ray,
        &Span::new(F::default(), scene.t_max()),
        Quality::Textbook,
    );
    F::Vector::select(hit.mask, hit.color, scene.background())
}

pub fn dark_from_behind<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    let below = ray.direction.y().gt(F::default()) && ray.origin.y().to_f64() < -2.0;
    F::Vector::select(below, vector::<F>([0.0; 3]), kit_ray_cast(scene, ray))
}

/// Clause E.5: primary rays see objects from 0 to 1000, both included.
pub fn check_e_5<F: Float>(radiance: impl Fn(&Scene<F>, &Ray<F>) -> F::Vector) -> Verdict {
    let lab = lab::scene::<F>().map_err(|error| error.to_string())?;
    let plane = lab.planes()[0];
    let plane_only = Scene::new(lab.background(), lab.t_max())
        .and_then(|scene| scene.with_plane(plane.shape, plane.color()))
        .map_err(|error| error.to_string())?;
    let beyond = F::from_f64(998.0).step(F::from_f64(1.0)).to_f64();
    for (name, y, seen) in [
        ("at 0", -2.0, true),
        ("at 1000", 998.0, true),
        ("beyond 1000", beyond, false),
        ("behind", -2.5, false),
    ] {
        let actual = radiance(&plane_only, &ray([0.0, y, 0.0], [0.0, -1.0, 0.0]));
        let expected = if seen { [1.0, 0.0, 0.0] } else { [0.5; 3] };
        let right = actual == vector::<F>(expected);
        holds!(
            "E.5",
            right,
            "a plane {name}: radiance is {actual:?} instead of {expected:?}"
        );
    }
    Ok(())
}

fn seen_within<F: Float>(scene: &Scene<F>, ray: &Ray<F>, span: Span<F>) -> F::Vector {
    let hit = scene.intersect(ray, &span, Quality::Textbook);
    F::Vector::select(hit.mask, hit.color, scene.background())
}

pub fn open_at_zero<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    seen_within(scene, ray, Span::new(F::from_bits(1), scene.t_max()))
}

pub fn open_at_t_max<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    let max = scene.t_max().step(F::from_f64(-1.0));
    seen_within(scene, ray, Span::new(F::default(), max))
}

pub fn no_t_max<F: Float>(scene: &Scene<F>, ray: &Ray<F>) -> F::Vector {
    seen_within(scene, ray, Span::new(F::default(), F::MAX))
}

/// Clause E.6: a byte is the truncated exact product 255 x; NaN and what is below 0 are byte 0.
pub fn check_e_6<F: Float>(byte: impl Fn(F) -> u8) -> Verdict {
    for (x, expected) in [
        (f64::NAN, 0),
        (f64::NEG_INFINITY, 0),
        (f64::INFINITY, 255),
        (-1.0, 0),
        (-0.0, 0),
        (0.999, 254),
        (0.5, 127),
        (1.0, 255),
    ] {
        let actual = byte(F::from_f64(x));
        holds!(
            "E.6",
            actual == expected,
            "{x} is byte {actual} instead of {expected}"
        );
    }
    // The float nearest to k/255 lies below it or not; the product with 255 of an f64 is exact in
    // 64 + 8 bits.
    for k in 0..=255u8 {
        let x = F::from_f64(f64::from(k) / 255.0);
        let scaled = 255 * (x.to_f64() * f64::from_bits((1023 + 60) << 52)) as u128;
        let expected = (scaled >> 60) as u8;
        let actual = byte(x);
        holds!(
            "E.6",
            actual == expected,
            "{k}/255 is byte {actual} instead of {expected}"
        );
    }
    Ok(())
}

pub fn kit_byte<F: Float>(x: F) -> u8 {
    Film::Clamp.byte(x).to_f64() as u8
}

pub fn rounded_to_nearest<F: Float>(x: F) -> u8 {
    (x.to_f64() * 255.0).round() as u8
}

pub fn nan_is_white<F: Float>(x: F) -> u8 {
    if x.to_f64().is_nan() {
        255
    } else {
        kit_byte(x)
    }
}

/// Clause E.7: the data of the scene.
pub fn check_e_7<F: Float>(scene: impl Fn() -> Scene<F>) -> Verdict {
    let (scene, v, number) = (scene(), vector::<F>, F::from_f64);
    holds!(
        "E.7",
        scene.background() == v([0.5; 3]),
        "the background is {:?}",
        scene.background()
    );
    holds!(
        "E.7",
        scene.t_max() == number(1000.0),
        "t_max is {}",
        scene.t_max()
    );
    let ([sphere], [plane], [light]) = (scene.spheres(), scene.planes(), scene.lights()) else {
        return Err("clause E.7: not one sphere, one plane and one light".into());
    };
    holds!(
        "E.7",
        sphere.shape.center() == v([0.0, 0.0, 3.0]),
        "{sphere:?}"
    );
    holds!("E.7", sphere.shape.radius() == number(1.0), "{sphere:?}");
    holds!("E.7", sphere.color() == v([0.0, 0.0, 1.0]), "{sphere:?}");
    holds!(
        "E.7",
        plane.shape.point() == v([0.0, -2.0, 0.0]),
        "{plane:?}"
    );
    holds!(
        "E.7",
        plane.shape.normal() == v([0.0, 1.0, 0.0]),
        "{plane:?}"
    );
    holds!("E.7", plane.color() == v([1.0, 0.0, 0.0]), "{plane:?}");
    holds!("E.7", light.position() == v([1.0, 10.0, 1.0]), "{light:?}");
    holds!("E.7", light.color() == v([1.0; 3]), "{light:?}");
    holds!("E.7", light.power() == number(100.0), "{light:?}");
    Ok(())
}

pub fn kit_scene<F: Float>() -> Scene<F> {
    lab::scene().expect("the lab's scene is valid")
}

pub fn black_background<F: Float>() -> Scene<F> {
    rebuilt(vector::<F>([0.0; 3]), F::from_f64(1000.0))
}

pub fn shorter_sight<F: Float>() -> Scene<F> {
    rebuilt(vector::<F>([0.5; 3]), F::from_f64(100.0))
}

fn rebuilt<F: Float>(background: F::Vector, t_max: F) -> Scene<F> {
    let lab = kit_scene::<F>();
    let (sphere, plane) = (lab.spheres()[0], lab.planes()[0]);
    Scene::new(background, t_max)
        .and_then(|scene| scene.with_sphere(sphere.shape, sphere.color()))
        .and_then(|scene| scene.with_plane(plane.shape, plane.color()))
        .expect("the scene is valid")
        .with_light(lab.lights()[0])
}

/// Clause E.8: the order of operations, and every rounding on its own.
pub fn check_e_8<F: Float>(dot: impl Fn(F::Vector, F::Vector) -> F) -> Verdict {
    let (one, small) = (1.0, F::EPSILON / 2.0);
    for (name, a, expected) in [
        ("(1 + u) + u", [one, small, small], one),
        ("(u + u) + 1", [small, small, one], one + F::EPSILON),
        ("(u + 1) + u", [small, one, small], one),
    ] {
        let actual = dot(vector::<F>(a), vector::<F>([1.0; 3]));
        let expected = F::from_f64(expected);
        let right = actual == expected;
        holds!("E.8", right, "{}", differs(name, &[], expected, actual));
    }
    // (1 + e)² - 1 - 2e is e²: rounded away, but not by a fused operation.
    let (long, square) = (1.0 + F::EPSILON, 1.0 + 2.0 * F::EPSILON);
    let actual = dot(
        vector::<F>([square, long, 0.0]),
        vector::<F>([-1.0, long, 0.0]),
    );
    holds!(
        "E.8",
        actual == F::default(),
        "a product was not rounded: {actual:e} ({})",
        F::NAME
    );
    Ok(())
}

pub fn kit_dot<F: Float>(a: F::Vector, b: F::Vector) -> F {
    a.dot(b)
}

pub fn from_the_right<F: Float>(a: F::Vector, b: F::Vector) -> F {
    a.x() * b.x() + (a.y() * b.y() + a.z() * b.z())
}

pub fn from_the_back<F: Float>(a: F::Vector, b: F::Vector) -> F {
    (a.z() * b.z() + a.y() * b.y()) + a.x() * b.x()
}

pub fn one_precision_up<F: Float>(a: F::Vector, b: F::Vector) -> F {
    use ombrage::{DoubleDouble, Scalar};
    let wide = |v: F::Vector| v.to_array().map(|c| DoubleDouble::from_f64(c.to_f64()));
    let (a, b) = (wide(a), wide(b));
    F::from_f64((a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).to_f64())
}
