//! The sphere one precision up: never a wrong decision.

use super::super::wide::{Units, surely_in, trust};
use crate::ray::{Ray, Span};
use crate::real::expansion::{Exact3, Expansion, along, cross, difference, dot, exact3};
use crate::real::{DoubleDouble, Real, Scalar};
use crate::vector::Vector;
use std::cmp::Ordering;

/// A ray and a sphere one precision up, scaled so that no component is above 2.
struct Question<W: Scalar> {
    origin: W::Vector,
    direction: W::Vector,
    center: W::Vector,
    radius: W,
    span: Span<W>,
}

/// The parameter of the nearest hit in the interval: the decision as in exact arithmetic, the number
/// within 1 unit in the last place.
pub(super) fn wide_t<S: Scalar>(
    ray: &Ray<S>,
    span: &Span<S>,
    center: S::Vector,
    radius: S,
) -> Option<S> {
    let units = Units::new([ray.origin, center], radius, ray.direction);
    let question = Question {
        origin: units.position::<S>(ray.origin),
        direction: units.direction::<S>(ray.direction),
        center: units.position::<S>(center),
        radius: units.length(radius),
        span: units.span(span),
    };
    units.parameter(question.filtered(trust::<S>()), || question.exact(), span)
}

/// On which side of the sphere a point lies, in exact arithmetic.
pub(super) fn side<S: Scalar>(point: S::Vector, center: S::Vector, radius: S) -> Ordering {
    let units = Units::new([point, center], radius, point);
    let [point, center] = [point, center].map(|v| exact3::<S::Wide>(units.position::<S>(v)));
    let radius = Expansion::from(units.length(radius));
    let from_center = difference(&point, &center);
    (&dot(&from_center, &from_center) - &(&radius * &radius)).sign()
}

impl<W: Scalar> Question<W> {
    /// The answer, or `None` where rounding leaves a doubt.
    ///
    /// The discriminant is Lagrange's: `(f·d)² - d²(f² - r²) = d² r² - |f x d|²`.
    fn filtered(&self, trust: f64) -> Option<Option<W>> {
        let (zero, trusted) = (W::from_f64(0.0), W::from_f64(trust));
        let d = self.direction;
        let f = self.origin - self.center;
        let (a, b) = (d.dot(d), -f.dot(d));
        let (ff, rr) = (f.dot(f), self.radius * self.radius);
        let moment = f.cross(d);
        let discriminant = a * rr - moment.dot(moment);
        let noise = a * rr + noise::<W>(f, d, moment, trusted);
        if !discriminant.abs().gt(noise * trusted) {
            return None;
        }
        if discriminant.lt(zero) {
            return Some(None);
        }
        let c = ff - rr;
        if !c.abs().gt((ff + rr) * trusted) {
            return None;
        }
        let root = discriminant.sqrt();
        let ahead = b.ge(zero);
        let q = if ahead { b + root } else { b - root };
        let (first, second) = (c / q, q / a);
        let (near, far) = if ahead {
            (first, second)
        } else {
            (second, first)
        };
        if surely_in(near, &self.span, trust)? {
            return Some(Some(near));
        }
        Some(surely_in(far, &self.span, trust)?.then_some(far))
    }

    /// The answer where every decision is exact, and the number is right to about 2^-100.
    fn exact(&self) -> Option<DoubleDouble> {
        let direction = exact3::<W>(self.direction);
        let from_center = difference(&exact3::<W>(self.origin), &exact3::<W>(self.center));
        let radius = Expansion::from(self.radius);
        let rr = &radius * &radius;
        let a = dot(&direction, &direction);
        let moment = cross(&from_center, &direction);
        let discriminant = &(&a * &rr) - &dot(&moment, &moment);
        if discriminant.sign().is_lt() {
            return None;
        }
        let place = |t: W| place(t, &from_center, &direction, &rr);
        let (min, max) = (place(self.span.min), place(self.span.max));
        let near_counts = min.near.is_ge() && max.near.is_le();
        let far_counts = min.far.is_ge() && max.far.is_le();
        if !(near_counts || far_counts) {
            return None;
        }
        let a = a.round();
        let b = -dot(&from_center, &direction).round();
        let c = (&dot(&from_center, &from_center) - &rr).round();
        let root = discriminant.round().sqrt();
        let zero = DoubleDouble::from_f64(0.0);
        let ahead = b >= zero;
        let q = if ahead { b + root } else { b - root };
        if c == zero && near_counts == ahead {
            return Some(zero);
        }
        Some(if near_counts == ahead { c / q } else { q / a })
    }
}

/// The sizes of the terms of `|f x d|²`, whose components are themselves differences of terms.
fn noise<W: Scalar>(f: W::Vector, d: W::Vector, moment: W::Vector, trusted: W) -> W {
    let [fx, fy, fz] = f.abs().to_array();
    let [dx, dy, dz] = d.abs().to_array();
    let terms = W::Vector::new(fy * dz + fz * dy, fz * dx + fx * dz, fx * dy + fy * dx);
    moment.abs().dot(terms) + terms.dot(terms) * trusted
}

/// How the two roots compare with a parameter.
struct Place {
    near: Ordering,
    far: Ordering,
}

/// Compares the roots of a line that meets the sphere with t, by the point there: outside and still
/// approaching, both roots are above; outside and leaving, both below; inside, t is between them.
fn place<W: Scalar>(t: W, from_center: &Exact3, direction: &Exact3, rr: &Expansion) -> Place {
    // No root is above |f| + r over |d|, at most 7 + 2 in scaled units.
    let beyond = W::from_f64(16.0);
    if t.abs().gt(beyond) {
        let order = if t.gt(beyond) {
            Ordering::Less
        } else {
            Ordering::Greater
        };
        return Place {
            near: order,
            far: order,
        };
    }
    let point = along(from_center, &Expansion::from(t), direction);
    let leaving = dot(&point, direction).sign();
    match (&dot(&point, &point) - rr).sign() {
        Ordering::Greater => Place {
            near: leaving.reverse(),
            far: leaving.reverse(),
        },
        Ordering::Equal => Place {
            near: leaving.reverse().min(Ordering::Equal),
            far: leaving.reverse().max(Ordering::Equal),
        },
        Ordering::Less => Place {
            near: Ordering::Less,
            far: Ordering::Greater,
        },
    }
}

#[cfg(test)]
mod tests;
