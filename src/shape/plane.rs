//! The plane (clauses 1.1 and 1.2).

use super::{Hit, Shape};
use crate::error::Invalid;
use crate::ray::{Ray, Span};
use crate::real::{Real, Scalar};
use crate::vector::Vector;

/// A plane through a point, with a normal. It has no inside: both sides are seen alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<S: Scalar> {
    point: S::Vector,
    normal: S::Vector,
    unit_normal: S::Vector,
}

impl<S: Scalar> Plane<S> {
    /// The plane through `point` at a right angle to `normal`, which may have any length but zero.
    ///
    /// # Errors
    /// If the point or the normal is not finite, or the square of the normal's length overflows or
    /// underflows in this format, as that of zero does.
    pub fn new(point: S::Vector, normal: S::Vector) -> Result<Self, Invalid> {
        let point = Invalid::unless_finite::<S>("plane point", point)?;
        let unit_normal = normal.normalized();
        let must_be = "finite, with a squared length that neither overflows nor vanishes";
        let valid = unit_normal.is_unit();
        let normal = Invalid::unless_vector::<S>(valid, "plane normal", normal, must_be)?;
        Ok(Self {
            point,
            normal,
            unit_normal,
        })
    }

    /// A point of the plane.
    pub fn point(&self) -> S::Vector {
        self.point
    }

    /// The normal, of the length it was given with.
    pub fn normal(&self) -> S::Vector {
        self.normal
    }

    /// The parameter `t = dot(point - origin, normal) / dot(direction, normal)` (clause 1.1): infinite or NaN on a parallel ray.
    #[inline(always)]
    fn t<R: Real<Scalar = S>>(&self, ray: &Ray<R>) -> R {
        let token = ray.origin.x().token();
        let normal = R::Vector::splat(token, self.normal);
        let to_point = R::Vector::splat(token, self.point) - ray.origin;
        to_point.dot(normal) / ray.direction.dot(normal)
    }
}

impl<S: Scalar> Shape<S> for Plane<S> {
    #[inline(always)]
    fn intersect<R: Real<Scalar = S>>(&self, ray: &Ray<R>, span: &Span<R>) -> Hit<R> {
        let t = self.t(ray);
        Hit {
            mask: span.contains(t),
            t,
        }
    }

    #[inline(always)]
    fn intersect_any<R: Real<Scalar = S>>(&self, ray: &Ray<R>, span: &Span<R>) -> R::Mask {
        span.contains(self.t(ray))
    }

    #[inline(always)]
    fn normal_at<R: Real<Scalar = S>>(&self, point: R::Vector) -> R::Vector {
        R::Vector::splat(point.x().token(), self.unit_normal)
    }
}
