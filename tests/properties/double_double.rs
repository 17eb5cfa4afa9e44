//! The arithmetic of double-doubles, against exact rationals and the accuracy its documentation
//! states.

use crate::exact::{abs, exact, power_of_two};
use crate::property::for_all;
use dashu_ratio::RBig;
use ombrage::{DoubleDouble, Real, Scalar};
use proptest::prelude::*;

/// Numbers with all of their 106 bits, and with parts that are far apart, equal or zero.
fn numbers() -> impl Strategy<Value = DoubleDouble> {
    let part = |exponents: std::ops::Range<i32>| {
        (exponents, 1.0..2.0f64, any::<bool>()).prop_map(|(exponent, mantissa, negative)| {
            let magnitude = mantissa * f64::from(exponent).exp2();
            if negative { -magnitude } else { magnitude }
        })
    };
    let low = prop_oneof![4 => part(-54..-53), 2 => part(-100..-54), 1 => Just(0.0)];
    (part(-60..60), low).prop_map(|(high, low)| DoubleDouble::new(high, high * low))
}

/// `|actual - truth| <= 2^-bits |truth|`.
fn within(actual: DoubleDouble, truth: &RBig, bits: i32) -> Result<(), TestCaseError> {
    let error = abs(exact(actual) - truth);
    let words = format!("{actual:?} is off by {:e}", error.to_f64().value());
    prop_assert!(error <= power_of_two(-bits) * abs(truth.clone()), "{words}");
    let apart = actual.high() + actual.low() == actual.high();
    prop_assert!(apart, "{actual:?} is not rounded to its high part");
    Ok(())
}

pub fn parts_sum_up_exactly() {
    for_all((numbers(), numbers()), |(a, b)| {
        let sum = DoubleDouble::new(a.high(), b.high());
        prop_assert_eq!(exact(sum), exact(a.high()) + exact(b.high()));
        prop_assert_eq!(sum.high(), a.high() + b.high());
        Ok(())
    });
}

pub fn sums_are_within_2_to_the_minus_104() {
    for_all((numbers(), numbers()), |(a, b)| {
        within(a + b, &(exact(a) + exact(b)), 104)?;
        within(a - b, &(exact(a) - exact(b)), 104)
    });
}

/// Also where nearly everything cancels.
pub fn differences_of_neighbours_are_within_2_to_the_minus_104() {
    for_all((numbers(), -1e-14..1e-14f64), |(a, shift)| {
        let b = a + a * shift;
        within(a - b, &(exact(a) - exact(b)), 104)
    });
}

pub fn products_are_within_2_to_the_minus_102() {
    for_all((numbers(), numbers()), |(a, b)| {
        within(a * b, &(exact(a) * exact(b)), 102)?;
        within(a * b.high(), &(exact(a) * exact(b.high())), 102)
    });
}

/// Also where two steps of a long division, of three, do not suffice.
pub fn quotients_are_within_2_to_the_minus_103() {
    let check = |a, b| within(a / b, &(exact(a) / exact(b)), 103);
    for_all((numbers(), numbers()), |(a, b)| check(a, b));
    let a = DoubleDouble::new(1.066068617915857, -1.0496054783728578e-16);
    let b = DoubleDouble::new(1.040134467473356, 1.0352247540571013e-16);
    check(a, b).expect("three steps");
}

pub fn scaled_numbers_are_exact() {
    for_all((numbers(), -60..60i32), |(a, exponent)| {
        let power = f64::from(exponent).exp2();
        prop_assert_eq!(exact(a.scaled(power)), exact(a) * exact(power));
        Ok(())
    });
}

/// One precision up from a double-double is itself.
pub fn nothing_is_wider() {
    for_all(numbers(), |a| {
        prop_assert_eq!(a.widen(), a);
        prop_assert_eq!(DoubleDouble::narrow(a), a);
        Ok(())
    });
}

/// The square of a root that is off by e is off by 2 e.
pub fn roots_are_within_2_to_the_minus_101() {
    for_all(numbers(), |a| {
        let a = a.abs();
        let root = exact(a.sqrt());
        let error = abs(&root * &root - exact(a));
        prop_assert!(error <= power_of_two(-100) * exact(a), "root of {a:?}");
        Ok(())
    });
}

pub fn trunc_is_the_integer_part() {
    let near_whole = (numbers(), -1e20..1e20f64)
        .prop_map(|(a, whole)| DoubleDouble::new(whole.trunc(), a.low()));
    for_all(prop_oneof![numbers(), near_whole], |a| {
        let expected = RBig::from(exact(a).trunc());
        prop_assert_eq!(exact(a.trunc()), expected, "of {:?}", a);
        Ok(())
    });
}

