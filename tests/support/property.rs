//! Properties: checks of many random inputs, of which proptest shows the smallest that fails.

use crate::exact::Exact;
use ombrage::{Float, Ray, Vector};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};
use std::fmt::Debug;
use std::ops::Range;

/// What a property says of one input.
pub type Verdict = Result<(), TestCaseError>;

/// A float that properties are checked in.
pub trait Sample: Float + Exact {}
impl<F: Float + Exact> Sample for F {}

/// Checks many random inputs. Nothing is written; the failing input is in the message.
pub fn for_all<T: Debug>(inputs: impl Strategy<Value = T>, check: impl Fn(T) -> Verdict) {
    if let Err(failure) = TestRunner::new(config()).run(&inputs, check) {
        panic!("{failure}");
    }
}

/// Whether any of many random inputs, the same in every run, fails the check.
pub fn fails<T: Debug>(inputs: impl Strategy<Value = T>, check: impl Fn(T) -> Verdict) -> bool {
    let config = Config {
        cases: 4096,
        max_shrink_iters: 0,
        ..config()
    };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(config, random);
    runner.run(&inputs, check).is_err()
}

fn config() -> Config {
    let config = Config::default();
    Config {
        failure_persistence: None,
        max_global_rejects: 4096 + 16 * config.cases,
        ..config
    }
}

/// A number of either sign whose exponent is in the range; rarely zero.
pub fn number<F: Float>(exponents: Range<i32>) -> impl Strategy<Value = F> + Clone {
    let parts = (exponents, 1.0..2.0f64, any::<bool>(), 0..20u8);
    parts.prop_map(|(exponent, mantissa, negative, zero)| {
        let magnitude = if zero == 0 {
            0.0
        } else {
            mantissa * f64::from(exponent).exp2()
        };
        F::from_f64(if negative { -magnitude } else { magnitude })
    })
}

/// A number above zero whose exponent is in the range.
pub fn positive<F: Float>(exponents: Range<i32>) -> impl Strategy<Value = F> + Clone {
    (exponents, 1.0..2.0f64)
        .prop_map(|(exponent, mantissa)| F::from_f64(mantissa * f64::from(exponent).exp2()))
}

/// A vector of such numbers.
pub fn vector<F: Float>(exponents: Range<i32>) -> impl Strategy<Value = F::Vector> + Clone {
    let number = number::<F>(exponents);
    [number.clone(), number.clone(), number].prop_map(|[x, y, z]| F::Vector::new(x, y, z))
}

/// A ray whose direction is not zero.
pub fn ray<F: Float>(exponents: Range<i32>) -> impl Strategy<Value = Ray<F>> + Clone {
    let zero = F::Vector::constant((), [0.0; 3]);
    let direction = vector::<F>(-3..3).prop_filter("a direction", move |d| *d != zero);
    (vector::<F>(exponents), direction).prop_map(|(origin, direction)| Ray { origin, direction })
}

/// Any bits at all, and often a number that is special.
pub fn any_number<F: Float>() -> impl Strategy<Value = F> + Clone {
    let (max, tiny) = (F::MAX.to_f64(), F::MIN_POSITIVE * F::EPSILON);
    let special = [0.0, 1.0, tiny, max, f64::INFINITY, f64::NAN];
    prop_oneof![
        any::<u64>().prop_map(F::from_bits),
        number::<F>(-8..8),
        (proptest::sample::select(special.to_vec()), any::<bool>())
            .prop_map(|(x, negative)| F::from_f64(if negative { -x } else { x })),
    ]
}

/// A vector of any numbers.
pub fn any_vector<F: Float>() -> impl Strategy<Value = F::Vector> + Clone {
    let number = any_number::<F>();
    [number.clone(), number.clone(), number].prop_map(|[x, y, z]| F::Vector::new(x, y, z))
}

/// The unit roundoff: half the distance from 1 to the next number.
pub fn unit_roundoff<F: Float>() -> f64 {
    F::EPSILON / 2.0
}

/// Fails unless the vector has unit length, as far as rounding allows.
///
/// The square of a length is a scalar product without cancellation, 3 roundings; its reciprocal 1
/// more; the root halves them and adds 1; the last product adds 1. So the length is off by
/// 4 u. By the reciprocal of the root, as for lights, it is 1.5 + 1 + 1 + 1: 4.5 u. So the square
/// of the length is off by 9 u; 9.1 u leaves room for the products of errors.
pub fn is_unit<F: Sample>(v: F::Vector) -> Verdict {
    let exactly = crate::exact::exact_vector::<F>(v);
    let off = crate::exact::dot(&exactly, &exactly) - crate::exact::exact(1.0);
    let off = off.to_f64().value().abs();
    prop_assert!(
        off <= 9.1 * unit_roundoff::<F>(),
        "the length of {v:?} is off by {:e}",
        off / 2.0
    );
    Ok(())
}
