//! Light samples.

use crate::exact::{abs, dot, exact, exact_vector, minus};
use crate::property::{Sample, Verdict, for_all, is_unit, positive, unit_roundoff, vector};
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
/// 1: 3.5 for the distance. Radiance: 5 of the square, a division and a product make 7; the halves
/// of colour times power take 1 product more. The direction is off by 1 of the difference, 3.5 + 1
/// of the reciprocal and 1 of the product: 6.5.
fn is_within_its_bounds<F: Sample>(
    light: &PointLight<F>,
    point: F::Vector,
    quality: Quality,
) -> Verdict {
    let sample: LightSample<F> = light.sample(point, quality);
    let [position, exact_point] = [light.position(), point].map(exact_vector::<F>);
    let to_light = minus(&position, &exact_point);
    let square = dot(&to_light, &to_light);
    // d within 3.5 u of its truth has a square within 7 u; it may be too long for any number.
    let allowed = exact(1.01 * 7.0 * unit_roundoff::<F>()) * &square;
    let (distance, largest) = (sample.distance, exact(F::MAX));
    if distance.is_finite() {
        let off = abs(exact(distance) * exact(distance) - &square);
        prop_assert!(off <= allowed, "distance {distance:e}");
    } else {
        prop_assert!(
            &largest * &largest < &square + allowed,
            "distance {distance:e}"
        );
    }
    let roundings = if quality == Quality::Textbook {
        7.0
    } else {
        8.0
    };
    for (i, &c) in light.color().to_array().iter().enumerate() {
        let truth = exact(c) * exact(light.power()) / &square;
        let radiance = sample.radiance.to_array()[i];
        prop_assert!(
            radiance.is_finite() && within(radiance, &truth, roundings),
            "radiance {radiance:e} of channel {i}"
        );
        // x = v / d has x² d² = v², with twice the roundings.
        let x = sample.direction.to_array()[i];
        prop_assert!(x.is_finite(), "component {i} of the direction");
        let x = exact(x);
        let truth = &to_light[i] * &to_light[i];
        let off = abs(&x * &x * &square - &truth);
        let allowed = exact(1.01 * 13.0 * unit_roundoff::<F>()) * &truth;
        prop_assert!(off <= allowed, "component {i} of the direction");
        let turned = &x * &to_light[i] < RBig::ZERO;
        prop_assert!(!turned, "component {i} of the direction points away");
    }
    prop_assert_eq!(sample.pdf, F::from_f64(1.0));
    Ok(())
}

pub fn attributes_are_within_their_bounds<F: Sample>() {
    for_all((lights::<F>(), vector::<F>(-6..6)), |(light, point)| {
        prop_assume!(light.position() != point);
        for quality in Quality::ALL {
            is_within_its_bounds(&light, point, quality)?;
        }
        Ok(())
    });
}

/// A light and a point anywhere, often so far apart that even their difference overflows, with a
/// radiance in the range of the float: its exponent is drawn, and that of the colour follows.
fn anywhere<F: Sample>() -> impl Strategy<Value = (PointLight<F>, F::Vector)> {
    let end = (F::MAX.to_f64() / 2.0).log2().round() as i32;
    let apart = prop_oneof![2 - end..end, end - 2..end];
    let parts = (apart, -end / 2..end, 2 - end..end - 4);
    let parts = parts.prop_filter_map("a colour", move |(apart, power, radiance)| {
        let color = radiance + 2 * apart - power;
        (2 - end..end)
            .contains(&color)
            .then_some((apart, color, power))
    });
    parts.prop_flat_map(|(apart, color, power)| {
        let color = vector::<F>(color..color + 1).prop_map(Vector::abs);
        let place = vector::<F>(apart..apart + 2);
        let parts = (place.clone(), color, positive::<F>(power..power + 1), place);
        parts.prop_filter_map("a light", |(at, color, power, point)| {
            Some((PointLight::new(at, color, power).ok()?, point))
        })
    })
}

/// Scaling by powers of two rounds nothing: where the radiance is in the range of the float, it is as
/// right as elsewhere, though the square of the distance or even the distance is not.
pub fn what_is_in_range_is_right_whatever_lies_between<F: Sample>() {
    for_all(anywhere::<F>(), |(light, point)| {
        let [position, exact_point] = [light.position(), point].map(exact_vector::<F>);
        let to_light = minus(&position, &exact_point);
        let square = dot(&to_light, &to_light);
        prop_assume!(square > RBig::ZERO);
        let [smallest, largest] = [exact(F::MIN_POSITIVE), exact(F::MAX)];
        let mut radiance = light
            .color()
            .to_array()
            .map(|c| exact(c) * exact(light.power()) / &square)
            .into_iter();
        prop_assume!(radiance.all(|x| x == RBig::ZERO || (&smallest..&largest).contains(&&x)));
        is_within_its_bounds(&light, point, Quality::Stable)?;
        is_within_its_bounds(&light, point, Quality::Wide)
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
