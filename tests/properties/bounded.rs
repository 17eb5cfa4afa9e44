//! Bounded numbers: the exact result of every operation lies within its bound, whatever the
//! magnitudes, and a proof with smaller bounds is found out.

use crate::exact::{Exact, abs, cross, dot, exact};
use crate::property::{Verdict, for_all};
use dashu_ratio::RBig;
use ombrage::{
    Bounded, Constant, DoubleDouble, Kleene, Precise, Proof, Real, Rigorous, Rounded, Scalar,
};
use proptest::prelude::*;
use std::fmt::Debug;

/// A bounded number, and an exact one that it may stand for.
#[derive(Clone, Debug)]
pub struct Known<S> {
    value: S,
    error: S,
    truth: RBig,
}

impl<S: Rounded + Exact> Known<S> {
    fn number<P: Proof>(&self) -> Bounded<S, P> {
        Bounded::new(self.value, self.error)
    }
}

/// Numbers whose exponents are in a range, known exactly, nearly or hardly; the exact number lies
/// at an end of what the bound allows, or between.
fn known<S: Rounded + Exact>(
    exponents: std::ops::Range<i32>,
) -> impl Strategy<Value = Known<S>> + Clone {
    let parts = (exponents, 1.0..2.0f64, -60..-54i32, any::<bool>(), 0..12u8);
    let error = (-60..8i32, 1.0..2.0f64, 0..3u8);
    (parts, error, -1.0..1.0f64, 0..3u8).prop_filter_map("finite", |(value, error, place, end)| {
        let (exponent, mantissa, low, negative, zero) = value;
        let magnitude = match zero {
            0 => 0.0,
            _ => mantissa * f64::from(exponent).exp2(),
        };
        let high = if negative { -magnitude } else { magnitude };
        let low = high * f64::from(low).exp2() * mantissa;
        let value = S::from_double_double(DoubleDouble::new(high, low));
        let (exponent, mantissa, kind) = error;
        let size = value.to_f64().abs().max(S::MIN_POSITIVE);
        let error = match kind {
            0 => S::from_f64(0.0),
            _ => S::from_f64(size * f64::from(exponent).exp2() * mantissa),
        };
        let place = match end {
            0 => -1.0,
            1 => 1.0,
            _ => place,
        };
        finite(&[value, error]).then(|| Known {
            value,
            error,
            truth: exact(value) + exact(error) * exact(place),
        })
    })
}

/// Whether every number here is finite; what is not has no exact value.
fn finite<S: Scalar>(numbers: &[S]) -> bool {
    numbers.iter().all(|x| x.is_finite())
}

/// What one operation's roundings may take away from a bound.
fn allowed<S: Rounded + Exact>(error: S) -> RBig {
    exact(error) * (exact(1.0) + exact(16.0) * exact(S::SUM))
}

/// The result, where its bound is finite, is within it of the truth.
fn within<S: Rounded + Exact, P: Proof>(
    name: &str,
    result: Bounded<S, P>,
    truth: impl FnOnce() -> RBig,
) -> Verdict {
    if finite(&[result.value, result.error]) {
        let off = abs(exact(result.value) - truth());
        let words = || format!("{name}: {result:?} is off by {:e}", off.to_f64().value());
        prop_assert!(off <= allowed(result.error), "{}", words());
    }
    Ok(())
}

/// An answer is certain only of what is true.
fn truthful(name: &str, answer: Kleene<bool>, truth: bool) -> Verdict {
    prop_assert!(
        truth || !answer.certain,
        "{name} is certainly true, but false"
    );
    prop_assert!(
        !truth || answer.possible,
        "{name} is certainly false, but true"
    );
    Ok(())
}

pub fn sums<S: Rounded + Exact, P: Proof>((a, b): (Known<S>, Known<S>)) -> Verdict {
    let (x, y) = (a.number::<P>(), b.number::<P>());
    within("a sum", x + y, || &a.truth + &b.truth)?;
    within("a difference", x - y, || &a.truth - &b.truth)
}

pub fn products<S: Rounded + Exact, P: Proof>((a, b): (Known<S>, Known<S>)) -> Verdict {
    let product = a.number::<P>() * b.number::<P>();
    within("a product", product, || &a.truth * &b.truth)
}