pub fn comparisons_are_exact() {
    let neighbours = (numbers(), -2..=2).prop_map(|(a, places)| {
        let step = f64::from(places) * (a.low().abs() * f64::EPSILON);
        (a, DoubleDouble::new(a.high(), a.low() + step))
    });
    let same_high = (numbers(), numbers())
        .prop_map(|(a, b)| (a, DoubleDouble::new(a.high(), b.high() * 0.5f64.powi(200))));
    for_all(
        prop_oneof![(numbers(), numbers()), neighbours, same_high],
        |(a, b)| {
            prop_assert_eq!(a.lt(b), exact(a) < exact(b));
            prop_assert_eq!(a.le(b), exact(a) <= exact(b));
            prop_assert_eq!(a == b, exact(a) == exact(b));
            Ok(())
        },
    );
}

/// A place is the power of two below the number times 2^-104.
pub fn step_moves_by_whole_places() {
    for_all((numbers(), -300.0..300.0f64), |(a, count)| {
        let place = a.high().abs().log2().floor() as i32 - 104;
        // log2 may round up just below a power of two.
        let place = if a.high().abs() < f64::from(place + 104).exp2() {
            place - 1
        } else {
            place
        };
        let moved = a.step(DoubleDouble::from_f64(count));
        let truth = exact(a) + exact(count.trunc()) * power_of_two(place);
        within(moved, &truth, 104)?;
        prop_assert_eq!(moved > a, count >= 1.0);
        prop_assert_eq!(moved < a, count <= -1.0);
        Ok(())
    });
}

pub fn infinities_and_nan_never_become_numbers() {
    let of = DoubleDouble::from_f64;
    let (inf, nan, zero, one) = (of(f64::INFINITY), of(f64::NAN), of(0.0), of(1.0));
    let is_nan = |x: DoubleDouble| x.high().is_nan() && !(x.lt(zero) | x.le(zero) | x.ge(zero));
    assert_eq!((one / zero).high(), f64::INFINITY);
    assert_eq!((-one / zero).high(), f64::NEG_INFINITY);
    assert_eq!((one / inf).high(), 0.0);
    assert_eq!(DoubleDouble::new(f64::MAX, f64::MAX).high(), f64::INFINITY);
    assert_eq!(inf.sqrt().high(), f64::INFINITY);
    assert_eq!(zero.sqrt().high(), 0.0);
    for x in [
        zero / -zero,
        inf + -inf,
        inf / -inf,
        (-one).sqrt(),
        zero * inf,
        nan + one,
        nan * zero,
    ] {
        assert!(is_nan(x), "{x:?} is not NaN");
    }
    // An overflow never comes back as a number.
    let most = of(f64::MAX);
    for x in [
        inf + one,
        inf * one,
        most + most,
        most * most,
        most / of(f64::MIN_POSITIVE),
    ] {
        assert!(!x.is_finite(), "{x:?} is finite");
    }
    // A factor too large to split has a product all the same.
    let half = most * 0.5;
    assert!(half.is_finite() && (most * of(0.5)).is_finite() && (half + half).is_finite());
    assert!(one.lt(inf) && (-inf).lt(one) && !inf.lt(inf) && inf.le(inf));
}

/// `tan 2x (1 - tan² x) = 2 tan x`, from angles near 0 to angles near a right one.
pub fn tangents_are_those_of_half_the_angle() {
    for_all(0.5..85.0f64, |degrees| {
        let tangent = |degrees: f64| exact(DoubleDouble::tan_half(DoubleDouble::from_f64(degrees)));
        let (single, double) = (tangent(degrees), tangent(2.0 * degrees));
        let truth = exact(2.0) * &single;
        let off = abs(double * (exact(1.0) - &single * &single) - &truth);
        prop_assert!(off <= power_of_two(-98) * truth, "{degrees} degrees");
        Ok(())
    });
}

/// tan 30° = 1/√3, tan 45° = 1, tan 60° = √3, and the half angles that add up to a right one.
pub fn tangents_are_those_of_exact_angles() {
    let tangent = |degrees: f64| exact(DoubleDouble::tan_half(DoubleDouble::from_f64(degrees)));
    let near = |value: RBig, truth: f64| abs(value - exact(truth)) < power_of_two(-96);
    assert!(near(tangent(60.0) * tangent(60.0) * exact(3.0), 1.0));
    assert!(near(tangent(90.0), 1.0));
    assert!(near(tangent(120.0) * tangent(120.0), 3.0));
    for degrees in [1.0, 10.0, 33.25, 89.0] {
        assert!(
            near(tangent(degrees) * tangent(180.0 - degrees), 1.0),
            "{degrees} degrees"
        );
    }
}
