//! Shapes: what rays hit. One file a shape.

mod plane;
mod sphere;
mod wide;

pub use plane::Plane;
pub use sphere::Sphere;

use crate::quality::Quality;
use crate::ray::{Ray, Span};
use crate::real::{Constant, Real, Scalar};
use crate::vector::Vector;

/// Where a ray meets a shape.
#[derive(Clone, Copy, Debug)]
pub struct Hit<R: Real> {
    /// Whether there is a hit at all.
    pub mask: R::Mask,
    /// The ray's parameter there. Where the mask is false it may be outside the interval, or not a
    /// number.
    pub t: R,
}

impl<R: Real> Hit<R> {
    /// A miss in every lane: `t` is not a number.
    #[inline(always)]
    fn none(token: R::Token) -> Self {
        Self {
            mask: R::never(token),
            t: R::splat(token, Constant::from_f64(f64::NAN)),
        }
    }
}

/// A point projected onto a shape.
#[derive(Clone, Copy, Debug)]
pub struct Projection<R: Real> {
    /// The point.
    pub point: R::Vector,
    /// A bound of its distance from the shape: the shape passes through the box of this half-size
    /// around it.
    pub error: R::Vector,
}

/// What every shape can be asked.
///
/// The shape is made of scalars; the ray may have one lane or many.
pub trait Shape<S: Scalar> {
    /// The nearest hit in the interval.
    fn intersect<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
    ) -> Hit<R>;

    /// Whether there is any hit in the interval, without saying where (clause 5.1). For one shape
    /// this costs what [`intersect`](Self::intersect) costs; what it saves, it saves on a scene.
    fn intersect_any<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
    ) -> R::Mask {
        self.intersect(ray, span, quality).mask
    }

    /// The point of the shape nearest to a point that should be on it, and how far rounding may
    /// have put it off.
    fn project<R: Real<Scalar = S>>(&self, point: R::Vector) -> Projection<R>;

    /// The unit normal at a point of the shape, on the side a plane's normal shows to or outside of
    /// a sphere.
    fn normal_at<R: Real<Scalar = S>>(&self, point: R::Vector) -> R::Vector;
}

impl<R: Real> Projection<R> {
    /// `yes` in the lanes where the mask holds, `no` elsewhere.
    #[inline(always)]
    pub(crate) fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Self {
            point: R::Vector::select(mask, yes.point, no.point),
            error: R::Vector::select(mask, yes.error, no.error),
        }
    }
}

/// Bound of the relative error of n roundings in a row: n u / (1 - n u), with u half of epsilon
/// (Higham, "Accuracy and Stability of Numerical Algorithms", 2nd edition (2002), lemma 3.1).
fn gamma<S: Scalar>(n: f64) -> f64 {
    let nu = n * S::EPSILON / 2.0;
    nu / (1.0 - nu)
}

#[cfg(test)]
mod tests;
