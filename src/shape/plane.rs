//! The plane (clauses 1.1 and 1.2).

mod wide;

use super::wide::one_precision_up;
use super::{Hit, Projection, Shape, gamma};
use crate::error::Invalid;
use crate::quality::{Quality, unit};
use crate::ray::{Ray, Span};
use crate::real::{Real, Scalar};
use crate::vector::Vector;
use std::cmp::Ordering;

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
    /// If the point or the normal is not finite, or the normal is zero.
    pub fn new(point: S::Vector, normal: S::Vector) -> Result<Self, Invalid> {
        let point = Invalid::unless_finite::<S>("plane point", point)?;
        let unit_normal = unit::<S>(normal);
        let valid = unit_normal.is_unit();
        let must_be = "finite and not zero";
        let normal = Invalid::unless_vector::<S>(valid, "plane normal", normal, must_be)?;
        Ok(Self {
            point,
            normal,
            unit_normal,
        })
    }

    /// On which side a finite point lies, in exact arithmetic. Greater where the normal points,
    /// less behind, equal on the plane.
    pub fn side(&self, point: S::Vector) -> Ordering {
        wide::side::<S>(point, self.point, self.normal)
    }

    /// Whether the two planes have the same points, in exact arithmetic.
    pub(crate) fn coincides_with(&self, other: &Self) -> bool {
        let on_it = || self.side(other.point) == Ordering::Equal;
        self == other || (on_it() && wide::are_parallel::<S>(self.normal, other.normal))
    }

    /// A point of the plane.
    pub fn point(&self) -> S::Vector {
        self.point
    }

    /// The normal, of the length it was given with.
    pub fn normal(&self) -> S::Vector {
        self.normal
    }
}

/// The parameter `t = dot(point - origin, normal) / dot(direction, normal)` (clause 1.1): infinite
/// or NaN on a parallel ray.
#[inline(always)]
fn t<R: Real>(ray: &Ray<R>, point: R::Vector, normal: R::Vector) -> R {
    (point - ray.origin).dot(normal) / ray.direction.dot(normal)
}

impl<S: Scalar> Shape<S> for Plane<S> {
    #[inline(always)]
    fn intersect<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
    ) -> Hit<R> {
        let token = ray.origin.x().token();
        let (point, normal) = (
            R::Vector::splat(token, &self.point),
            R::Vector::splat(token, &self.normal),
        );
        match quality {
            Quality::Textbook | Quality::Stable => {
                let t = t(ray, point, normal);
                Hit {
                    mask: span.contains(t),
                    t,
                }
            }
            Quality::Wide => one_precision_up(ray, span, |ray, span| {
                wide::wide_t(ray, span, self.point, self.normal)
            }),
        }
    }

    /// `p - n dot(n, p - q)`. The difference, the product of three terms, the unit normal itself
    /// and the last product make 8 roundings of `dot(|n|, |p - q|)` along the normal, and the last
    /// difference one of the result.
    #[inline(always)]
    fn project<R: Real<Scalar = S>>(&self, point: R::Vector) -> Projection<R> {
        let token = point.x().token();
        let normal = R::Vector::splat(token, &self.unit_normal);
        let offset = point - R::Vector::splat(token, &self.point);
        let projected = point - normal * offset.dot(normal);
        let [along, last] = [8.0, 1.0].map(|n| point.x().constant(gamma::<S>(n)));
        let terms = offset.abs().dot(normal.abs());
        let error = normal.abs() * (terms * along) + projected.abs() * last;
        Projection {
            point: projected,
            error,
        }
    }

    #[inline(always)]
    fn normal_at<R: Real<Scalar = S>>(&self, point: R::Vector) -> R::Vector {
        R::Vector::splat(point.x().token(), &self.unit_normal)
    }
}
