//! How a kernel is computed one precision up: lane by lane, rounded once at the end.
//!
//! A filter computes one precision up and bounds its own error. Where that cannot decide (near
//! tangency, at an end of the interval, on the surface), exact arithmetic decides. So no decision
//! is wrong, and the rare exact way costs little on average.

use super::Hit;
use crate::quality::Scale;
use crate::ray::{Ray, Span};
use crate::real::{Constant, DoubleDouble, Real, Scalar};
use crate::vector::Vector;

/// The hit at the parameter that `t` finds, lane by lane: NaN for none, else a number in the
/// interval.
#[inline(always)]
pub(super) fn one_precision_up<R: Real<Scalar: Scalar>>(
    ray: &Ray<R>,
    span: &Span<R>,
    t: impl Fn(&Ray<R::Scalar>, &Span<R::Scalar>) -> Option<R::Scalar>,
) -> Hit<R> {
    let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
    let inputs = [ox, oy, oz, dx, dy, dz, span.min, span.max];
    let t = R::each(inputs, |[ox, oy, oz, dx, dy, dz, min, max]| {
        let origin = Vector::new(ox, oy, oz);
        let direction = Vector::new(dx, dy, dz);
        let finite = [ox, oy, oz, dx, dy, dz].into_iter().all(Scalar::is_finite);
        let t = finite.then(|| t(&Ray { origin, direction }, &Span { min, max }));
        t.flatten().unwrap_or(R::Scalar::from_f64(f64::NAN))
    });
    Hit {
        mask: span.contains(t),
        t,
    }
}

/// How large a result must be, over the terms it is the sum of, for a filter to trust it: then the
/// roundings of the wide format, at most 32 units, leave the root and the quotient of such results
/// within a quarter of a unit in the last place of `S`.
pub(super) fn trust<S: Scalar>() -> f64 {
    32.0 * (4.0 * S::Wide::EPSILON) / S::EPSILON
}

/// Powers of two by which positions and directions are divided, so that neither has a component
/// above 2.
#[derive(Clone, Copy)]
pub(super) struct Units {
    size: Scale<f64>,
    along: Scale<f64>,
}

impl Units {
    /// The units of positions (and a radius) and of a direction.
    pub fn new<S: Scalar>(positions: [S::Vector; 2], radius: S, direction: S::Vector) -> Self {
        let scale = |v: S::Vector| {
            let [x, y, z] = v.to_array().map(Scalar::to_f64);
            Scale::of([x, y, z, z])
        };
        let [a, b] = positions.map(scale);
        let radius = Scale::of([radius.to_f64(); 4]);
        Self {
            size: Scale::of([a.unit, b.unit, radius.unit, radius.unit]),
            along: scale(direction),
        }
    }

    /// A position or length one precision up, in these units.
    pub fn length<S: Scalar>(&self, length: S) -> S::Wide {
        length.widen().scaled(self.size.reciprocal)
    }

    /// A position one precision up, in these units.
    pub fn position<S: Scalar>(&self, v: S::Vector) -> <S::Wide as Real>::Vector {
        let [x, y, z] = v.to_array().map(|x| self.length(x));
        Vector::new(x, y, z)
    }

    /// A direction one precision up, in these units.
    pub fn direction<S: Scalar>(&self, v: S::Vector) -> <S::Wide as Real>::Vector {
        let [x, y, z] = v
            .to_array()
            .map(|x| x.widen().scaled(self.along.reciprocal));
        Vector::new(x, y, z)
    }

    /// An interval one precision up, in these units; an end is infinite where it is too large to
    /// matter, and next to 0 where it is too small for its scale: it is not 0.
    pub fn span<S: Scalar>(&self, span: &Span<S>) -> Span<S::Wide> {
        let zero = S::from_f64(0.0);
        let parameter = |t: S| {
            let scaled = rescaled(t.widen(), self.along.unit, self.size.reciprocal);
            if scaled == S::Wide::from_f64(0.0) && t != zero {
                S::Wide::from_f64(if t < zero { -SMALL } else { SMALL })
            } else {
                scaled
            }
        };
        Span {
            min: parameter(span.min),
            max: parameter(span.max),
        }
    }

    /// The parameter of a hit in the interval, from what a filter found in these units, or else from
    /// exact arithmetic.
    pub fn parameter<S: Scalar>(
        &self,
        filtered: Option<Option<S::Wide>>,
        exact: impl FnOnce() -> Option<DoubleDouble>,
        span: &Span<S>,
    ) -> Option<S> {
        match filtered {
            Some(t) => t.map(|t| S::narrow(self.world(t))),
            None => {
                let t = self.world(exact()?);
                Some(within(S::from_double_double(t), span))
            }
        }
    }

    /// The parameter whose value in these units is `t`.
    fn world<W: Scalar>(&self, t: W) -> W {
        rescaled(t, self.size.unit, self.along.reciprocal)
    }
}

/// 2^-500, whose square is in range. Hits between 0 and it count as at 0 for an end that is lost.
const SMALL: f64 = f64::from_bits((1023 - 500) << 52);

/// `t a b` for powers of two a and b, by way of their product where that is a normal number.
fn rescaled<W: Scalar>(t: W, a: f64, b: f64) -> W {
    let factor = a * b;
    if factor.is_normal() {
        t.scaled(factor)
    } else {
        t.scaled(a).scaled(b)
    }
}

/// The end of the interval that rounding has put `t` beyond, else `t`.
fn within<S: Scalar>(t: S, span: &Span<S>) -> S {
    let t = S::select(t.lt(span.min), span.min, t);
    S::select(span.max.lt(t), span.max, t)
}

/// Where `t` lies, if its error leaves no doubt: `Some(true)` in the interval, `Some(false)`
/// outside.
pub(super) fn surely_in<W: Scalar>(t: W, span: &Span<W>, trust: f64) -> Option<bool> {
    let trust = W::from_f64(trust);
    let sure = |end: W| !end.is_finite() || (t - end).abs().gt((t.abs() + end.abs()) * trust);
    (t.is_finite() && sure(span.min) && sure(span.max)).then(|| span.min.lt(t) & t.lt(span.max))
}

#[cfg(test)]
pub(super) mod tests;
