//! Primary rays.

use crate::property::{Sample, for_all, is_unit, unit_roundoff, vector};
use ombrage::{PerspectiveCamera, Ray, Vector, View, lab};
use proptest::prelude::*;

fn cameras<F: Sample>() -> impl Strategy<Value = (View<F>, PerspectiveCamera<F>)> {
    let view = (
        vector::<F>(-4..4),
        vector::<F>(-4..4),
        vector::<F>(-2..2),
        1.0..170.0f64,
    );
    (view, 0.1..10.0f64).prop_filter_map("a camera", |((position, look_at, up, fov), aspect)| {
        let view = View {
            position,
            look_at,
            up,
            fov: F::from_f64(fov),
        };
        let camera = PerspectiveCamera::new(&view, F::from_f64(aspect)).ok()?;
        Some((view, camera))
    })
}

pub fn directions_have_unit_length<F: Sample>() {
    for_all(
        (cameras::<F>(), 0.0..1.0, 0.0..1.0),
        |((view, camera), sx, sy)| {
            let ray: Ray<F> = camera.ray(F::from_f64(sx), F::from_f64(sy));
            prop_assert_eq!(ray.origin, view.position);
            is_unit::<F>(ray.direction)
        },
    );
}

/// The ray through the middle looks at `look_at`. The viewport's corner is a sum of halves of its
/// edges and the way forward, of which the edges cancel again: up to 16 roundings of the viewport's
/// size.
pub fn the_middle_ray_looks_at_its_aim<F: Sample>() {
    for_all(cameras::<F>(), |(view, camera)| {
        let half = F::from_f64(0.5);
        let ray: Ray<F> = camera.ray(half, half);
        let corner: Ray<F> = camera.ray(F::default(), F::default());
        let toward = (view.look_at - view.position).normalized();
        // 1 / cos of the angle to the corner is the corner's distance.
        let size = 1.0 / toward.dot(corner.direction).to_f64();
        let off = (ray.direction - toward)
            .to_array()
            .map(|c| c.to_f64().abs());
        let allowed = 16.0 * unit_roundoff::<F>() * size.max(1.0);
        prop_assert!(
            off.into_iter().all(|c| c <= allowed),
            "off by {off:?}, {allowed:e} allowed"
        );
        Ok(())
    });
}

/// The angle between the rays through the middle of the upper and the lower edge is the field of
/// view.
pub fn the_field_of_view_is_vertical<F: Sample>() {
    for_all(1.0..170.0f64, |fov| {
        let view = View {
            fov: F::from_f64(fov),
            ..lab::view::<F>()
        };
        let camera = PerspectiveCamera::new(&view, F::from_f64(1.5));
        let camera = camera.map_err(|error| TestCaseError::fail(error.to_string()))?;
        let through = |sx: f64, sy: f64| -> Ray<F> { camera.ray(F::from_f64(sx), F::from_f64(sy)) };
        let slope = |ray: Ray<F>| ray.direction.y().to_f64() / ray.direction.z().to_f64();
        let tangent = (fov.to_radians() / 2.0).tan();
        // The tangent amplifies the rounding of the angle by angle / (sin cos) < 32 up to 170
        // degrees.
        let allowed = tangent * 64.0 * unit_roundoff::<F>();
        let (upper, lower) = (slope(through(0.5, 0.0)), slope(through(0.5, 1.0)));
        prop_assert!(
            (upper - tangent).abs() <= allowed,
            "upper {upper}, tangent {tangent}"
        );
        prop_assert!(
            (lower + tangent).abs() <= allowed,
            "lower {lower}, tangent {tangent}"
        );
        Ok(())
    });
}

pub fn a_view_is_cast_number_by_number<F: Sample>() {
    let vector = glam::DVec3::from;
    let view = View {
        position: vector([0.1, 0.2, 0.3]),
        look_at: vector([1.1, 1.2, 1.3]),
        up: vector([0.1, 0.9, 0.0]),
        fov: 60.1,
    };
    let cast = view.cast::<F>();
    let rounded = |v: glam::DVec3| F::Vector::constant((), v.to_array());
    assert_eq!(cast.position, rounded(view.position));
    assert_eq!(cast.look_at, rounded(view.look_at));
    assert_eq!(cast.up, rounded(view.up));
    assert_eq!(cast.fov, F::from_f64(view.fov));
}
