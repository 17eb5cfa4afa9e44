//! How a kernel is computed one precision up: lane by lane, rounded once at the end.

use super::Hit;
use crate::ray::{Ray, Span};
use crate::real::{Real, Scalar};
use crate::vector::Vector;

/// The hit at the parameter that `t` finds, lane by lane: NaN for none, else a number in the
/// interval.
#[inline(always)]
pub(super) fn one_precision_up<R: Real>(
    ray: &Ray<R>,
    span: &Span<R>,
    t: impl Fn(&Ray<R::Scalar>, &Span<R::Scalar>) -> R::Scalar,
) -> Hit<R> {
    let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
    let inputs = [ox, oy, oz, dx, dy, dz, span.min, span.max];
    let t = R::each(inputs, |[ox, oy, oz, dx, dy, dz, min, max]| {
        let origin = Vector::new(ox, oy, oz);
        let direction = Vector::new(dx, dy, dz);
        t(&Ray { origin, direction }, &Span { min, max })
    });
    Hit {
        mask: span.contains(t),
        t,
    }
}

/// The same vector one precision up, exactly.
pub(super) fn widen<S: Scalar>(vector: S::Vector) -> <S::Wide as Real>::Vector {
    let [x, y, z] = vector.to_array().map(Scalar::widen);
    Vector::new(x, y, z)
}

/// The same ray one precision up, exactly.
pub(super) fn widen_ray<S: Scalar>(ray: &Ray<S>) -> Ray<S::Wide> {
    Ray {
        origin: widen::<S>(ray.origin),
        direction: widen::<S>(ray.direction),
    }
}
