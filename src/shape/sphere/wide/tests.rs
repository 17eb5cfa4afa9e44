//! The filter of the sphere, and its exact way.

use super::super::super::wide::tests::{
    crossed, everywhere, for_all, from_next_to, is_right, near_one, plus, scaled, vector,
};
use super::Question;
use crate::real::Scalar;
use crate::shape::wide::trust;
use proptest::prelude::*;

/// Where a line passes a sphere: its parts of the radius beside the center, and of half the chord
/// before the middle of it.
type Pass = (f64, f64);

/// The question of a sphere of this radius and a direction of this length.
fn question<S: Scalar>(
    [along, across]: [[f64; 3]; 2],
    (beside, before): Pass,
    (radius, length): (f64, f64),
) -> Question<S::Wide> {
    let center = [0.25, -0.375, 0.5];
    let chord = radius * (1.0 - beside * beside).abs().sqrt();
    let beside = plus(center, across, radius * beside);
    Question {
        origin: vector::<S>(plus(beside, along, -chord * before)),
        direction: vector::<S>(scaled(along, length)),
        center: vector::<S>(center),
        radius: S::from_f64(radius).widen(),
        span: everywhere(),
    }
}

/// Small spheres far away, near tangents, origins near the surface, ends near a root.
fn never_wrong<S: Scalar>() {
    let pass = (near_one(50), prop_oneof![near_one(50), -3.0..3.0_f64]);
    let sizes = ((-20.0..0.0_f64).prop_map(f64::exp2), 1.0..2.0_f64);
    let far = prop_oneof![Just(1.0), (0.0..16.0_f64).prop_map(f64::exp2)];
    let inputs = (crossed(), pass, sizes, far, near_one(110));
    for_all(inputs, |(lines, (beside, before), sizes, far, end)| {
        let before = (before * far).clamp(-1.0 / sizes.0, 1.0 / sizes.0);
        let asked = question::<S>(lines, (beside, before), sizes);
        let trusted = trust::<S>();
        prop_assert!(is_right::<S>(asked.filtered(trusted), asked.exact()));
        let span = from_next_to(asked.exact(), end);
        let asked = Question { span, ..asked };
        prop_assert!(is_right::<S>(asked.filtered(trusted), asked.exact()));
        Ok(())
    });
}

/// Lines through the zero of coordinates, next to which a small sphere nearly touches them: seen from
/// the origin, rounding moves the sphere by much of its size.
fn never_wrong_next_to_zero<S: Scalar>() {
    let inputs = (crossed(), 1..115, 0.0..2.0_f64, near_one(50));
    for_all(inputs, |([out, across], bits, along, beside)| {
        let size = 0.5_f64.powi(bits);
        let center = scaled(plus(across, out, along), size);
        let asked = Question {
            origin: vector::<S>(out),
            direction: vector::<S>(scaled(out, -1.0)),
            center: vector::<S>(center),
            radius: S::from_f64(size * beside).widen(),
            span: everywhere(),
        };
        prop_assert!(is_right::<S>(asked.filtered(trust::<S>()), asked.exact()));
        Ok(())
    });
}

/// Lines that pass a sphere well inside or outside leave no doubt, from wherever they start but on it.
fn decides<S: Scalar>() {
    let beside = prop_oneof![0.0..0.9_f64, 1.1..3.0_f64];
    let before = prop_oneof![-4.0..-1.1_f64, -0.9..0.9_f64, 1.1..4.0_f64];
    let sizes = ((-13.0..-1.0_f64).prop_map(f64::exp2), 1.0..2.0_f64);
    let inputs = (crossed(), (beside, before), sizes, near_one(6));
    for_all(inputs, |(lines, (beside, before), sizes, end)| {
        let asked = question::<S>(lines, (beside, before), sizes);
        let trusted = trust::<S>();
        let found = asked.filtered(trusted);
        prop_assert_eq!(found.map(|t| t.is_some()), Some(beside < 1.0));
        prop_assert!(is_right::<S>(found, asked.exact()));
        let span = from_next_to(asked.exact(), end);
        let asked = Question { span, ..asked };
        prop_assert!(asked.filtered(trusted).is_some());
        prop_assert!(is_right::<S>(asked.filtered(trusted), asked.exact()));
        Ok(())
    });
}

#[test]
fn the_filter_is_never_wrong() {
    never_wrong::<f32>();
    never_wrong::<f64>();
    never_wrong_next_to_zero::<f32>();
    never_wrong_next_to_zero::<f64>();
}

#[test]
fn what_is_far_from_tangency_and_from_the_surface_leaves_no_doubt() {
    decides::<f32>();
    decides::<f64>();
}