/// The words that fuse products: of a, b and their sum.
fn fused<S: Rounded + Exact, P: Proof>((a, b): (Known<S>, Known<S>)) -> Verdict {
    let (x, y) = (a.number::<P>(), b.number::<P>());
    let (p, q) = (&a.truth, &b.truth);
    let sum = Real::sum_of_products([x, y, -y], [y, x, x]);
    within("a sum of products", sum, || p * q)?;
    let squares = Real::sum_of_squares([x, y, -x]);
    within("a sum of squares", squares, || p * p + q * q + p * p)?;
    let difference = Real::difference_of_products([x, x], [y, y]);
    within("a difference of products", difference, || p * p - q * q)
}

/// The word that fuses products of vectors.
pub fn fused_vectors<S: Rounded + Exact, P: Proof>((a, b): (Known<S>, Known<S>)) -> Verdict {
    let (x, y) = (a.number::<P>(), b.number::<P>());
    let (p, q) = (&a.truth, &b.truth);
    let (scalar, square) = Real::products([x, y, x], [y, y, -x]);
    within("a scalar product", scalar, || p * q + q * q - p * p)?;
    let vector_product = [exact(-2.0) * p * q, p * q + p * p, p * q - q * q];
    within("the square of a vector product", square, || {
        dot(&vector_product, &vector_product)
    })
}

/// The same of vectors whose components have nothing to do with each other, in magnitude or in how
/// well they are known, and are 0 here and there.
fn unlike_vectors<S: Rounded + Exact>(exponents: std::ops::Range<i32>) {
    let component = || known::<S>(exponents.clone());
    let vector = || [component(), component(), component()];
    for_all((vector(), vector()), |(a, b)| {
        let number = |known: Known<S>| known.number::<Rigorous>();
        let (x, y) = (a.clone().map(number), b.clone().map(number));
        let (p, q) = (a.map(|known| known.truth), b.map(|known| known.truth));
        let (scalar, square) = Real::products(x, y);
        within("a scalar product", scalar, || dot(&p, &q))?;
        within("a sum of products", Real::sum_of_products(x, y), || {
            dot(&p, &q)
        })?;
        within("a sum of squares", Real::sum_of_squares(x), || dot(&p, &p))?;
        let m = cross(&p, &q);
        within("the square of a vector product", square, || dot(&m, &m))
    });
}

/// `1/√A` where `(v - e)² A <= 1 <= (v + e)² A`.
fn inverse_roots<S: Rounded + Exact, P: Proof>((a, _): (Known<S>, Known<S>)) -> Verdict {
    let root = a.number::<P>().inverse_root();
    if !finite(&[root.value, root.error]) {
        return Ok(());
    }
    prop_assert!(a.truth > RBig::ZERO, "the root of 1 over {a:?} is known");
    let (value, error) = (exact(root.value), allowed(root.error));
    let (below, above) = (&value - &error, &value + &error);
    let low = below < RBig::ZERO || &below * &below * &a.truth <= exact(1.0);
    prop_assert!(
        low && exact(1.0) <= &above * &above * &a.truth,
        "{root:?} of {a:?}"
    );
    Ok(())
}

pub fn quotients<S: Rounded + Exact, P: Proof>((a, b): (Known<S>, Known<S>)) -> Verdict {
    let quotient = a.number::<P>() / b.number::<P>();
    if b.truth == RBig::ZERO {
        prop_assert!(!quotient.error.is_finite(), "a quotient by zero is known");
        return Ok(());
    }
    within("a quotient", quotient, || &a.truth / &b.truth)
}

/// `(v - e)² <= A <= (v + e)²`, where v - e is not negative.
pub fn roots<S: Rounded + Exact, P: Proof>((a, _): (Known<S>, Known<S>)) -> Verdict {
    let root = a.number::<P>().sqrt();
    if !finite(&[root.value, root.error]) {
        return Ok(());
    }
    prop_assert!(
        a.truth >= RBig::ZERO,
        "the root of a negative number is known"
    );
    let (value, error) = (exact(root.value), allowed(root.error));
    let (below, above) = (&value - &error, &value + &error);
    let low = below < RBig::ZERO || &below * &below <= a.truth;
    prop_assert!(
        low && a.truth <= &above * &above,
        "the root {root:?} of {a:?}"
    );
    Ok(())
}

