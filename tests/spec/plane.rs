//! Clauses 1.1 to 1.3: the plane.

use super::check::{Verdict, agrees, holds, ray, same_t, shows, span, vector};
use ombrage::{
    Figure, Film, Float, HitRecord, Integrator, LabChain, Mask, PerspectiveCamera, Picture, Plane,
    Quality, Ray, Scene, Shape, Size, Span, Sphere, Vector, lab, render,
};

type Three = [f64; 3];

/// Clause 1.1: where a ray meets the plane through `q` with the normal `n`.
pub fn check_1_1<F: Float>(t: impl Fn(Three, Three, &Ray<F>, &Span<F>) -> Option<F>) -> Verdict {
    const Q: Three = [0.0, -2.0, 0.0];
    const UP: Three = [0.0, 1.0, 0.0];
    const O: Three = [0.0; 3];
    const DOWN: Three = [0.0, -1.0, 0.0];
    const ALL: [f64; 2] = [0.0, 1000.0];
    let inf = f64::INFINITY;
    let cases = [
        ("from above", Q, UP, O, DOWN, ALL, Some(2.0)),
        (
            "a normal of length 3",
            Q,
            [0.0, 3.0, 0.0],
            O,
            DOWN,
            ALL,
            Some(2.0),
        ),
        (
            "a normal of length 2^-20",
            Q,
            [0.0, f64::from_bits((1023 - 20) << 52), 0.0],
            O,
            DOWN,
            ALL,
            Some(2.0),
        ),
        ("from behind the normal", Q, DOWN, O, DOWN, ALL, Some(2.0)),
        ("from below", Q, UP, [0.0, -5.0, 0.0], UP, ALL, Some(3.0)),
        (
            "a direction of length 4",
            Q,
            UP,
            O,
            [0.0, -4.0, 0.0],
            ALL,
            Some(0.5),
        ),
        (
            "oblique",
            [1.0, 2.0, 3.0],
            [1.0, 2.0, 2.0],
            O,
            [1.0, 0.0, 0.0],
            ALL,
            Some(11.0),
        ),
        ("away from it", Q, UP, O, UP, ALL, None),
        ("parallel, above", Q, UP, O, [1.0, 0.0, 0.0], ALL, None),
        (
            "parallel, above, no end",
            Q,
            UP,
            O,
            [1.0, 0.0, 0.0],
            [0.0, inf],
            None,
        ),
        (
            "parallel, within",
            Q,
            UP,
            Q,
            [1.0, 0.0, 0.0],
            [0.0, inf],
            None,
        ),
        (
            "the interval starts there",
            Q,
            UP,
            O,
            DOWN,
            [2.0, 10.0],
            Some(2.0),
        ),
        (
            "the interval ends there",
            Q,
            UP,
            O,
            DOWN,
            [0.0, 2.0],
            Some(2.0),
        ),
        ("starts on the plane", Q, UP, Q, DOWN, ALL, Some(0.0)),
        ("before the interval", Q, UP, O, DOWN, [2.5, 10.0], None),
        ("after the interval", Q, UP, O, DOWN, [0.0, 1.5], None),
    ];
    for (name, q, n, o, d, interval, expected) in cases {
        let ray = ray(o, d);
        let actual = t(q, n, &ray, &span(interval));
        agrees!("1.1", same_t(name, &ray, expected.map(F::from_f64), actual));
    }
    Ok(())
}

pub fn kit_t<F: Float>(q: Three, n: Three, ray: &Ray<F>, span: &Span<F>) -> Option<F> {
    let plane = Plane::new(vector::<F>(q), vector::<F>(n)).ok()?;
    let hit = plane.intersect(ray, span, Quality::Textbook);
    hit.mask.then_some(hit.t)
}

pub fn culled_from_behind<F: Float>(q: Three, n: Three, ray: &Ray<F>, span: &Span<F>) -> Option<F> {
    let against = ray.direction.dot(vector::<F>(n)).to_f64() < 0.0;
    kit_t(q, n, ray, span).filter(|_| against)
}

