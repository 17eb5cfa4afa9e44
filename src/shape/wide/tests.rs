//! What filters are asked, and what must hold of their answers.

use super::{Span, trust};
use crate::real::{Constant, DoubleDouble, Real, Scalar};
use crate::vector::Vector;
use proptest::prelude::*;
use proptest::test_runner::{TestCaseError, TestRunner};
use std::fmt::Debug;

/// A vector of f64.
pub type Triple = [f64; 3];

/// A filter's answer: `None` where it is in doubt.
type Filtered<W> = Option<Option<W>>;

/// Checks many random inputs.
pub fn for_all<T: Debug>(
    inputs: impl Strategy<Value = T>,
    check: impl Fn(T) -> Result<(), TestCaseError>,
) {
    let config = ProptestConfig {
        cases: 4096,
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    if let Err(failure) = TestRunner::new(config).run(&inputs, check) {
        panic!("{failure}");
    }
}

/// Two unit vectors, one across the other; often both are across an axis.
pub fn crossed() -> impl Strategy<Value = [Triple; 2]> {
    let numbers = || prop::array::uniform3(-1.0..1.0_f64);
    let long = |v: &Triple| dot(*v, *v) > 0.01;
    (numbers(), numbers(), 0..6_usize).prop_filter_map("across", move |(a, b, axis)| {
        let flat = |v: Triple| [0, 1, 2].map(|i| if i == axis { 0.0 } else { v[i] });
        let (a, b) = (flat(a), flat(b));
        let a = scaled(a, dot(a, a).sqrt().recip());
        let b = plus(b, a, -dot(a, b));
        long(&b).then(|| [a, scaled(b, dot(b, b).sqrt().recip())])
    })
}

/// A factor from 1 to next to 1, on either side of it, down to a difference of 2^-`bits`.
pub fn near_one(bits: i32) -> impl Strategy<Value = f64> {
    (1..bits, any::<bool>(), 0.5..1.0_f64).prop_map(|(bits, above, mantissa)| {
        let off = mantissa * 0.5_f64.powi(bits);
        if above { 1.0 + off } else { 1.0 - off }
    })
}

pub fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn scaled(a: Triple, by: f64) -> Triple {
    a.map(|x| x * by)
}

/// `a + t b`.
pub fn plus(a: Triple, b: Triple, t: f64) -> Triple {
    [0, 1, 2].map(|i| a[i] + t * b[i])
}

/// Rounded to S, one precision up.
pub fn vector<S: Scalar>(v: Triple) -> <S::Wide as Real>::Vector {
    let [x, y, z] = v.map(|x| S::from_f64(x).widen());
    Vector::new(x, y, z)
}

/// Everything.
pub fn everywhere<W: Scalar>() -> Span<W> {
    Span {
        min: W::from_f64(f64::NEG_INFINITY),
        max: W::from_f64(f64::INFINITY),
    }
}

/// From next to a hit on, if there is one: else everything.
pub fn from_next_to<W: Scalar>(t: Option<DoubleDouble>, factor: f64) -> Span<W> {
    let next = |t: DoubleDouble| t + t * DoubleDouble::from_f64(factor - 1.0);
    Span {
        min: t.map_or(everywhere().min, |t| W::from_double_double(next(t))),
        ..everywhere()
    }
}

/// A filter that is not in doubt hits where exact arithmetic does, at a parameter that is within a
/// quarter of a unit in the last place of S.
pub fn is_right<S: Scalar>(filtered: Filtered<S::Wide>, exact: Option<DoubleDouble>) -> bool {
    match (filtered, exact) {
        (None, _) | (Some(None), None) => true,
        (Some(Some(t)), Some(exact)) => {
            let off = (t.to_double_double() - exact).to_f64().abs();
            off <= 0.25 * S::EPSILON * exact.to_f64().abs().binade()
        }
        _ => false,
    }
}

/// A number is in an interval, beside it, or in doubt: never in what it is not, and in doubt only at
/// the ends.
fn intervals<S: Scalar>() {
    let ends = prop::array::uniform2(0.5..2.0_f64);
    for_all((ends, near_one(120), 0..2_usize), |(ends, factor, end)| {
        let [min, max] = [ends[0], ends[0] + ends[1]].map(S::Wide::from_f64);
        let at = [min, max][end].to_double_double();
        let off = DoubleDouble::from_f64(factor - 1.0);
        let t = S::Wide::from_double_double(at + at * off);
        let span = Span { min, max };
        let found = super::surely_in(t, &span, trust::<S>());
        if let Some(is_in) = found {
            prop_assert_eq!(is_in, min.lt(t) & t.lt(max));
        }
        let is_clear = (factor - 1.0).abs() > 1e-3;
        prop_assert!(found.is_some() || !is_clear);
        let too_near = (factor - 1.0).abs() < 2.0 * trust::<S>();
        prop_assert!(found.is_none() || !too_near);
        prop_assert_eq!(super::surely_in(t, &everywhere(), trust::<S>()), Some(true));
        Ok(())
    });
}

#[test]
fn only_the_ends_of_an_interval_leave_a_doubt() {
    intervals::<f32>();
    intervals::<f64>();
}

/// What a filter trusts is wrong in the last place of S by less than a quarter, after 32 roundings
/// that each take so much of the wide format.
#[test]
fn trusted_results_are_right() {
    fn left_of_a_unit<S: Scalar>() -> f64 {
        32.0 * S::Wide::EPSILON / trust::<S>() / S::EPSILON
    }
    assert!(left_of_a_unit::<f32>() <= 0.25 && left_of_a_unit::<f64>() <= 0.25);
    assert!(trust::<f32>() < 1e-6 && trust::<f64>() < 1e-13);
}
