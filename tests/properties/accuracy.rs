//! Numbers about numbers: how many digits are right, whether a length is 1.

use crate::exact::exact;
use crate::property::{Sample, for_all, number, vector};
use ombrage::conformance::Agreement;
use ombrage::{DoubleDouble, Vector};
use proptest::prelude::*;

/// A number that is off by 2^-k of itself agrees in k bits, and is off by that many places.
pub fn agreement_counts_bits_and_places<F: Sample>() {
    let kinds = (1.0..2.0f64, -60..60i32, 1..F::PRECISION, any::<bool>());
    for_all(kinds, |(mantissa, exponent, bits, negative)| {
        let sign = if negative { -1.0 } else { 1.0 };
        let value = F::from_f64(sign * mantissa * f64::from(exponent).exp2());
        let off = DoubleDouble::from_f64(1.0) + DoubleDouble::from_f64((-f64::from(bits)).exp2());
        let found = Agreement::of(value, value.to_double_double() * off);
        prop_assert!(found.bits.abs_diff(bits) <= 1, "{found:?} for {bits}");
        let places = (f64::from(F::PRECISION - 1) - f64::from(bits)).exp2();
        let ratio = found.ulps / places;
        prop_assert!((0.49..2.01).contains(&ratio), "{found:?} for {places}");
        Ok(())
    });
}

/// Where nothing agrees, everything does, or a place is that of the smallest number.
pub fn agreement_at_its_ends<F: Sample>() {
    let one = DoubleDouble::from_f64(1.0);
    let same = Agreement::of(F::from_f64(1.0), one);
    assert_eq!((same.ulps, same.bits), (0.0, F::PRECISION));
    let opposite = Agreement::of(F::from_f64(-1.0), one);
    assert_eq!((opposite.ulps, opposite.bits), (2.0 / F::EPSILON, 0));
    let zero = DoubleDouble::from_f64(0.0);
    assert_eq!(Agreement::of(F::from_f64(1.0), zero).bits, 0);
    let nothing = Agreement::of(F::from_f64(0.0), zero);
    assert_eq!((nothing.ulps, nothing.bits), (0.0, F::PRECISION));
    let smallest = F::MIN_POSITIVE * F::EPSILON;
    let third = F::from_f64(3.0 * smallest);
    let first = DoubleDouble::from_f64(smallest);
    assert_eq!(Agreement::of(third, first).ulps, 2.0);
}

/// A normalised vector is a unit, and one a hundred-thousandth longer or shorter is none.
pub fn units_are_told_from_others<F: Sample>() {
    let directions = vector::<F>(-12..13).prop_map(Vector::normalized);
    let finite = |v: &F::Vector| v.to_array()[0].is_finite();
    for_all(directions.prop_filter("a direction", finite), |unit| {
        prop_assert!(unit.is_unit());
        for factor in [0.0, 0.5, 0.99999, 1.00001, 2.0] {
            prop_assert!(!(unit * F::from_f64(factor)).is_unit(), "{factor} times");
        }
        Ok(())
    });
}

/// Times a power of two, a number keeps all its digits.
pub fn scaling_by_a_power_of_two_is_exact<F: Sample>() {
    for_all((number::<F>(-40..40), -60..60i32), |(x, exponent)| {
        let factor = f64::from(exponent).exp2();
        prop_assert_eq!(exact(x.scaled(factor)), exact(x) * exact(factor));
        Ok(())
    });
}
