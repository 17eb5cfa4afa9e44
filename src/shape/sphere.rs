//! The sphere (from the lab before this one).

use super::{Hit, Shape};
use crate::error::Invalid;
use crate::ray::{Ray, Span};
use crate::real::{Real, Scalar};
use crate::vector::Vector;

/// A sphere: all points at distance `radius` from `center`. It can be seen from inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<S: Scalar> {
    center: S::Vector,
    radius: S,
}

impl<S: Scalar> Sphere<S> {
    /// The sphere around `center`.
    ///
    /// # Errors
    /// If the center is not finite, or the radius is not finite and greater than 0.
    pub fn new(center: S::Vector, radius: S) -> Result<Self, Invalid> {
        let center = Invalid::unless_finite::<S>("sphere center", center)?;
        let valid = radius.is_finite() && radius.to_f64() > 0.0;
        let radius = Invalid::unless(valid, "sphere radius", radius, "finite and greater than 0")?;
        Ok(Self { center, radius })
    }

    /// The center.
    pub fn center(&self) -> S::Vector {
        self.center
    }

    /// The radius.
    pub fn radius(&self) -> S {
        self.radius
    }

    /// The two parameters at which the line meets the sphere, the smaller first; NaN where it does not.
    ///
    /// The quadratic formula as textbooks have it, `(-b ∓ sqrt(b² - 4ac)) / 2a`, for a direction of any length.
    #[inline(always)]
    fn roots<R: Real<Scalar = S>>(&self, ray: &Ray<R>) -> (R, R) {
        let token = ray.origin.x().token();
        let from_center = ray.origin - R::Vector::splat(token, self.center);
        let radius = R::splat(token, self.radius);
        let a = ray.direction.dot(ray.direction);
        let b = radius.constant(2.0) * ray.direction.dot(from_center);
        let c = from_center.dot(from_center) - radius * radius;
        let root = (b * b - radius.constant(4.0) * a * c).sqrt();
        let twice_a = radius.constant(2.0) * a;
        ((-b - root) / twice_a, (-b + root) / twice_a)
    }
}

impl<S: Scalar> Shape<S> for Sphere<S> {
    #[inline(always)]
    fn intersect<R: Real<Scalar = S>>(&self, ray: &Ray<R>, span: &Span<R>) -> Hit<R> {
        let (near, far) = self.roots(ray);
        let near_counts = span.contains(near);
        Hit {
            mask: near_counts | span.contains(far),
            t: R::select(near_counts, near, far),
        }
    }

    #[inline(always)]
    fn intersect_any<R: Real<Scalar = S>>(&self, ray: &Ray<R>, span: &Span<R>) -> R::Mask {
        let (near, far) = self.roots(ray);
        span.contains(near) | span.contains(far)
    }

    #[inline(always)]
    fn normal_at<R: Real<Scalar = S>>(&self, point: R::Vector) -> R::Vector {
        (point - R::Vector::splat(point.x().token(), self.center)).normalized()
    }
}
