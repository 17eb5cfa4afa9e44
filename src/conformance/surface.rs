//! Objects and intervals as questions give them: valid or not.

use crate::float::Float;
use crate::ray::{Ray, Span};
use crate::real::Scalar;
use crate::shape::{Plane, Sphere};
use crate::vector::Vector;

/// An object as a question gives it. One that no scene can have is missed by every ray.
#[derive(Clone, Copy, Debug)]
pub enum Surface<F: Float> {
    /// A plane through a point, with a normal of any length but zero.
    Plane {
        /// A point of the plane.
        point: F::Vector,
        /// At a right angle to it.
        normal: F::Vector,
    },
    /// A sphere.
    Sphere {
        /// Its center.
        center: F::Vector,
        /// Its radius, above zero.
        radius: F,
    },
}

/// A shape that scenes can have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Valid<S: Scalar> {
    Plane(Plane<S>),
    Sphere(Sphere<S>),
}

impl<F: Float> Surface<F> {
    /// The shape, one precision up or as it is; `None` where it is not valid.
    pub(super) fn shape<S: Scalar>(&self, number: impl Fn(F) -> S) -> Option<Valid<S>> {
        let vector = |v: F::Vector| {
            let [x, y, z] = v.to_array().map(&number);
            S::Vector::new(x, y, z)
        };
        match *self {
            Surface::Plane { point, normal } => Plane::new(vector(point), vector(normal))
                .ok()
                .map(Valid::Plane),
            Surface::Sphere { center, radius } => Sphere::new(vector(center), number(radius))
                .ok()
                .map(Valid::Sphere),
        }
    }
}

/// The ends of an interval as a question gives them: `[tmin, tmax]`.
pub type Ends<F> = [F; 2];

/// The interval, where the ray can hit anything: origin, direction and `tmin` are finite, the
/// direction is not zero, and `tmax` is finite or +∞.
pub(super) fn interval<F: Float>(ray: &Ray<F>, [tmin, tmax]: Ends<F>) -> Option<Span<F>> {
    let finite = |v: F::Vector| v.to_array().into_iter().all(F::is_finite);
    let moves = ray.direction != F::Vector::constant((), [0.0; 3]);
    let ends = tmin.is_finite() && (tmax.is_finite() || tmax.to_f64() == f64::INFINITY);
    (finite(ray.origin) && finite(ray.direction) && moves && ends).then(|| Span::new(tmin, tmax))
}
