//! Twice the precision, from plain operations alone: the truth for pictures, and the format one up
//! from `f64`.

use super::{Real, Scalar};
use crate::vector::Triple;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum of two numbers, the second at most half a unit in the last place of the
/// first: about 106 bits over `f64`, or over packets of it.
///
/// Sums are accurate to 2^-104 relative to the result, products and quotients to 2^-101, square
/// roots to 2^-100, as long as nothing overflows and no error term falls below the smallest normal
/// number: magnitudes between 1e-140 and 1e140 are safe in every operation.
///
/// Source: Joldeş, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic", ACM TOMS 44 (2017), algorithms 6, 11 and 17; exact products by Dekker's
/// splitting, so no fused multiply-add is needed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble<R = f64> {
    high: R,
    low: R,
}

impl<R: Real<Scalar = f64>> DoubleDouble<R> {
    /// The sum of two numbers as it is, without a rounding. A sum that overflows is an infinity.
    #[inline(always)]
    pub fn new(a: R, b: R) -> Self {
        let (high, low) = two_sum(a, b);
        Self::of(high, low)
    }

    /// The leading part: this number rounded.
    #[inline(always)]
    pub fn high(self) -> R {
        self.high
    }

    /// What rounding leaves out.
    #[inline(always)]
    pub fn low(self) -> R {
        self.low
    }

    /// A number without a second part.
    #[inline(always)]
    fn single(high: R) -> Self {
        Self {
            high,
            low: high.constant(0.0),
        }
    }

    /// A pair whose parts are already apart; an infinity or NaN has no second part.
    #[inline(always)]
    fn of(high: R, low: R) -> Self {
        Self {
            high,
            low: R::select(is_finite(high), low, high.constant(0.0)),
        }
    }

    /// The sum for `|a| >= |b|`, in three operations (Dekker's fast two-sum).
    #[inline(always)]
    fn ordered(a: R, b: R) -> Self {
        let high = a + b;
        Self::of(high, b - (high - a))
    }

    /// The product with a single number.
    #[inline(always)]
    fn times(self, factor: R) -> Self {
        let (high, error) = two_product(self.high, factor);
        Self::ordered(high, error + self.low * factor)
    }
}

/// Neither infinite nor NaN.
#[inline(always)]
fn is_finite<R: Real>(x: R) -> R::Mask {
    let zero = x.constant(0.0);
    (x * zero).le(zero)
}

/// The rounded sum and its exact error (Knuth).
#[inline(always)]
fn two_sum<R: Real>(a: R, b: R) -> (R, R) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// The rounded product and its exact error (Dekker, with Veltkamp's splitting).
#[inline(always)]
fn two_product<R: Real>(a: R, b: R) -> (R, R) {
    let product = a * b;
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

/// Two halves of 26 bits each whose sum is `a`.
#[inline(always)]
fn split<R: Real>(a: R) -> (R, R) {
    let scaled = a * a.constant(134_217_729.0);
    let high = scaled - (scaled - a);
    (high, a - high)
}

impl<R: Real<Scalar = f64>> Add for DoubleDouble<R> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (high, high_error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let sum = Self::ordered(high, high_error + low);
        Self::ordered(sum.high, low_error + sum.low)
    }
}

impl<R: Real<Scalar = f64>> Sub for DoubleDouble<R> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<R: Real<Scalar = f64>> Mul for DoubleDouble<R> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        Self::ordered(high, error + cross)
    }
}

impl<R: Real<Scalar = f64>> Div for DoubleDouble<R> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other.times(first);
        let second = rest.high / other.high;
        let rest = rest - other.times(second);
        let refined = Self::ordered(first, second) + Self::single(rest.high / other.high);
        let finite = is_finite(first) & is_finite(other.high);
        Self {
            high: R::select(finite, refined.high, first),
            low: R::select(finite, refined.low, first.constant(0.0)),
        }
    }
}

impl<R: Real<Scalar = f64>> Neg for DoubleDouble<R> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl PartialOrd for DoubleDouble {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high) {
            Some(Ordering::Equal) => self.low.partial_cmp(&other.low),
            order => order,
        }
    }
}

impl<R: Real<Scalar = f64>> Real for DoubleDouble<R> {
    type Scalar = DoubleDouble;
    type Mask = R::Mask;
    type Vector = Triple<Self>;
    type Token = R::Token;
    type Wide = Self;

