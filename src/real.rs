//! The words a kernel may use.
//!
//! A kernel (a plane, a sphere, a light, an integrator) is written once, over [`Real`]. What
//! differs between a plain float, a wider float, a packet of lanes or a value with a proven error
//! bound is who speaks these words, never the kernel.
//!
//! The vocabulary is small on purpose. Its operations are correctly rounded by IEEE 754 or exact,
//! so a kernel has the same bits on every machine: no fused multiply-add, no reciprocal estimates,
//! and no `min`, `max` or `clamp`, whose answers for NaN and signed zeros differ. Kernels are
//! branch-free where that costs nothing: a value from one formula, then a mask that says whether it
//! counts. A division by zero or the root of a negative number ends in a false mask by itself,
//! since every comparison with NaN is false.

mod bounded;
mod double_double;
pub(crate) mod exact;
pub(crate) mod expansion;
mod lanes;
mod packet;
mod pair;

pub use bounded::{ALLOWANCE, Bounded, Kleene, Proof, Rigorous, Rounded};
pub use double_double::DoubleDouble;
pub use lanes::{Job, Lanes};
pub use packet::{Lane, Packet, PacketMask};
pub(crate) use packet::{in_packets, in_single_packets};
pub use pair::Pair;

use crate::render::Draw;
use crate::vector::Vector;
use std::fmt::Debug;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// The answer of a comparison: one truth value a lane. For a scalar it is `bool`.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// Whether any lane is true. For a scalar this is the value itself, so an early exit stays a
    /// branch.
    fn any(self) -> bool;
}

impl Mask for bool {
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
}

/// A number, or several side by side, in which a kernel can be computed.
pub trait Real:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// One lane of this number: what scenes are made of.
    type Scalar: Constant;
    /// The answer of a comparison.
    type Mask: Mask;
    /// Three of these numbers: a point, a direction or a colour.
    type Vector: Vector<Self>;
    /// What it takes to make such a number from nothing. Scalars need nothing.
    type Token: Copy;

    /// The token this number was made with.
    fn token(self) -> Self::Token;
    /// The same value in every lane.
    fn splat(token: Self::Token, value: Self::Scalar) -> Self;
    /// False in every lane.
    fn never(token: Self::Token) -> Self::Mask;
    /// Square root, correctly rounded. NaN below zero.
    fn sqrt(self) -> Self;
    /// The integer part, rounded toward zero.
    fn trunc(self) -> Self;
    /// The number `trunc(count)` places further up (or down, where `count` is negative) in the
    /// order of all numbers of this format.
    ///
    /// In `f32` and `f64` a count that is NaN, or beyond 2^22 and 2^51, moves nothing. Crossing
    /// zero is not defined; [`Ray::offset`](crate::Ray::offset) stays away from it.
    fn step(self, count: Self) -> Self;
    /// The largest power of two that is not above the magnitude: the value of the leading bit. 0
    /// for zero and for numbers below the smallest normal one; infinity for infinities and NaN.
    fn binade(self) -> Self;
    /// `self < other`; false where either is NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`; false where either is NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// `yes` in the lanes where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Computes lane by lane, as scalars: for what would not fit the registers as packets.
    fn each<const N: usize>(
        inputs: [Self; N],
        f: impl Fn([Self::Scalar; N]) -> Self::Scalar,
    ) -> Self;

    /// `self > other`; false where either is NaN.
    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }

    /// `self >= other`; false where either is NaN.
    #[inline(always)]
    fn ge(self, other: Self) -> Self::Mask {
        other.le(self)
    }

    /// Whether the two numbers are the same.
    #[inline(always)]
    fn is(self, other: Self) -> Self::Mask {
        self.ge(other) & self.le(other)
    }

    /// The reciprocal of the square root, by way of the reciprocal: the root halves its error.
    #[inline(always)]
    fn inverse_root(self) -> Self {
        (self.constant(1.0) / self).sqrt()
    }

    /// `x x' + y y' + z z'`, summed from the left.
    #[inline(always)]
    fn sum_of_products([x, y, z]: [Self; 3], [u, v, w]: [Self; 3]) -> Self {
        x * u + y * v + z * w
    }

    /// `x² + y² + z²`, summed from the left.
    #[inline(always)]
    fn sum_of_squares([x, y, z]: [Self; 3]) -> Self {
        x * x + y * y + z * z
    }

    /// `a b - c d`.
    #[inline(always)]
    fn difference_of_products([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        a * b - c * d
    }

    /// The scalar product of two vectors, and the square of their vector product.
    #[inline(always)]
    fn products([a, b, c]: [Self; 3], [x, y, z]: [Self; 3]) -> (Self, Self) {
        let vector_product = [
            Self::difference_of_products([b, z], [c, y]),
            Self::difference_of_products([c, x], [a, z]),
            Self::difference_of_products([a, y], [b, x]),
        ];
        let square = Self::sum_of_squares(vector_product);
        (Self::sum_of_products([a, b, c], [x, y, z]), square)
    }

    /// A constant beside this number: `value` rounded to the format, in every lane.
    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        Self::splat(self.token(), Self::Scalar::from_f64(value))
    }

    /// The magnitude.
    #[inline(always)]
    fn abs(self) -> Self {
        Self::select(self.lt(self.constant(0.0)), -self, self)
    }
}

/// A number with one lane: what a kernel's constants are made of.
pub trait Constant:
    Real<Scalar = Self, Token = (), Vector: Send + Sync> + Send + Sync + 'static
{
    /// The distance from 1 to the next number: 2^-23, 2^-52, 2^-104.
    const EPSILON: f64;
    /// The smallest normal number above zero.
    const MIN_POSITIVE: f64;

    /// Rounds to this format, to nearest, ties to even.
    fn from_f64(value: f64) -> Self;
}

/// Numbers that scenes are set up in, once a frame.
pub trait Precise: Constant {
    /// The number rounded to `f64`, nearly.
    fn near(self) -> f64;
    /// The tangent of half the angle `degrees`, between 0 and 180.
    fn half_tangent(degrees: f64) -> Self;
}

/// A number with one lane and nothing beside it: `f32`, `f64` or [`DoubleDouble`].
pub trait Scalar:
    Constant<Mask = bool, Vector: PartialEq> + Draw + PartialEq + PartialOrd + Default
{
    /// The format one precision up: `f64` for `f32`, double-double for `f64`, itself for
    /// double-double.
    type Wide: Scalar;

    /// The format's name, as options and tables give it.
    const NAME: &'static str;
    /// The largest finite number.
    const MAX: Self;

    /// Rounds to `f64`, to nearest, ties to even.
    fn to_f64(self) -> f64;
    /// The same number one precision up, exactly.
    fn widen(self) -> Self::Wide;
    /// A number of the next precision, rounded to this one.
    fn narrow(wide: Self::Wide) -> Self;
    /// Rounds to this format; at most 1 unit in the last place off for `f32`, which is rounded
    /// twice.
    fn from_double_double(value: DoubleDouble) -> Self {
        Self::from_f64(value.to_f64())
    }
    /// The same number as a double-double, exactly.
    fn to_double_double(self) -> DoubleDouble {
        DoubleDouble::from_f64(self.to_f64())
    }
    /// The number times a power of two: exact, unless the product overflows or is below the
    /// smallest normal number.
    fn scaled(self, power_of_two: f64) -> Self;
    /// The tangent of half the angle `degrees`, from a pure-Rust implementation: the same bits on
    /// every machine.
    fn tan_half(degrees: Self) -> Self;

    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool {
        self.to_f64().is_finite()
    }
}
