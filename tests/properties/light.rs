//! Light samples.

use crate::exact::{abs, dot, exact, exact_vector, minus};
use crate::property::{Sample, for_all, is_unit, positive, unit_roundoff, vector};
use dashu_ratio::RBig;
use ombrage::{
    DirectLighting, Integrator, LightSample, Plane, PointLight, Quality, Ray, Scene, ShadowQuery,
    Vector,
};
use proptest::prelude::*;

fn lights<F: Sample>() -> impl Strategy<Value = PointLight<F>> {
    let channel = positive::<F>(-8..2);
    let color = [channel.clone(), channel.clone(), channel];
    let color = color.prop_map(|[r, g, b]| F::Vector::new(r, g, b));
    let parts = (vector::<F>(-6..6), color, positive::<F>(-8..8));
    parts.prop_filter_map("a light", |(at, color, power)| {
        PointLight::new(at, color, power).ok()
    })
}

/// `|actual - truth| <= roundings u |truth|`, and 1 % more for the products of errors.
fn within<F: Sample>(actual: F, truth: &RBig, roundings: f64) -> bool {
    let allowed = exact(1.01 * roundings * unit_roundoff::<F>());
    abs(exact(actual) - truth) <= allowed * abs(truth.clone())
}

/// The difference takes 1 rounding, and its square length 2 * 1 + 3; the root halves that and adds
/// 1: 3.5 for the distance. Radiance: 5 of the square, a division and a product make 7. The
/// direction is off by 1 of the difference, 3.5 + 1 of the reciprocal and 1 of the product: 6.5.
pub fn attributes_are_within_their_bounds<F: Sample>() {
    for_all((lights::<F>(), vector::<F>(-6..6)), |(light, point)| {
        prop_assume!(light.position() != point);
        let sample: LightSample<F> = light.sample(point, Quality::Textbook);
        let to_light = minus(
            &exact_vector::<F>(light.position()),
            &exact_vector::<F>(point),
        );
        let square = dot(&to_light, &to_light);
        // d within 3.5 u of its truth has a square within 7 u.
        let distance = exact(sample.distance);
        let off = abs(&distance * &distance - &square);
        prop_assert!(
            off <= exact(1.01 * 7.0 * unit_roundoff::<F>()) * &square,
            "distance"
        );
        for (i, &c) in light.color().to_array().iter().enumerate() {
            let truth = exact(c) * exact(light.power()) / &square;
            let radiance = sample.radiance.to_array()[i];
            prop_assert!(
                within(radiance, &truth, 7.0),
                "radiance {radiance:e} of channel {i}"
            );
            // x = v / d has x² d² = v², with twice the roundings.
            let x = exact(sample.direction.to_array()[i]);
            let truth = &to_light[i] * &to_light[i];
            let off = abs(&x * &x * &square - &truth);
            let allowed = exact(1.01 * 13.0 * unit_roundoff::<F>()) * &truth;
            prop_assert!(off <= allowed, "component {i} of the direction");
            let turned = &x * &to_light[i] < RBig::ZERO;
            prop_assert!(!turned, "component {i} of the direction points away");
        }
        prop_assert_eq!(sample.pdf, F::from_f64(1.0));
        Ok(())
    });
}

pub fn direction_has_unit_length<F: Sample>() {
    for_all((lights::<F>(), vector::<F>(-6..6)), |(light, point)| {
        prop_assume!(light.position() != point);
        is_unit::<F>(light.sample::<F>(point, Quality::Textbook).direction)
    });
}

/// Exactly: 2^k times the distance is 4^-k times the radiance, in the same direction.
pub fn radiance_falls_with_the_square_of_the_distance<F: Sample>() {
    for_all(
        (lights::<F>(), vector::<F>(-6..6), 1..6),
        |(light, point, k)| {
            let origin = F::Vector::constant((), [0.0; 3]);
            prop_assume!(point != origin);
            let light = PointLight::new(origin, light.color(), light.power());
            let light = light.map_err(|error| TestCaseError::fail(error.to_string()))?;
            let (factor, near) = (
                F::from_f64(f64::from(k).exp2()),
                light.sample::<F>(point, Quality::Textbook),
            );
            let far: LightSample<F> = light.sample(point * factor, Quality::Textbook);
            prop_assert_eq!(far.direction, near.direction);
            prop_assert_eq!(far.distance, near.distance * factor);
            prop_assert_eq!(far.radiance * (factor * factor), near.radiance);
            Ok(())
        },
    );
}

/// Exactly: 2^k times the power is 2^k times the radiance.
pub fn radiance_grows_with_the_power<F: Sample>() {
    for_all(
        (lights::<F>(), vector::<F>(-6..6), -6..6),
        |(light, point, k)| {
            prop_assume!(light.position() != point);
            let factor = F::from_f64(f64::from(k).exp2());
            let bright = PointLight::new(light.position(), light.color(), light.power() * factor);
            let bright = bright.map_err(|error| TestCaseError::fail(error.to_string()))?;
            let radiance = bright.sample::<F>(point, Quality::Textbook).radiance;
            prop_assert_eq!(
                radiance,
                light.sample::<F>(point, Quality::Textbook).radiance * factor
            );
            Ok(())
        },
    );
}

/// A light exactly at the point it shines on contributes nothing.
pub fn a_light_at_the_point_contributes_nothing<F: Sample>() {
    for_all((lights::<F>(), vector::<F>(-6..6)), |(light, point)| {
        let valid = |error: ombrage::Invalid| TestCaseError::fail(error.to_string());
        let up = F::Vector::constant((), [0.0, 1.0, 0.0]);
        let light = PointLight::new(point, light.color(), light.power()).map_err(valid)?;
        let scene = Plane::new(point, up)
            .and_then(|plane| Scene::new(up, F::MAX)?.with_plane(plane, up))
            .map_err(valid)?
            .with_light(light);
        let ray: Ray<F> = Ray {
            origin: point,
            direction: -up,
        };
        let direct = DirectLighting {
            quality: Quality::Textbook,
            shadow: None,
            query: ShadowQuery::Any,
        };
        let radiance = Integrator::DirectLighting(direct).radiance(&scene, &ray);
        prop_assert_eq!(radiance, up * F::default());
        Ok(())
    });
}
