//! The sphere (from the lab before this one).

mod wide;

use super::wide::one_precision_up;
use super::{Hit, Projection, Shape, gamma};
use crate::error::Invalid;
use crate::quality::Quality;
use crate::ray::{Ray, Span};
use crate::real::{Mask, Real, Scalar};
use crate::vector::Vector;
use std::cmp::Ordering;

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

    /// On which side a finite point lies, in exact arithmetic. Greater outside, less inside, equal
    /// on the sphere.
    pub fn side(&self, point: S::Vector) -> Ordering {
        wide::side::<S>(point, self.center, self.radius)
    }

    /// The radius.
    pub fn radius(&self) -> S {
        self.radius
    }
}

/// The two parameters at which a line meets a sphere, the smaller first; NaN where it does not, and
/// `None` where no lane does.
type Roots<R> = Option<(R, R)>;

/// The quadratic formula as textbooks have it, `(-b ∓ sqrt(b² - 4ac)) / 2a`, for a direction of any
/// length.
#[inline(always)]
fn textbook_roots<R: Real>(from_center: R::Vector, direction: R::Vector, radius: R) -> Roots<R> {
    let (two, four) = (radius.constant(2.0), radius.constant(4.0));
    let a = direction.dot(direction);
    let b = two * direction.dot(from_center);
    let c = from_center.dot(from_center) - radius * radius;
    let root = root_of(b * b - four * a * c)?;
    Some(((-b - root) / (two * a), (-b + root) / (two * a)))
}

/// The discriminant from what is left of the way to the center after its part along the ray, and
/// the root of larger magnitude first, the other by Vieta's theorem.
///
/// Source: Haines, Günther, Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection",
/// Ray Tracing Gems (2019), chapter 7, for a direction of any length.
#[inline(always)]
fn stable_roots<R: Real>(from_center: R::Vector, direction: R::Vector, radius: R) -> Roots<R> {
    let a = direction.dot(direction);
    let b = -from_center.dot(direction);
    let c = from_center.dot(from_center) - radius * radius;
    let residual = from_center + direction * (b / a);
    let root = root_of(a * (radius * radius - residual.dot(residual)))?;
    let ahead = b.ge(b.constant(0.0));
    let q = b + R::select(ahead, root, -root);
    let (first, second) = (c / q, q / a);
    Some((
        R::select(ahead, first, second),
        R::select(ahead, second, first),
    ))
}

/// The root of a discriminant: a root is the dearest operation, and most rays miss most spheres.
#[inline(always)]
fn root_of<R: Real>(discriminant: R) -> Option<R> {
    let meets = discriminant.ge(discriminant.constant(0.0));
    meets.any().then(|| discriminant.sqrt())
}

/// The nearer root that lies in the interval.
#[inline(always)]
fn nearest<R: Real<Scalar: Scalar>>(roots: Roots<R>, span: &Span<R>) -> Hit<R> {
    let Some((near, far)) = roots else {
        return Hit::none(span.max.token());
    };
    let near_counts = span.contains(near);
    Hit {
        mask: near_counts | span.contains(far),
        t: R::select(near_counts, near, far),
    }
}

impl<S: Scalar> Shape<S> for Sphere<S> {
    #[inline(always)]
    fn intersect<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
    ) -> Hit<R> {
        let token = ray.origin.x().token();
        let (origin, direction) = (ray.origin, ray.direction);
        let (center, radius) = (
            R::Vector::splat(token, &self.center),
            R::splat(token, self.radius),
        );
        match quality {
            Quality::Textbook => nearest(textbook_roots(origin - center, direction, radius), span),
            Quality::Stable => nearest(stable_roots(origin - center, direction, radius), span),
            Quality::Wide => one_precision_up(ray, span, |ray, span| {
                wide::wide_t(ray, span, self.center, self.radius)
            }),
        }
    }

    /// `c + (p - c) r / |p - c|`: 5 roundings of the way from the center (pbrt, section 6.8.4), and
    /// one of the sum.
    #[inline(always)]
    fn project<R: Real<Scalar = S>>(&self, point: R::Vector) -> Projection<R> {
        let token = point.x().token();
        let center = R::Vector::splat(token, &self.center);
        let from_center = point - center;
        let distance = from_center.dot(from_center).sqrt();
        let from_center = from_center * (R::splat(token, self.radius) / distance);
        let projected = center + from_center;
        let [along, last] = [5.0, 1.0].map(|n| point.x().constant(gamma::<S>(n)));
        Projection {
            point: projected,
            error: from_center.abs() * along + projected.abs() * last,
        }
    }

    #[inline(always)]
    fn normal_at<R: Real<Scalar = S>>(&self, point: R::Vector) -> R::Vector {
        (point - R::Vector::splat(point.x().token(), &self.center)).normalized()
    }
}
