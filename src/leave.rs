//! A shadow ray's origin that is proven to be off its surface.

use crate::float::Float;
use crate::vector::Vector;
use std::cmp::Ordering;

/// The point moved along the unit vector `normal` until it lies strictly on the wanted side of a
/// surface, as `side` tells in exact arithmetic ([`Plane::side`](crate::Plane::side),
/// [`Sphere::side`](crate::Sphere::side)). A point that is there already stays.
///
/// The way doubles from 1 unit in the last place of the largest coordinate on, so it is at most
/// twice what the error of the point calls for, give or take a rounding. Where no way helps (the
/// normal shows along the surface, or is not finite) the point is returned as it is.
pub fn leave<F: Float>(
    point: F::Vector,
    normal: F::Vector,
    side: impl Fn(F::Vector) -> Ordering,
    wanted: Ordering,
) -> F::Vector {
    let finite = |v: F::Vector| v.to_array().into_iter().all(F::is_finite);
    if !finite(point) || side(point) == wanted {
        return point;
    }
    let sizes = point.to_array().map(|x| x.to_f64().abs());
    let largest = sizes.into_iter().fold(F::MIN_POSITIVE, f64::max);
    let mut way = largest * F::EPSILON / 2.0;
    while way.is_finite() {
        let moved = point + normal * F::from_f64(way);
        if !finite(moved) {
            break;
        }
        if side(moved) == wanted {
            return moved;
        }
        way *= 2.0;
    }
    point
}
