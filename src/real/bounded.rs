//! Numbers that carry a proven bound of their error, and decisions that may be left open.
//!
//! # What is promised
//!
//! A [`Bounded`] number stands for one exact number x, of which it knows a value v and a bound e:
//!
//! ```text
//! |x - v| <= (1 + δ) e,    δ <= 2^-10
//! ```
//!
//! The allowance δ is for the roundings of the bound itself. Every operation below computes its
//! bound from those of its operands by sums and products of numbers that are not negative, so each
//! rounding is one factor of at most 1 + u (u is the unit roundoff, 2^-24 in `f32`), and no
//! operation has more than 8 on any way from an operand's bound to its own; the products of
//! vectors, which have 13, count as two operations. A number at the end of n operations in a row so
//! has δ < 9 n u: in `f32` the promise holds for 1800 operations in a row, in `f64` for 10^12.
//! Whoever computes longer chains must not use `f32`. Where a bound is used, it
//! is multiplied by [`ALLOWANCE`], which is larger than 1 + δ.
//!
//! # Rounding and underflow
//!
//! For a sum, `|fl(a + b) - (a + b)| <= u |fl(a + b)|` holds without exception: a sum below the
//! smallest normal number is exact (Hauser, "Handling floating-point exceptions in numeric
//! programs", ACM TOPLAS 18 (1996)), and above it u |v|, even rounded, is not below half a unit of
//! the last place, which is a number of the format. Products, quotients and what is multiplied to
//! make their bounds may underflow, each by at most half of the smallest number above zero;
//! together less than η ([`Rounded::ETA`]), which such bounds contain as a term. (Higham,
//! "Accuracy and Stability of Numerical Algorithms", section 2.1 and equation 2.8.)
//!
//! # Overflow and doubt
//!
//! An infinite or undefined value has an infinite or undefined bound, since the bound contains
//! u |v|. A comparison with such a bound is neither certainly true nor certainly false. So doubt
//! spreads by itself: a choice that is not certain is made undefined (NaN) in its bound, and
//! everything that depends on it stays so.

mod arithmetic;
mod kleene;

use super::double_double::sine_cosine;
use super::{Constant, DoubleDouble, Precise, Real, Scalar};
pub use kleene::Kleene;
use std::fmt::Debug;
use std::marker::PhantomData;

/// What a bound is multiplied by before it decides anything.
pub const ALLOWANCE: f64 = 1.0 + 1.0 / 512.0;

/// A number with a bound of its error. What is promised, and why, is in
/// `docs/proven.md`.
#[derive(Clone, Copy, Debug)]
pub struct Bounded<B, P = Rigorous> {
    /// The number as computed.
    pub value: B,
    /// How far the exact number may be from it; NaN where nothing is known.
    pub error: B,
    proof: PhantomData<P>,
}

/// How bounds are drawn from the operations. [`Rigorous`] is the only honest way; the others are
/// made by tests, which must notice that they prove too much.
pub trait Proof: Copy + Debug + Send + Sync + 'static {
    /// What the bound of a sum is multiplied by.
    const SUM: f64 = 1.0;
    /// What the bound of a product is multiplied by.
    const PRODUCT: f64 = 1.0;
    /// What the bound of a quotient is multiplied by.
    const QUOTIENT: f64 = 1.0;
    /// What the bound of a root is multiplied by.
    const ROOT: f64 = 1.0;
    /// Whether comparisons decide by the values alone.
    const COMPARES_VALUES: bool = false;
    /// Whether a choice that is not certain is made by what is possible.
    const CHOOSES_POSSIBLE: bool = false;
}

/// Bounds as they are derived.
#[derive(Clone, Copy, Debug)]
pub struct Rigorous;
impl Proof for Rigorous {}

/// A format whose operations have known errors.
pub trait Rounded: Scalar {
    /// `|fl(a + b) - (a + b)|` over `|fl(a + b)|`.
    const SUM: f64;
    /// `|fl(a b) - a b|` over `|a b|`, but for underflow.
    const PRODUCT: f64;
    /// `|fl(a / b) - a / b|` over `|fl(a / b)|`, but for underflow.
    const QUOTIENT: f64;
    /// `|fl(√a) - √a|` over `|fl(√a)|`.
    const ROOT: f64;
    /// A number η that is much more than what an operation can lose by underflow. It is larger than
    /// it need be: the square of a bound, too, is to be a normal number, since processors are slow
    /// with others.
    const ETA: f64;
    /// The magnitudes between which that holds for products, quotients and roots, where they are
    /// not all there are.
    const LIMITS: Option<[f64; 2]>;
}

