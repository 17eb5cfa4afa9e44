//! Three numbers: a point, a direction or a colour. For `f32` and `f64` these are glam's own
//! vectors.

use crate::real::{Constant, Real};
use std::fmt::Debug;
use std::ops::{Add, Mul, Neg, Sub};

/// Three numbers, with the few operations the kernels need.
///
/// Sums and products are written out here once, so that every type that is a [`Vector`] rounds in
/// the same order: `(x x' + y y') + z z'`.
pub trait Vector<R: Real<Vector = Self>>:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Mul<R, Output = Self>
    + Neg<Output = Self>
{
    /// A vector from its three components.
    fn new(x: R, y: R, z: R) -> Self;
    /// The first component (of a colour: red).
    fn x(&self) -> R;
    /// The second component (of a colour: green).
    fn y(&self) -> R;
    /// The third component (of a colour: blue).
    fn z(&self) -> R;

    /// The same vector in every lane.
    ///
    /// By reference, like the components: by value a `glam::Vec3` travels as one integer of 96
    /// bits, and taking that apart costs a packet more than loading it.
    #[inline(always)]
    fn splat(token: R::Token, value: &<R::Scalar as Real>::Vector) -> Self {
        Self::new(
            R::splat(token, value.x()),
            R::splat(token, value.y()),
            R::splat(token, value.z()),
        )
    }

    /// Three constants, each rounded to the format, in every lane.
    #[inline(always)]
    fn constant(token: R::Token, [x, y, z]: [f64; 3]) -> Self {
        Self::splat(
            token,
            &Vector::new(
                Constant::from_f64(x),
                Constant::from_f64(y),
                Constant::from_f64(z),
            ),
        )
    }

    /// The scalar product.
    #[inline(always)]
    fn dot(self, other: Self) -> R {
        R::sum_of_products(self.to_array(), other.to_array())
    }

    /// The scalar product with itself: the square of the length.
    #[inline(always)]
    fn square(self) -> R {
        R::sum_of_squares(self.to_array())
    }

    /// The vector product.
    #[inline(always)]
    fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.to_array(), other.to_array());
        Self::new(
            R::difference_of_products([b, z], [c, y]),
            R::difference_of_products([c, x], [a, z]),
            R::difference_of_products([a, y], [b, x]),
        )
    }

    /// The scalar product, and the square of the vector product.
    #[inline(always)]
    fn products(self, other: Self) -> (R, R) {
        R::products(self.to_array(), other.to_array())
    }

    /// The unit vector of the same direction; not finite for the zero vector.
    ///
    #[inline(always)]
    fn normalized(self) -> Self {
        self * self.square().inverse_root()
    }

    /// The magnitude of each component.
    #[inline(always)]
    fn abs(self) -> Self {
        Self::new(self.x().abs(), self.y().abs(), self.z().abs())
    }

    /// Whether the length is 1, give or take rounding: what [`normalized`](Self::normalized)
    /// returns unless the square of the length overflows or underflows or is not a number.
    #[inline(always)]
    fn is_unit(self) -> R::Mask {
        let square = self.dot(self);
        let off = (square - square.constant(1.0)).abs();
        off.le(square.constant(64.0 * R::Scalar::EPSILON))
    }

    /// `yes` in the lanes where the mask holds, `no` elsewhere.
    #[inline(always)]
    fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Self::new(
            R::select(mask, yes.x(), no.x()),
            R::select(mask, yes.y(), no.y()),
            R::select(mask, yes.z(), no.z()),
        )
    }

    /// The three components, first to third.
    #[inline(always)]
    fn to_array(self) -> [R; 3] {
        [self.x(), self.y(), self.z()]
    }
}

macro_rules! glam_vector {
    ($vector:ty, $float:ty) => {
        impl Vector<$float> for $vector {
            #[inline(always)]
            fn new(x: $float, y: $float, z: $float) -> Self {
                <$vector>::new(x, y, z)
            }

            #[inline(always)]
            fn x(&self) -> $float {
                self.x
            }

            #[inline(always)]
            fn y(&self) -> $float {
                self.y
            }

            #[inline(always)]
            fn z(&self) -> $float {
                self.z
            }
        }
    };
}

glam_vector!(glam::Vec3, f32);
glam_vector!(glam::DVec3, f64);

/// The vector of every number that glam has none for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Triple<R>(
    /// The first component.
    pub R,
    /// The second component.
    pub R,
    /// The third component.
    pub R,
);

impl<R: Real<Vector = Self>> Vector<R> for Triple<R> {
    #[inline(always)]
    fn new(x: R, y: R, z: R) -> Self {
        Triple(x, y, z)
    }

    #[inline(always)]
    fn x(&self) -> R {
        self.0
    }

    #[inline(always)]
    fn y(&self) -> R {
        self.1
    }

    #[inline(always)]
    fn z(&self) -> R {
        self.2
    }
}

impl<R: Real> Add for Triple<R> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Triple(self.0 + other.0, self.1 + other.1, self.2 + other.2)
    }
}

impl<R: Real> Sub for Triple<R> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Triple(self.0 - other.0, self.1 - other.1, self.2 - other.2)
    }
}

impl<R: Real> Mul for Triple<R> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Triple(self.0 * other.0, self.1 * other.1, self.2 * other.2)
    }
}

impl<R: Real> Mul<R> for Triple<R> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: R) -> Self {
        Triple(self.0 * factor, self.1 * factor, self.2 * factor)
    }
}

impl<R: Real> Neg for Triple<R> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Triple(-self.0, -self.1, -self.2)
    }
}
