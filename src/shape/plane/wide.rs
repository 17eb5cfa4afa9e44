//! The plane one precision up: never a wrong decision.

use super::super::wide::{Units, surely_in, trust};
use crate::ray::{Ray, Span};
use crate::real::expansion::{Expansion, cross, difference, dot, exact3};
use crate::real::{DoubleDouble, Scalar};
use crate::vector::Vector;
use std::cmp::Ordering;

/// 2^600, and 2^300, whose products with numbers of about 1 are in range.
const LARGE: f64 = f64::from_bits((1023 + 600) << 52);
const FAR: f64 = f64::from_bits((1023 + 300) << 52);

/// A ray and a plane one precision up, scaled so that no component is above 2.
struct Question<W: Scalar> {
    origin: W::Vector,
    direction: W::Vector,
    point: W::Vector,
    normal: W::Vector,
    span: Span<W>,
}

/// The parameter of the hit: the decision as in exact arithmetic, the number within 1 unit in the last
/// place.
pub(super) fn wide_t<S: Scalar>(
    ray: &Ray<S>,
    span: &Span<S>,
    point: S::Vector,
    normal: S::Vector,
) -> Option<S> {
    let zero = S::from_f64(0.0);
    let units = Units::new([ray.origin, point], zero, ray.direction);
    let question = Question {
        origin: units.position::<S>(ray.origin),
        direction: units.direction::<S>(ray.direction),
        point: units.position::<S>(point),
        normal: Units::new([normal; 2], zero, normal).direction::<S>(normal),
        span: units.span(span),
    };
    units.parameter(question.filtered(trust::<S>()), || question.exact(), span)
}

/// On which side of the plane a point lies, in exact arithmetic.
pub(super) fn side<S: Scalar>(point: S::Vector, on: S::Vector, normal: S::Vector) -> Ordering {
    let units = Units::new([point, on], S::from_f64(0.0), normal);
    let [point, on] = [point, on].map(|v| exact3::<S::Wide>(units.position::<S>(v)));
    dot(
        &difference(&point, &on),
        &exact3::<S::Wide>(units.direction::<S>(normal)),
    )
    .sign()
}

/// Whether two vectors are, in exact arithmetic.
pub(super) fn are_parallel<S: Scalar>(a: S::Vector, b: S::Vector) -> bool {
    let exactly = |v: S::Vector| {
        let units = Units::new::<S>([v; 2], S::from_f64(0.0), v);
        exact3::<S::Wide>(units.direction::<S>(v))
    };
    let product = cross(&exactly(a), &exactly(b));
    product.iter().all(|x| x.sign() == Ordering::Equal)
}

impl<W: Scalar> Question<W> {
    /// The answer, or `None` where rounding leaves a doubt.
    fn filtered(&self, trust: f64) -> Option<Option<W>> {
        let trusted = W::from_f64(trust);
        let (to_point, normal) = (self.point - self.origin, self.normal);
        let height = to_point.dot(normal);
        let slope = self.direction.dot(normal);
        let sizes = normal.abs();
        let sure = height.abs().gt(to_point.abs().dot(sizes) * trusted)
            & slope.abs().gt(self.direction.abs().dot(sizes) * trusted);
        if !sure {
            return None;
        }
        let t = height / slope;
        Some(surely_in(t, &self.span, trust)?.then_some(t))
    }

    /// The answer where every decision is exact, and the number is right to about 2^-100.
    fn exact(&self) -> Option<DoubleDouble> {
        // Far above 1, so that products of components that are far below it are kept.
        let [x, y, z] = self.normal.to_array().map(|n| n.scaled(LARGE));
        let normal = exact3::<W>(W::Vector::new(x, y, z));
        let to_point = difference(&exact3::<W>(self.point), &exact3::<W>(self.origin));
        let height = dot(&to_point, &normal);
        let slope = dot(&exact3::<W>(self.direction), &normal);
        let parameter = height.round() / slope.round();
        // Where the hit lies, seen from t.
        let order = |t: W| {
            if t.abs().gt(W::from_f64(FAR)) {
                let order = parameter.partial_cmp(&t.to_double_double());
                return order.unwrap_or(Ordering::Less);
            }
            let above = (&height - &(&Expansion::from(t) * &slope)).sign();
            if slope.sign().is_lt() {
                above.reverse()
            } else {
                above
            }
        };
        let hit =
            slope.sign().is_ne() && order(self.span.min).is_ge() && order(self.span.max).is_le();
        hit.then_some(parameter)
    }
}

#[cfg(test)]
mod tests;
