//! How near a decision is to being another one.

use crate::conformance::{Ends, Surface};
use crate::float::Float;
use crate::ray::Ray;
use crate::real::Scalar;
use crate::vector::Vector;
use ombrage_oracle::error::in_units;
use ombrage_oracle::{Format, Plane, Ray as ExactRay, Real, Sphere};

/// The oracle's name of the format.
pub(super) fn format<F: Float>() -> Format {
    if F::PRECISION == f32::MANTISSA_DIGITS {
        Format::F32
    } else {
        Format::F64
    }
}

/// Three floats as the oracle takes them.
pub(super) fn doubles<F: Float>(v: F::Vector) -> [f64; 3] {
    v.to_array().map(Scalar::to_f64)
}

/// Whether an error of `k` times the a-priori bound may change what the ray hits of the surface: a
/// root is as near as that to an end of the interval, or the line as near to tangency.
///
/// With f the distance of the origin from the center and m that of the line, a stable form knows m
/// to k u (f + m), so the margin 1 - (m/r)² to what that makes of the square. A root of exactly 0
/// and a parallel ray have no bound, and are near only to an end of 0 and to any.
pub(super) fn is_marginal<F: Float>(
    ray: &Ray<F>,
    [tmin, tmax]: Ends<F>,
    surface: &Surface<F>,
    k: f64,
) -> bool {
    let (tmin, tmax) = (tmin.to_f64(), tmax.to_f64());
    let (origin, direction) = (doubles::<F>(ray.origin), doubles::<F>(ray.direction));
    let Some(exact) = ExactRay::new(origin, direction, tmin, tmax) else {
        return false;
    };
    let format = format::<F>();
    let near = |t: &Real, bound: Option<f64>| {
        let reach = k * bound.unwrap_or(0.0);
        [tmin, tmax]
            .into_iter()
            .any(|end| end.is_finite() && in_units(end, t, format) <= reach)
    };
    match *surface {
        Surface::Plane { point, normal } => {
            let Some(plane) = Plane::new(doubles::<F>(point), doubles::<F>(normal)) else {
                return false;
            };
            let truth = plane.meet(&exact);
            truth.t.is_none_or(|t| near(&Real::from(t), truth.bound_u))
        }
        Surface::Sphere { center, radius } => {
            let Some(sphere) = Sphere::new(doubles::<F>(center), radius.to_f64()) else {
                return false;
            };
            let truth = sphere.meet(&exact);
            let miss = (1.0 - truth.tangent_margin).max(0.0).sqrt();
            let residual = k * format.unit_roundoff() * (truth.f_over_r + miss);
            truth.tangent_margin.abs() <= (2.0 * miss + residual) * residual
                || sphere.bounded_roots(&exact).is_some_and(|roots| {
                    roots
                        .into_iter()
                        .any(|(t, bound)| near(&Real::from(t), bound))
                })
        }
    }
}
