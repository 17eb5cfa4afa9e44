//! What known behaviours would answer, computed one precision up.

use super::Behaviour;
use crate::conformance::kernels::exact;
use crate::conformance::surface::Valid;
use crate::conformance::{Answer, Ends, Kernels, Question, Surface};
use crate::float::Float;
use crate::quality::Quality;
use crate::ray::Ray;
use crate::real::{DoubleDouble, Real, Scalar};
use crate::vector::{Triple, Vector};
use std::cmp::Ordering;

/// The nearest hit of one surface.
pub type Meet<F> = fn(&Ray<F>, Ends<F>, &Surface<F>) -> Option<F>;

/// The behaviours that can be predicted, each with the ways to have it.
pub fn ways<F: Float>() -> [(Behaviour, &'static [Meet<F>]); 6] {
    [
        (
            Behaviour::UnitDirectionAssumed,
            const { &[without_a::<F>, residual_without_a::<F>, by_distance::<F>] },
        ),
        (Behaviour::TMaxIgnored, const { &[without_end::<F>] }),
        (
            Behaviour::TMinIgnored,
            const {
                &[
                    from_zero::<F>,
                    without_start::<F>,
                    from_constant::<F, 6>,
                    from_constant::<F, 5>,
                    from_constant::<F, 4>,
                    from_constant::<F, 3>,
                ]
            },
        ),
        (
            Behaviour::OpenInterval,
            const {
                &[
                    after_start::<F>,
                    before_end::<F>,
                    inside::<F>,
                    unless_at_start::<F>,
                    unless_at_an_end::<F>,
                ]
            },
        ),
        (
            Behaviour::PlaneCulled,
            const { &[from_the_front::<F>, from_behind::<F>] },
        ),
        (
            Behaviour::InsideMissed,
            const { &[near_root::<F>, from_outside::<F>, from_off::<F>] },
        ),
    ]
}

/// The right answer, one precision up.
pub fn right<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    let kernels = Kernels {
        quality: Quality::Wide,
        shadow: None,
    };
    kernels.hit(ray, ends, surface)
}

/// The answer to a question about hits; `None` for others.
pub fn answer<F: Float>(question: &Question<F>, meet: Meet<F>) -> Option<Answer<F>> {
    match question {
        Question::Hit { ray, ends, surface } => Some(Answer::Hit(meet(ray, *ends, surface))),
        Question::AnyHit {
            ray,
            ends,
            surfaces,
        } => {
            let hit = |surface| meet(ray, *ends, surface).is_some();
            Some(Answer::AnyHit(surfaces.iter().any(hit)))
        }
        _ => None,
    }
}

fn infinity<F: Float>() -> F {
    F::from_f64(f64::INFINITY)
}

fn without_end<F: Float>(ray: &Ray<F>, [tmin, _]: Ends<F>, surface: &Surface<F>) -> Option<F> {
    right(ray, [tmin, infinity()], surface)
}

fn from_zero<F: Float>(ray: &Ray<F>, [_, tmax]: Ends<F>, surface: &Surface<F>) -> Option<F> {
    right(ray, [F::from_f64(0.0), tmax], surface)
}

fn without_start<F: Float>(ray: &Ray<F>, [_, tmax]: Ends<F>, surface: &Surface<F>) -> Option<F> {
    right(ray, [-F::MAX, tmax], surface)
}

/// From 10^-DIGITS, as against acne.
fn from_constant<F: Float, const DIGITS: i32>(
    ray: &Ray<F>,
    [_, tmax]: Ends<F>,
    surface: &Surface<F>,
) -> Option<F> {
    right(ray, [F::from_f64(10f64.powi(-DIGITS)), tmax], surface)
}

/// The next number up, or down where `way` is -1.
fn next<F: Float>(x: F, way: f64) -> F {
    if x.to_f64() == 0.0 {
        return F::from_f64(way * F::MIN_POSITIVE * F::EPSILON);
    }
    x.step(F::from_f64(way))
}

