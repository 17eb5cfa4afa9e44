//! Clauses E.1 and E.2: primary rays.

use super::check::{Verdict, holds, vector};
use ombrage::{Chain, Float, LabChain, PerspectiveCamera, Ray, Vector, View};

/// Clause E.1: where on the viewport the ray of a column or row goes.
pub fn check_e_1<F: Float>(position: impl Fn(u32, u32) -> F) -> Verdict {
    for (index, count, expected) in [
        (0, 600, 0.0),
        (599, 600, 1.0),
        (300, 601, 0.5),
        (1, 400, 1.0 / 399.0),
        (0, 1, 0.5),
    ] {
        let actual = position(index, count);
        let right = actual == F::from_f64(expected);
        holds!(
            "E.1",
            right,
            "{index} of {count} is at {actual} instead of {expected}"
        );
    }
    Ok(())
}

pub fn kit_position<F: Float>(index: u32, count: u32) -> F {
    LabChain::coordinate(index, count)
}

pub fn pixel_centres<F: Float>(index: u32, count: u32) -> F {
    F::from_f64((f64::from(index) + 0.5) / f64::from(count))
}

/// Clause E.2: the ray through a point of the viewport, for a view from (1, 2, 3), 90
/// degrees high, with the aspect 2.
pub fn check_e_2<F: Float>(through: impl Fn(&View<F>, f64, f64) -> Ray<F>) -> Verdict {
    let root = |x: f64| 1.0 / x.sqrt();
    let cases = [
        ("middle", [0.0, 0.0, 1.0], 0.5, 0.5, [0.0, 0.0, 1.0]),
        (
            "right is -x of the world",
            [0.0, 0.0, 1.0],
            1.0,
            0.5,
            [-2.0 * root(5.0), 0.0, root(5.0)],
        ),
        (
            "left",
            [0.0, 0.0, 1.0],
            0.0,
            0.5,
            [2.0 * root(5.0), 0.0, root(5.0)],
        ),
        (
            "the upper edge",
            [0.0, 0.0, 1.0],
            0.5,
            0.0,
            [0.0, root(2.0), root(2.0)],
        ),
        (
            "the lower edge",
            [0.0, 0.0, 1.0],
            0.5,
            1.0,
            [0.0, -root(2.0), root(2.0)],
        ),
        (
            "along x",
            [81.0, 0.0, 0.0],
            1.0,
            0.5,
            [root(5.0), 0.0, 2.0 * root(5.0)],
        ),
    ];
    for (name, toward, sx, sy, expected) in cases {
        let view = View {
            position: vector::<F>([1.0, 2.0, 3.0]),
            look_at: vector::<F>([1.0, 2.0, 3.0]) + vector::<F>(toward),
            up: vector::<F>([0.0, 1.0, 0.0]),
            fov: F::from_f64(90.0),
        };
        let ray = through(&view, sx, sy);
        let right = ray.origin == view.position;
        holds!("E.2", right, "{name}: the ray starts at {:?}", ray.origin);
        // The tangent of 45 degrees, the corner and the normalisation: at most 16 roundings of 1.
        let off = (ray.direction - vector::<F>(expected))
            .to_array()
            .map(|c| c.to_f64().abs());
        let right = off.into_iter().all(|c| c <= 16.0 * F::EPSILON);
        holds!(
            "E.2",
            right,
            "{name}: the direction is {:?} instead of {expected:?}",
            ray.direction
        );
    }
    Ok(())
}

pub fn kit_camera<F: Float>(view: &View<F>, sx: f64, sy: f64) -> Ray<F> {
    let camera = PerspectiveCamera::new(view, F::from_f64(2.0)).expect("the view is valid");
    camera.ray(F::from_f64(sx), F::from_f64(sy))
}

pub fn mirrored<F: Float>(view: &View<F>, sx: f64, sy: f64) -> Ray<F> {
    kit_camera(view, 1.0 - sx, sy)
}

pub fn upside_down<F: Float>(view: &View<F>, sx: f64, sy: f64) -> Ray<F> {
    kit_camera(view, sx, 1.0 - sy)
}

pub fn field_of_view_across<F: Float>(view: &View<F>, sx: f64, sy: f64) -> Ray<F> {
    let fov = F::from_f64(53.130_102_354_155_98);
    kit_camera(&View { fov, ..*view }, sx, sy)
}

pub fn direction_of_any_length<F: Float>(view: &View<F>, sx: f64, sy: f64) -> Ray<F> {
    let ray = kit_camera(view, sx, sy);
    Ray {
        direction: ray.direction * F::from_f64(2.0),
        ..ray
    }
}