/// The words that do not round.
fn others<S: Rounded + Exact, P: Proof>((a, b): (Known<S>, Known<S>)) -> Verdict {
    let (x, y) = (a.number::<P>(), b.number::<P>());
    within("the negative", -x, || -a.truth.clone())?;
    within("the magnitude", x.abs(), || abs(a.truth.clone()))?;
    within("the integer part", x.trunc(), || {
        RBig::from(a.truth.trunc())
    })?;
    let binade = x.binade();
    if binade.error.is_finite() && binade.value.to_f64() > 0.0 {
        let (least, magnitude) = (exact(binade.value), abs(a.truth.clone()));
        let inside = least <= magnitude && magnitude < least * exact(2.0);
        prop_assert!(inside, "{binade:?} is not the leading bit of {a:?}");
    }
    for unknown in [x.step(y), Real::each([x], |[x]| x)] {
        prop_assert!(!unknown.error.is_finite(), "{unknown:?} is known");
    }
    Ok(())
}

pub fn comparisons<S: Rounded + Exact, P: Proof>((a, b): (Known<S>, Known<S>)) -> Verdict {
    let (x, y) = (a.number::<P>(), b.number::<P>());
    truthful("a < b", x.lt(y), a.truth < b.truth)?;
    truthful("a <= b", x.le(y), a.truth <= b.truth)?;
    truthful("a is b", x.is(y), a.truth == b.truth)?;
    truthful("a > b", x.gt(y), a.truth > b.truth)?;
    truthful("a >= b", x.ge(y), a.truth >= b.truth)
}

/// The larger of the two, by a choice.
pub fn choices<S: Rounded + Exact, P: Proof>((a, b): (Known<S>, Known<S>)) -> Verdict {
    let (x, y) = (a.number::<P>(), b.number::<P>());
    let larger = Bounded::select(x.lt(y), y, x);
    within("a choice", larger, || a.truth.clone().max(b.truth.clone()))
}

/// Two numbers of magnitudes that have nothing to do with each other, or nearly the same number.
pub fn pairs<S: Rounded + Exact>(
    exponents: std::ops::Range<i32>,
) -> impl Strategy<Value = (Known<S>, Known<S>)> + Clone {
    let near = (
        known::<S>(exponents.clone()),
        known::<S>(exponents.clone()),
        0..4u8,
    );
    let near = near.prop_map(|(a, b, sign)| {
        let mut other = b;
        other.value = if sign == 0 { -a.value } else { a.value };
        other.truth = exact(other.value) + exact(other.error);
        (a, other)
    });
    prop_oneof![(known::<S>(exponents.clone()), known::<S>(exponents)), near]
}

/// Every exponent a number of the format can have.
fn all_exponents<S: Scalar>() -> std::ops::Range<i32> {
    match S::NAME {
        "f32" => -149..128,
        _ => -1074..1024,
    }
}

fn bounds_hold<S: Rounded + Exact>() {
    let exponents = all_exponents::<S>();
    for exponents in [exponents, -12..12] {
        for check in [
            sums::<S, Rigorous>,
            products::<S, Rigorous>,
            fused::<S, Rigorous>,
            fused_vectors::<S, Rigorous>,
            inverse_roots::<S, Rigorous>,
            quotients::<S, Rigorous>,
            roots::<S, Rigorous>,
            others::<S, Rigorous>,
            comparisons::<S, Rigorous>,
            choices::<S, Rigorous>,
        ] {
            for_all(pairs::<S>(exponents.clone()), check);
        }
        unlike_vectors::<S>(exponents);
    }
}

pub fn bounds_hold_in_f32() {
    bounds_hold::<f32>();
}

pub fn bounds_hold_in_f64() {
    bounds_hold::<f64>();
}

pub fn bounds_hold_in_double_double() {
    bounds_hold::<DoubleDouble>();
}

/// Quotients too large for the products that their remainders are found by.
pub fn large_quotients_are_within_their_bounds() {
    let exactly = |exponents| {
        known::<DoubleDouble>(exponents).prop_map(|known| Known {
            error: DoubleDouble::from_f64(0.0),
            truth: exact(known.value),
            ..known
        })
    };
    for_all(
        (exactly(960..990), exactly(-60..0)),
        quotients::<_, Rigorous>,
    );
}

