//! Twice the precision of `f64`, from `f64` alone: the truth for pictures, and the format one up
//! from `f64`.

use super::{Constant, Precise, Real, Scalar};
use crate::vector::Triple;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum of two `f64` of which the second is at most half a unit in the last place of
/// the first: about 106 bits.
///
/// Sums are accurate to 2^-104 relative to the result, products to 2^-102, quotients to 2^-103, square
/// roots to 2^-101, as long as nothing overflows and no error term falls below the smallest normal
/// number (magnitudes between 1e-140 and 1e140 are safe throughout a kernel). Source: Joldeş,
/// Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
/// arithmetic", ACM TOMS 44 (2017), algorithms 6, 11 and 17; exact products by Dekker's splitting,
/// so no fused multiply-add is needed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// π, rounded: off by less than 2^-107.
    pub(super) const PI: Self = Self {
        high: std::f64::consts::PI,
        low: 1.224_646_799_147_353_2e-16,
    };

    /// The sum of two `f64` as it is, without a rounding. A sum that overflows is an infinity.
    #[inline(always)]
    pub fn new(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, b);
        Self::of(high, low)
    }

    /// The same number as an `f64`, exactly.
    #[inline(always)]
    pub fn from_f64(value: f64) -> Self {
        Self {
            high: value,
            low: 0.0,
        }
    }

    /// The leading part: this number rounded to `f64`.
    #[inline(always)]
    pub fn high(self) -> f64 {
        self.high
    }

    /// What rounding to `f64` leaves out.
    #[inline(always)]
    pub fn low(self) -> f64 {
        self.low
    }

    /// A pair whose parts are already apart; an infinity or NaN has no second part.
    #[inline(always)]
    fn of(high: f64, low: f64) -> Self {
        let low = if high.is_finite() { low } else { 0.0 };
        Self { high, low }
    }

    /// The same for `|a| >= |b|`, in three operations (Dekker's fast two-sum).
    #[inline(always)]
    fn ordered(a: f64, b: f64) -> Self {
        if !(a.is_finite() && b.is_finite()) {
            // The error of an infinity, of the root of 0, or of a factor too large to split, is not a
            // number.
            return Self::of(a, 0.0);
        }
        let high = a + b;
        Self::of(high, b - (high - a))
    }
}

/// The rounded sum and its exact error (Knuth).
#[inline(always)]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// The rounded product and its exact error (Dekker, with Veltkamp's splitting).
#[inline(always)]
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

/// Two halves of 26 bits each whose sum is `a`.
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

impl Add for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (high, high_error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let sum = Self::ordered(high, high_error + low);
        Self::ordered(sum.high, low_error + sum.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        Self::ordered(high, error + cross)
    }
}

impl Mul<f64> for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        let (high, error) = two_product(self.high, factor);
        Self::ordered(high, error + self.low * factor)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * first;
        let second = rest.high / other.high;
        let rest = rest - other * second;
        let quotient = Self::ordered(first, second);
        let refined = quotient + Self::of(rest.high / other.high, 0.0);
        if first.is_finite() && other.high.is_finite() {
            refined
        } else {
            Self::of(first, 0.0)
        }
    }
}

impl Neg for DoubleDouble {
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
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high) {
            Some(Ordering::Equal) => self.low.partial_cmp(&other.low),
            order => order,
        }
    }
}

impl Real for DoubleDouble {
    type Scalar = Self;
    type Mask = bool;
    type Vector = Triple<Self>;
    type Token = ();

    #[inline(always)]
    fn token(self) {}

    #[inline(always)]
    fn splat((): (), value: Self) -> Self {
        value
    }

    #[inline(always)]
    fn never((): ()) -> bool {
        false
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        let (square, error) = two_product(root, root);
        let rest = self - Self::ordered(square, error);
        Self::ordered(root, rest.high / (2.0 * root))
    }

    #[inline(always)]
    fn trunc(self) -> Self {
        let toward_zero = |x: f64| if self.high < 0.0 { x.ceil() } else { x.floor() };
        let whole = self.high.trunc();
        if whole == self.high {
            Self::ordered(whole, toward_zero(self.low))
        } else {
            Self::of(whole, 0.0)
        }
    }

    #[inline(always)]
    fn step(self, count: Self) -> Self {
        let power_of_two = f64::from_bits(self.high.to_bits() & (0x7ff << 52));
        self + count.trunc() * (power_of_two * Self::EPSILON)
    }

    #[inline(always)]
    fn binade(self) -> Self {
        Self::of(self.high.binade(), 0.0)
    }

    #[inline(always)]
    fn each<const N: usize>(inputs: [Self; N], f: impl Fn([Self; N]) -> Self) -> Self {
        f(inputs)
    }

    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn le(self, other: Self) -> bool {
        self <= other
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

impl Constant for DoubleDouble {
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON;
    const MIN_POSITIVE: f64 = f64::MIN_POSITIVE;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::from_f64(value)
    }
}

impl Scalar for DoubleDouble {
    type Wide = Self;

    const NAME: &'static str = "double-double";
    const MAX: Self = Self {
        high: f64::MAX,
        low: f64::MAX * (f64::EPSILON / 4.0),
    };

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.high
    }

    #[inline(always)]
    fn widen(self) -> Self {
        self
    }

    #[inline(always)]
    fn narrow(wide: Self) -> Self {
        wide
    }

    fn from_double_double(value: Self) -> Self {
        value
    }

    fn to_double_double(self) -> Self {
        self
    }

    #[inline(always)]
    fn scaled(self, power_of_two: f64) -> Self {
        Self::of(self.high * power_of_two, self.low * power_of_two)
    }

    fn tan_half(degrees: Self) -> Self {
        let half = degrees * 0.5;
        let pi = DoubleDouble::PI;
        let radians = |degrees: Self| degrees * pi / DoubleDouble::from_f64(180.0);
        if half.high <= 45.0 {
            let (sine, cosine) = sine_cosine(radians(half));
            sine / cosine
        } else {
            let (sine, cosine) = sine_cosine(radians(Self::from_f64(90.0) - half));
            cosine / sine
        }
    }
}

impl Precise for DoubleDouble {
    fn near(self) -> f64 {
        self.high
    }

    fn half_tangent(degrees: f64) -> Self {
        Self::tan_half(Self::from_f64(degrees))
    }
}

/// Sine and cosine of an angle of at most π/4, by their Taylor series: what is left out is below
/// 3e-36.
pub(super) fn sine_cosine<S: Constant>(angle: S) -> (S, S) {
    let one = S::from_f64(1.0);
    let (mut sine, mut cosine) = (angle, one);
    let (mut odd, mut even) = (angle, one);
    for n in (1..15).map(|n| f64::from(2 * n)) {
        even = -(even * angle * angle) / S::from_f64(n * (n - 1.0));
        odd = -(odd * angle * angle) / S::from_f64(n * (n + 1.0));
        cosine = cosine + even;
        sine = sine + odd;
    }
    (sine, cosine)
}