pub fn not_divided<F: Float>(q: Three, n: Three, ray: &Ray<F>, span: &Span<F>) -> Option<F> {
    let n = vector::<F>(n).normalized();
    let t = (vector::<F>(q) - ray.origin).dot(n).abs();
    span.contains(t).then_some(t)
}

pub fn parallel_is_a_hit<F: Float>(q: Three, n: Three, ray: &Ray<F>, span: &Span<F>) -> Option<F> {
    let parallel = ray.direction.dot(vector::<F>(n)) == F::default();
    kit_t(q, n, ray, span).or(parallel.then_some(span.min))
}

pub fn open_at_its_start<F: Float>(q: Three, n: Three, ray: &Ray<F>, span: &Span<F>) -> Option<F> {
    kit_t(q, n, ray, span).filter(|t| *t > span.min)
}

/// Clause 1.2: the hit record of a scene.
pub fn check_1_2<F: Float>(
    intersect: impl Fn(&Scene<F>, &Ray<F>, &Span<F>) -> HitRecord<F>,
) -> Verdict {
    let vector = vector::<F>;
    let number = F::from_f64;
    let build = || {
        Scene::new(vector([0.0; 3]), number(1000.0))?
            .with_sphere(
                Sphere::new(vector([0.0, 0.0, 8.0]), number(2.0))?,
                vector([0.0, 0.0, 1.0]),
            )?
            .with_plane(
                Plane::new(vector([0.0, -2.0, 0.0]), vector([0.0, 3.0, 0.0]))?,
                vector([1.0, 0.0, 0.0]),
            )?
            .with_plane(
                Plane::new(vector([0.0, 0.0, 20.0]), vector([0.0, 0.0, 1.0]))?,
                vector([0.0, 1.0, 0.0]),
            )
    };
    let scene = build().map_err(|error| error.to_string())?;
    // Origin, direction; distance, point, normal, number, colour.
    let cases = [
        (
            "a plane from above",
            [0.0; 3],
            [0.0, -1.0, 0.0],
            2.0,
            [0.0, -2.0, 0.0],
            [0.0, 1.0, 0.0],
            1,
            [1.0, 0.0, 0.0],
        ),
        (
            "a plane from below",
            [0.0, -6.0, 0.0],
            [0.0, 1.0, 0.0],
            4.0,
            [0.0, -2.0, 0.0],
            [0.0, -1.0, 0.0],
            1,
            [1.0, 0.0, 0.0],
        ),
        (
            "a sphere before a plane",
            [0.0; 3],
            [0.0, 0.0, 1.0],
            6.0,
            [0.0, 0.0, 6.0],
            [0.0, 0.0, -1.0],
            0,
            [0.0, 0.0, 1.0],
        ),
        (
            "a sphere from inside",
            [0.0, 0.0, 8.0],
            [0.0, 0.0, 1.0],
            2.0,
            [0.0, 0.0, 10.0],
            [0.0, 0.0, -1.0],
            0,
            [0.0, 0.0, 1.0],
        ),
        (
            "a plane before a sphere",
            [0.0, 0.0, 30.0],
            [0.0, 0.0, -1.0],
            10.0,
            [0.0, 0.0, 20.0],
            [0.0, 0.0, 1.0],
            2,
            [0.0, 1.0, 0.0],
        ),
    ];
    for (name, origin, direction, distance, point, normal, object, color) in cases {
        let hit = intersect(&scene, &ray(origin, direction), &span([0.0, 1000.0]));
        holds!("1.2", hit.mask, "{name}: no hit");
        holds!(
            "1.2",
            hit.distance == number(distance),
            "{name}: the distance is {:?}",
            hit.distance
        );
        holds!(
            "1.2",
            hit.point == vector(point),
            "{name}: the point is {:?}",
            hit.point
        );
        holds!(
            "1.2",
            hit.normal == vector(normal),
            "{name}: the normal is {:?}",
            hit.normal
        );
        holds!(
            "1.2",
            hit.object == number(f64::from(object)),
            "{name}: the object is {:?}",
            hit.object
        );
        holds!(
            "1.2",
            hit.color == vector(color),
            "{name}: the colour is {:?}",
            hit.color
        );
    }
    let miss = intersect(
        &scene,
        &ray([0.0; 3], [0.0, 1.0, 0.0]),
        &span([0.0, 1000.0]),
    );
    holds!("1.2", !miss.mask.any(), "a miss is a hit");
    Ok(())
}

