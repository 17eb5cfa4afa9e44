//! Rays leaving surfaces, and intervals.

use crate::exact::{dot, exact_vector, minus};
use crate::property::{Sample, any_number, for_all, unit_roundoff, vector};
use dashu_ratio::RBig;
use ombrage::{Ray, Span, Vector};
use proptest::prelude::*;

fn points_and_normals<F: Sample>() -> impl Strategy<Value = (Ray<F>, F::Vector)> {
    let normal = vector::<F>(-12..3).prop_map(Vector::normalized);
    let normal = normal.prop_filter("a direction", |n| n.to_array()[0].is_finite());
    // Coordinates over 10^±8.
    (vector::<F>(-26..27), normal).prop_map(|(origin, normal)| {
        (
            Ray {
                origin,
                direction: -normal,
            },
            normal,
        )
    })
}

/// The origin rises along the normal: in its largest component, more than 0.57, by at least
/// 256 * 0.57 - 1 places of at least u |p|, or near zero by 256 u times the component.
pub fn offset_leaves_on_the_side_of_the_normal<F: Sample>() {
    for_all(points_and_normals::<F>(), |(ray, normal)| {
        let moved = ray.offset(normal);
        prop_assert_eq!(moved.direction, ray.direction);
        let step = minus(
            &exact_vector::<F>(moved.origin),
            &exact_vector::<F>(ray.origin),
        );
        let height = dot(&step, &exact_vector::<F>(normal));
        prop_assert!(height > RBig::ZERO, "height {:e}", height.to_f64().value());
        let u = unit_roundoff::<F>();
        let least = |i: usize| {
            let n = normal.to_array()[i].to_f64().abs();
            let p = ray.origin.to_array()[i].to_f64().abs();
            if p < 1.0 / 32.0 {
                255.0 * u * n * n
            } else {
                (256.0 * n - 1.0).max(0.0) * u * p * n
            }
        };
        // Near zero a coordinate up to 1/32 rounds its move by at most u / 32.
        let sure = 0.99 * (least(0) + least(1) + least(2)) - 3.0 * u / 32.0;
        prop_assert!(
            height.to_f64().value() >= sure,
            "height {height} below {sure:e}"
        );
        Ok(())
    });
}

/// At most 256 places, which are at most 2 u |p| each, or twice that past a power of two; near zero
/// 256 u, and a rounding.
pub fn offset_stays_small<F: Sample>() {
    for_all(points_and_normals::<F>(), |(ray, normal)| {
        let moved = ray.offset(normal).origin.to_array();
        let (from, normal) = (ray.origin.to_array(), normal.to_array());
        for i in 0..3 {
            let (p, n) = (from[i].to_f64(), normal[i].to_f64().abs());
            let step = moved[i].to_f64() - p;
            let u = unit_roundoff::<F>();
            let most = if p.abs() < 1.0 / 32.0 {
                256.0 * u * n + u / 32.0
            } else {
                1024.0 * u * n * p.abs()
            };
            prop_assert!(
                step.abs() <= most,
                "coordinate {i} moves by {step:e}, over {most:e}"
            );
            let against = step * normal[i].to_f64() < 0.0;
            prop_assert!(!against, "coordinate {i} moves against the normal");
        }
        Ok(())
    });
}

pub fn offset_along_the_opposite_normal_is_the_mirror_image<F: Sample>() {
    for_all(points_and_normals::<F>(), |(ray, normal)| {
        let mirrored: Ray<F> = Ray {
            origin: -ray.origin,
            direction: -ray.direction,
        };
        prop_assert_eq!(mirrored.offset(-normal).origin, -ray.offset(normal).origin);
        Ok(())
    });
}

pub fn interval_is_closed_and_holds_no_nan<F: Sample>() {
    for_all(
        [any_number::<F>(), any_number::<F>(), any_number::<F>()],
        |[a, b, t]| {
            let span = Span::new(a, b);
            let inside = a.to_f64() <= t.to_f64() && t.to_f64() <= b.to_f64();
            prop_assert_eq!(span.contains(t), inside && t.to_f64() <= F::MAX.to_f64());
            prop_assert_eq!(span.contains(a), a <= b && a <= F::MAX);
            prop_assert!(!span.contains(F::from_f64(f64::NAN)));
            prop_assert!(!span.contains(F::from_f64(f64::INFINITY)));
            Ok(())
        },
    );
}

pub fn step_goes_from_number_to_number<F: Sample>() {
    for_all((any_number::<F>(), -1000..1000i32), |(x, places)| {
        let far_from_the_ends = x.to_f64().abs() > 1e-30 && x.to_f64().abs() < 1e30;
        prop_assume!(far_from_the_ends);
        let stepped = x.step(F::from_f64(f64::from(places)));
        prop_assert_eq!(x.ulp_distance(stepped), u64::from(places.unsigned_abs()));
        prop_assert_eq!(stepped > x, places > 0);
        Ok(())
    });
}