    #[inline(always)]
    fn token(self) -> R::Token {
        self.high.token()
    }

    #[inline(always)]
    fn splat(token: R::Token, value: DoubleDouble) -> Self {
        Self {
            high: R::splat(token, value.high),
            low: R::splat(token, value.low),
        }
    }

    #[inline(always)]
    fn mask(token: R::Token, value: bool) -> R::Mask {
        R::mask(token, value)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        let (square, error) = two_product(root, root);
        let rest = self - Self::ordered(square, error);
        let refined = Self::ordered(root, rest.high / (root + root));
        let regular = is_finite(root) & root.gt(root.constant(0.0));
        Self {
            high: R::select(regular, refined.high, root),
            low: R::select(regular, refined.low, root.constant(0.0)),
        }
    }

    #[inline(always)]
    fn trunc(self) -> Self {
        let (zero, one) = (self.high.constant(0.0), self.high.constant(1.0));
        let whole = self.high.trunc();
        let low = self.low.trunc();
        let negative = self.high.lt(zero);
        let beyond = (negative & low.lt(self.low)) | (!negative & self.low.lt(low));
        let toward_zero = R::select(negative, one, -one);
        let low = R::select(beyond, low + toward_zero, low);
        let is_whole = whole.le(self.high) & self.high.le(whole);
        Self::ordered(whole, R::select(is_whole, low, zero))
    }

    #[inline(always)]
    fn step(self, count: Self) -> Self {
        let place = self.high.binade() * self.high.constant(<DoubleDouble as Scalar>::EPSILON);
        self + count.trunc().times(place)
    }

    #[inline(always)]
    fn binade(self) -> Self {
        Self::single(self.high.binade())
    }

    #[inline(always)]
    fn lt(self, other: Self) -> R::Mask {
        let equal = self.high.le(other.high) & other.high.le(self.high);
        self.high.lt(other.high) | (equal & self.low.lt(other.low))
    }

    #[inline(always)]
    fn le(self, other: Self) -> R::Mask {
        let equal = self.high.le(other.high) & other.high.le(self.high);
        self.high.lt(other.high) | (equal & self.low.le(other.low))
    }

    #[inline(always)]
    fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Self {
            high: R::select(mask, yes.high, no.high),
            low: R::select(mask, yes.low, no.low),
        }
    }

    #[inline(always)]
    fn widen(self) -> Self {
        self
    }

    #[inline(always)]
    fn narrow(wide: Self) -> Self {
        wide
    }

    #[inline(always)]
    fn narrow_mask(mask: R::Mask) -> R::Mask {
        mask
    }
}

impl Scalar for DoubleDouble {
    const NAME: &'static str = "double-double";
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON;
    const MAX: Self = Self {
        high: f64::MAX,
        low: f64::MAX * (f64::EPSILON / 4.0),
    };
    const MIN_POSITIVE: f64 = f64::MIN_POSITIVE;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::single(value)
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.high
    }

    fn from_double_double(value: DoubleDouble) -> Self {
        value
    }

    fn tan_half(degrees: Self) -> Self {
        let half = degrees.times(0.5);
        if half.high <= 45.0 {
            let (sine, cosine) = sine_cosine(half);
            sine / cosine
        } else {
            let (sine, cosine) = sine_cosine(Self::single(90.0) - half);
            cosine / sine
        }
    }
}

/// Sine and cosine of an angle of at most 45 degrees, by their Taylor series.
fn sine_cosine(degrees: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let pi = DoubleDouble {
        high: std::f64::consts::PI,
        low: 1.224_646_799_147_353_2e-16,
    };
    let angle = degrees * pi / DoubleDouble::single(180.0);
    let one = DoubleDouble::single(1.0);
    let (mut sine, mut cosine) = (angle, one);
    let (mut odd, mut even) = (angle, one);
    for n in (1..15).map(|n| f64::from(2 * n)) {
        even = -(even * angle * angle) / DoubleDouble::single(n * (n - 1.0));
        odd = -(odd * angle * angle) / DoubleDouble::single(n * (n + 1.0));
        cosine = cosine + even;
        sine = sine + odd;
    }
    (sine, cosine)
}