/// A hit at `tmin` does not count, and the far root is tried. It is the rounded t that is compared.
fn after_start<F: Float>(ray: &Ray<F>, [tmin, tmax]: Ends<F>, surface: &Surface<F>) -> Option<F> {
    unless_at_start(ray, [tmin, tmax], surface)
        .or_else(|| right(ray, [next(tmin, 1.0), tmax], surface))
}

fn before_end<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    right(ray, ends, surface).filter(|t| *t < ends[1])
}

fn inside<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    after_start(ray, ends, surface).filter(|t| *t < ends[1])
}

/// A hit at `tmin` does not count, and no other is tried.
fn unless_at_start<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    right(ray, ends, surface).filter(|t| *t > ends[0])
}

fn unless_at_an_end<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    unless_at_start(ray, ends, surface).filter(|t| *t < ends[1])
}

/// The sign of dot(d, n); 0 for a sphere.
fn along_normal<F: Float>(ray: &Ray<F>, surface: &Surface<F>) -> f64 {
    match *surface {
        Surface::Plane { normal, .. } => exact::<F>(ray.direction).dot(exact::<F>(normal)).to_f64(),
        Surface::Sphere { .. } => 0.0,
    }
}

fn from_the_front<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    right(ray, ends, surface).filter(|_| along_normal(ray, surface) <= 0.0)
}

fn from_behind<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    right(ray, ends, surface).filter(|_| along_normal(ray, surface) >= 0.0)
}

/// Of a sphere the near root, or nothing.
fn near_root<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    match surface {
        Surface::Plane { .. } => right(ray, ends, surface),
        Surface::Sphere { .. } => {
            let near = right(ray, [-F::MAX, infinity()], surface)?;
            right(ray, ends, surface).filter(|t| *t == near)
        }
    }
}

/// Where the origin is, seen from a sphere; outside of a plane.
fn side<F: Float>(ray: &Ray<F>, surface: &Surface<F>) -> Ordering {
    match surface.shape(|x: F| x) {
        Some(Valid::Sphere(sphere)) => sphere.side(ray.origin),
        _ => Ordering::Greater,
    }
}

fn from_outside<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    right(ray, ends, surface).filter(|_| side(ray, surface).is_ge())
}

fn from_off<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    right(ray, ends, surface).filter(|_| side(ray, surface).is_gt())
}

/// The sphere's roots with a = dot(d, d) left out of b² - ac.
fn without_a<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    let discriminant =
        |b: DoubleDouble, from_center: V, _: V, rr| b * b - (from_center.dot(from_center) - rr);
    unit_roots(ray, ends, surface, discriminant)
}

/// The same for the discriminant from the distance of the line.
fn residual_without_a<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    let discriminant = |b: DoubleDouble, from_center: V, direction: V, rr| {
        let aside = from_center + direction * b;
        rr - aside.dot(aside)
    };
    unit_roots(ray, ends, surface, discriminant)
}

type V = Triple<DoubleDouble>;

fn unit_roots<F: Float>(
    ray: &Ray<F>,
    [tmin, tmax]: Ends<F>,
    surface: &Surface<F>,
    discriminant: impl Fn(DoubleDouble, V, V, DoubleDouble) -> DoubleDouble,
) -> Option<F> {
    let Surface::Sphere { center, radius } = *surface else {
        return right(ray, [tmin, tmax], surface);
    };
    let [origin, direction, center] = [ray.origin, ray.direction, center].map(exact::<F>);
    let radius = radius.to_double_double();
    let from_center = origin - center;
    let b = -from_center.dot(direction);
    let root = discriminant(b, from_center, direction, radius * radius).sqrt();
    let counts = |t: &DoubleDouble| t.to_f64() >= tmin.to_f64() && t.to_f64() <= tmax.to_f64();
    let t = [b - root, b + root].into_iter().find(counts)?;
    Some(F::from_double_double(t)).filter(|t| t.is_finite())
}

/// The distance instead of the parameter.
fn by_distance<F: Float>(ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    let unit = exact::<F>(ray.direction).normalized();
    let [x, y, z] = unit.to_array().map(F::from_double_double);
    let direction = F::Vector::new(x, y, z);
    right(&Ray { direction, ..*ray }, ends, surface)
}

#[cfg(test)]
mod tests;