/// In double-double the product of an exact 0 and a known number is exactly 0.
pub fn a_product_with_zero_is_zero() {
    for_all(known::<DoubleDouble>(-300..300), |other| {
        let zero = Bounded::<DoubleDouble>::exact(DoubleDouble::from_f64(0.0));
        for product in [zero * other.number(), other.number() * zero] {
            prop_assert_eq!((product.value.high(), product.error.high()), (0.0, 0.0));
        }
        Ok(())
    });
}

pub fn nothing_is_known_beyond_the_largest_number() {
    fn check<S: Rounded>() {
        let number = |x: S| Bounded::<S>::exact(x);
        let of = |x: f64| number(S::from_f64(x));
        let (zero, one, most) = (of(0.0), of(1.0), number(S::MAX));
        let (infinite, nan) = (of(f64::INFINITY), of(f64::NAN));
        for unknown in [
            most + most,
            most * most,
            most / of(S::MIN_POSITIVE),
            one / zero,
            zero / -zero,
            infinite + one,
            infinite * zero,
            nan + one,
            (-one).sqrt(),
            nan.abs() * zero,
        ] {
            assert!(!unknown.error.is_finite(), "{unknown:?} is known");
            for answer in [
                unknown.lt(one),
                unknown.le(one),
                one.lt(unknown),
                one.le(unknown),
            ] {
                assert!(!answer.decided(), "{unknown:?} is compared with 1");
            }
        }
    }
    check::<f32>();
    check::<f64>();
    check::<DoubleDouble>();
}

pub fn a_rounded_double_double_is_within_its_bound() {
    for_all(known::<DoubleDouble>(-1022..1023), |wide| {
        let number = wide.number::<Rigorous>();
        let (single, double) = (
            Bounded::<f32>::from_wide(number),
            Bounded::from_wide(number),
        );
        within("f32", single, || wide.truth.clone())?;
        within::<f64, Rigorous>("f64", double, || wide.truth.clone())?;
        let high = wide.value.high();
        within("a constant", Bounded::<f32>::from_f64(high), || exact(high))
    });
}

/// The squares of the ends lie on either side of 1/3, 1 and 3; the bound is not just wide.
pub fn half_tangents_are_within_their_bounds() {
    for (degrees, square) in [
        (60.0, exact(1.0) / exact(3.0)),
        (90.0, exact(1.0)),
        (120.0, exact(3.0)),
    ] {
        let tangent = Bounded::<DoubleDouble>::half_tangent(degrees);
        let (value, error) = (exact(tangent.value), exact(tangent.error));
        let (below, above) = (&value - &error, &value + &error);
        assert!(
            &below * &below <= square && square <= &above * &above,
            "{degrees} degrees"
        );
        assert!(tangent.error.high() < 1e-29, "{tangent:?}");
    }
    // The quotients that make the angle and the tangent may be off; the angle by the tangent's slope.
    for degrees in [1.0, 30.0, 60.0, 90.0] {
        let Bounded { value, error, .. } = Bounded::<DoubleDouble>::half_tangent(degrees);
        let (tangent, angle) = (value.high(), (degrees / 2.0).to_radians());
        let slope = 1.0 + tangent * tangent;
        let least = (angle * slope + tangent) * DoubleDouble::QUOTIENT;
        assert!(
            error.high() > least,
            "{degrees} degrees: {error:?} of {least}"
        );
    }
    for degrees in [0.0625, 1.0, 33.25, 89.0] {
        let tangent = |degrees| Bounded::<DoubleDouble>::half_tangent(degrees);
        let product = tangent(degrees) * tangent(180.0 - degrees);
        let off = abs(exact(product.value) - exact(1.0));
        assert!(off <= exact(product.error), "{degrees} degrees");
    }
    // tan 2x = 2 tan x / (1 - tan² x), by bounds alone.
    for_all(0.5..85.0f64, |degrees| {
        let tangent = |degrees| Bounded::<DoubleDouble>::half_tangent(degrees);
        let single = tangent(degrees);
        let one = single.constant(1.0);
        let apart = tangent(2.0 * degrees) - (single + single) / (one - single * single);
        prop_assert!(
            abs(exact(apart.value)) <= exact(apart.error),
            "{degrees}: {apart:?}"
        );
        Ok(())
    });
}