pub fn kit_intersect<F: Float>(scene: &Scene<F>, ray: &Ray<F>, span: &Span<F>) -> HitRecord<F> {
    scene.intersect(ray, span, Quality::Textbook)
}

pub fn normal_as_stored<F: Float>(scene: &Scene<F>, ray: &Ray<F>, span: &Span<F>) -> HitRecord<F> {
    let mut hit = scene.intersect(ray, span, Quality::Textbook);
    if hit.object == F::from_f64(1.0) {
        hit.normal = vector::<F>([0.0, 1.0, 0.0]);
    }
    hit
}

pub fn normal_of_any_length<F: Float>(
    scene: &Scene<F>,
    ray: &Ray<F>,
    span: &Span<F>,
) -> HitRecord<F> {
    let hit = scene.intersect(ray, span, Quality::Textbook);
    HitRecord {
        normal: hit.normal * F::from_f64(3.0),
        ..hit
    }
}

pub fn farthest_hit<F: Float>(scene: &Scene<F>, ray: &Ray<F>, span: &Span<F>) -> HitRecord<F> {
    let hit = scene.intersect(ray, span, Quality::Textbook);
    let beyond = Span::new(hit.distance + F::from_f64(1.0), span.max);
    if hit.mask && scene.intersect_any(ray, &beyond, Quality::Textbook) {
        farthest_hit(scene, ray, &beyond)
    } else {
        hit
    }
}

/// Clause 1.3: Figure 1.
pub fn check_1_3<F: Float>(figure_1: impl Fn() -> Picture) -> Verdict {
    let right = shows(&figure_1(), |seen| seen.view_cosine, |level| level as u8);
    holds!("1.3", right.is_ok(), "Figure 1 in {}: {right:?}", F::NAME);
    Ok(())
}

pub fn kit_figure_1<F: Float>() -> Picture {
    let figure = Figure::named("1").expect("Figure 1 exists");
    figure
        .draw::<F>(Size::LAB)
        .expect("the lab's scene is valid")
}

fn figure_1_of<F: Float>(plane: Three, color: Three) -> Picture {
    let valid = "the scene is valid";
    let lab = lab::scene::<F>().expect(valid);
    let plane = Plane::new(vector::<F>(plane), vector::<F>([0.0, 1.0, 0.0])).expect(valid);
    let sphere = lab.spheres()[0];
    let scene = Scene::new(lab.background(), lab.t_max())
        .and_then(|scene| scene.with_sphere(sphere.shape, sphere.color()))
        .and_then(|scene| scene.with_plane(plane, vector::<F>(color)))
        .expect(valid);
    let camera = PerspectiveCamera::new(&lab::view::<F>(), F::from_f64(1.5)).expect(valid);
    let integrator = Integrator::RayCast(Quality::Textbook);
    let chain = LabChain {
        scene: &scene,
        camera: &camera,
        integrator,
    };
    render(&chain, Size::LAB, Film::Clamp)
}

/// So low that row 201 no longer reaches it; its height shows nowhere else in Figure 1.
pub fn plane_too_low<F: Float>() -> Picture {
    figure_1_of::<F>([0.0, -5.0, 0.0], [1.0, 0.0, 0.0])
}

pub fn plane_not_red<F: Float>() -> Picture {
    figure_1_of::<F>([0.0, -2.0, 0.0], [1.0, 1.0, 0.0])
}
