//! Rays, and the part of a ray on which a hit counts.

use crate::real::{Constant, Real, Scalar};
use crate::vector::Vector;

/// A half-line of points `origin + t direction`. The direction may have any length but zero; `t`
/// counts in units of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<R: Real> {
    /// Where the ray starts.
    pub origin: R::Vector,
    /// Where it goes.
    pub direction: R::Vector,
}

impl<R: Real> Ray<R> {
    /// The point at parameter `t`.
    #[inline(always)]
    pub fn point_at(&self, t: R) -> R::Vector {
        self.origin + self.direction * t
    }

    /// The same ray with its origin moved a little along the unit vector `normal`, clear of the
    /// surface it starts on (clause 4.3, the lab's `Ray::offset`).
    ///
    /// Each coordinate moves by 256 units in its last place times the normal's component; below
    /// 1/32, where those units become too small, by 2^7 epsilon (2^-16 in `f32`) times it. The
    /// published constants are for `f32`: Wächter and Binder, "A Fast and Robust Method for
    /// Avoiding Self-Intersection", Ray Tracing Gems (2019), chapter 6. In `f64` the same 256 units
    /// and 2^-45 are used. It is too small where the hit point's own error is larger than that, for
    /// instance far from a large sphere.
    #[inline(always)]
    pub fn offset(&self, normal: R::Vector) -> Self {
        let (p, n) = (self.origin, normal);
        let origin = R::Vector::new(
            offset(p.x(), n.x()),
            offset(p.y(), n.y()),
            offset(p.z(), n.z()),
        );
        Self { origin, ..*self }
    }
}

/// One coordinate of [`Ray::offset`].
#[inline(always)]
fn offset<R: Real>(p: R, n: R) -> R {
    let near_zero = p.abs().lt(p.constant(1.0 / 32.0));
    let absolute = p + n * p.constant(128.0 * R::Scalar::EPSILON);
    R::select(near_zero, absolute, p.step(n * p.constant(256.0)))
}

/// The closed interval `[min, max]` of parameters at which a hit counts. Both ends belong to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span<R: Real> {
    /// The smallest parameter of a hit.
    pub min: R,
    /// The largest; always finite, so that a hit at infinity is none.
    pub max: R,
}

impl<R: Real<Scalar: Scalar>> Span<R> {
    /// The interval `[min, max]`. A `max` of infinity means every finite parameter.
    #[inline(always)]
    pub fn new(min: R, max: R) -> Self {
        let largest = R::splat(max.token(), R::Scalar::MAX);
        Self {
            min,
            max: R::select(max.gt(largest), largest, max),
        }
    }

    /// Whether `t` lies in the interval; false for NaN.
    #[inline(always)]
    pub fn contains(&self, t: R) -> R::Mask {
        t.ge(self.min) & t.le(self.max)
    }
}