// Correctly rounded: u, and a little for the rounding of u |v| where that underflows (see
// `arithmetic.rs`).
impl Rounded for f32 {
    const SUM: f64 = f32::EPSILON as f64 / 2.0;
    const PRODUCT: f64 = Self::SUM;
    const QUOTIENT: f64 = 1.01 * Self::SUM;
    const ROOT: f64 = 1.01 * Self::SUM;
    const ETA: f64 = power_of_two(-60);
    const LIMITS: Option<[f64; 2]> = None;
}

impl Rounded for f64 {
    const SUM: f64 = f64::EPSILON / 2.0;
    const PRODUCT: f64 = Self::SUM;
    const QUOTIENT: f64 = 1.01 * Self::SUM;
    const ROOT: f64 = 1.01 * Self::SUM;
    const ETA: f64 = power_of_two(-480);
    const LIMITS: Option<[f64; 2]> = None;
}

/// 2 to a power that `f64` holds.
const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

// Joldeş, Muller, Popescu (see `DoubleDouble`) prove 2^-104.4 for the sum and 2^-103.1 for the
// product. The quotient is three steps of long division, of whose remainders the first is off by
// 3 · 2^-106 of the dividend: with the last sum 2^-103; the root is one step of Newton's, off by
// less than 4 · 2^-106. Both are taken with much to spare. Beyond the limits Dekker's splitting
// overflows, or a remainder underflows.
impl Rounded for DoubleDouble {
    const SUM: f64 = power_of_two(-104);
    const PRODUCT: f64 = power_of_two(-102);
    const QUOTIENT: f64 = power_of_two(-100);
    const ROOT: f64 = power_of_two(-100);
    const ETA: f64 = power_of_two(-480);
    const LIMITS: Option<[f64; 2]> = Some([power_of_two(-900), power_of_two(990)]);
}

impl<B: Real<Scalar: Rounded>, P: Proof> Bounded<B, P> {
    /// The number `value`, known to `error`.
    #[inline(always)]
    pub fn new(value: B, error: B) -> Self {
        Self {
            value,
            error,
            proof: PhantomData,
        }
    }

    /// The number itself.
    #[inline(always)]
    pub fn exact(value: B) -> Self {
        Self::new(value, value.constant(0.0))
    }

    /// How far the exact number can be from the value, all roundings of bounds included.
    #[inline(always)]
    pub fn reach(self) -> B {
        self.error * self.error.constant(ALLOWANCE)
    }

    /// This number, of which nothing is known any more in the lanes where the mask is false.
    #[inline(always)]
    fn only_where(self, known: B::Mask) -> Self {
        let unknown = self.error.constant(f64::NAN);
        Self::new(self.value, B::select(known, self.error, unknown))
    }
}

impl<S: Rounded, P: Proof> Bounded<S, P> {
    /// A double-double with its bound, rounded to a narrower format.
    pub fn from_wide<Q: Proof>(wide: Bounded<DoubleDouble, Q>) -> Self {
        let value = S::from_double_double(wide.value);
        let rounding = (wide.value - value.to_double_double()).abs();
        let error = (rounding + wide.reach()).to_f64();
        // Twice rounded, and upward: a part in 2^20 is more than either rounding takes away.
        let error = match error {
            0.0 => S::from_f64(0.0),
            _ => S::from_f64(error * (1.0 + 1e-6) + S::ETA),
        };
        Self::new(value, error)
    }
}

impl<S: Rounded, P: Proof> Constant for Bounded<S, P> {
    const EPSILON: f64 = S::EPSILON;
    const MIN_POSITIVE: f64 = S::MIN_POSITIVE;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        let rounded = S::from_f64(value);
        if rounded.to_f64() == value {
            Self::exact(rounded)
        } else {
            Self::from_wide(Bounded::<DoubleDouble, P>::exact(DoubleDouble::from_f64(
                value,
            )))
        }
    }
}

impl<P: Proof> Precise for Bounded<DoubleDouble, P> {
    fn near(self) -> f64 {
        self.value.high()
    }

    fn half_tangent(degrees: f64) -> Self {
        let half = Self::exact(DoubleDouble::from_f64(degrees) * 0.5);
        let [whole, right_angle] = [180.0, 90.0].map(Self::from_f64);
        let pi = Self::new(DoubleDouble::PI, DoubleDouble::from_f64(power_of_two(-107)));
        let left_out = |x: Self| Self::new(x.value, x.error + DoubleDouble::from_f64(3e-36));
        let sine_cosine = |degrees: Self| {
            let (sine, cosine) = sine_cosine(degrees * pi / whole);
            (left_out(sine), left_out(cosine))
        };
        if degrees <= 90.0 {
            let (sine, cosine) = sine_cosine(half);
            sine / cosine
        } else {
            let (sine, cosine) = sine_cosine(right_angle - half);
            cosine / sine
        }
    }
}
