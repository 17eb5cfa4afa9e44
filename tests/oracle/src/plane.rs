//! The exact meeting of a ray and a plane.

use crate::exact::{Rational, Vector, abs, dot, sign, sub, vector};
use crate::format::Format;
use crate::ray::{PerInterval, Ray};
use crate::surd::Surd;

/// The points x with `dot(x - point, normal) = 0`; the normal need not be of length 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub point: Vector,
    /// Not zero.
    pub normal: Vector,
}

/// What is true of a ray and a plane.
#[derive(Clone, Debug)]
pub struct PlaneTruth {
    /// The sign of `dot(point - origin, normal)`.
    pub num_sign: i8,
    /// The sign of `dot(direction, normal)`; 0 if the ray is parallel.
    pub den_sign: i8,
    /// Where the line meets the plane, on the ray or not; `None` if it is parallel.
    pub t: Option<Rational>,
    /// The point there.
    pub p: Option<Vector>,
    /// Whether `t` lies in the ray's interval.
    pub hit: PerInterval<bool>,
    /// The condition number of `dot(point - origin, normal)`: the sum of the magnitudes of its terms over its own. `None` if it is 0.
    pub kappa_num: Option<f64>,
    /// The condition number of `dot(direction, normal)`; `None` if it is 0.
    pub kappa_den: Option<f64>,
    /// `4 kappa_num + 3 kappa_den + 1`: a bound, in units of u|t|, on the error of `dot(point - origin, normal) / dot(direction, normal)`.
    pub bound_u: Option<f64>,
}

impl Plane {
    /// `None` where policy calls the plane missed by every ray: a NaN or infinite coordinate, a zero normal.
    pub fn new(point: [f64; 3], normal: [f64; 3]) -> Option<Plane> {
        let normal = vector(normal).filter(|n| n.iter().any(|x| sign(x) != 0))?;
        Some(Plane {
            point: vector(point)?,
            normal,
        })
    }

    /// `dot(x - point, normal)`: positive on the side the normal points to.
    pub fn side(&self, x: &[Surd; 3]) -> Surd {
        &Surd::dot_rational(x, &self.normal) - &Surd::from(dot(&self.point, &self.normal))
    }

    /// Where a ray meets the plane.
    pub fn meet(&self, ray: &Ray) -> PlaneTruth {
        let offset = sub(&self.point, &ray.origin);
        let (num, den) = (
            dot(&offset, &self.normal),
            dot(&ray.direction, &self.normal),
        );
        let t = (sign(&den) != 0).then(|| &num / &den);
        let at = t.clone().map(Surd::from);
        let kappa_num = condition(&offset, &self.normal, &num);
        let kappa_den = condition(&ray.direction, &self.normal, &den);
        PlaneTruth {
            num_sign: sign(&num),
            den_sign: sign(&den),
            hit: PerInterval::of(|interval| at.as_ref().is_some_and(|t| ray.admits(t, interval))),
            p: t.as_ref()
                .map(|t| std::array::from_fn(|i| &ray.origin[i] + t * &ray.direction[i])),
            t,
            kappa_num,
            kappa_den,
            bound_u: kappa_num
                .zip(kappa_den)
                .map(|(num, den)| saturate(4.0 * num + 3.0 * den + 1.0)),
        }
    }
}

/// The sum of the magnitudes of the terms of `dot(a, b)`, over that of their sum.
fn condition(a: &Vector, b: &Vector, sum: &Rational) -> Option<f64> {
    let term = |i: usize| abs(&a[i] * &b[i]);
    let terms = term(0) + term(1) + term(2);
    (sign(sum) != 0).then(|| saturate(Format::F64.round(&(terms / abs(sum.clone())))))
}

/// A diagnostic too large for an `f64` reads ±1e308.
pub(crate) fn saturate(x: f64) -> f64 {
    if x.is_infinite() {
        1e308_f64.copysign(x)
    } else {
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_interval() {
        let plane = Plane::new([0.0, -2.0, 0.0], [0.0, 3.0, 0.0]).unwrap();
        let at = |tmin, tmax| {
            plane
                .meet(&Ray::new([0.0; 3], [0.0, -1.0, 0.0], tmin, tmax).unwrap())
                .hit
        };
        assert_eq!(
            at(0.0, f64::INFINITY),
            PerInterval {
                closed: true,
                half: true,
                open: true
            }
        );
        assert_eq!(
            at(0.0, 2.0),
            PerInterval {
                closed: true,
                half: true,
                open: false
            }
        );
        assert_eq!(
            at(2.0, 3.0),
            PerInterval {
                closed: true,
                half: false,
                open: false
            }
        );
        assert_eq!(
            at(3.0, 2.0),
            PerInterval {
                closed: false,
                half: false,
                open: false
            }
        );
    }

    #[test]
    fn parallel_by_exact_cancellation() {
        let (third, tenth) = (f64::from(0.3_f32), f64::from(0.1_f32));
        let plane = Plane::new([0.0; 3], [third, -tenth, 0.0]).unwrap();
        let truth = plane.meet(&Ray::new([0.0, 1.0, 0.0], [tenth, third, 0.0], 0.0, 9.0).unwrap());
        assert_eq!((truth.den_sign, truth.num_sign, truth.t), (0, 1, None));
    }

    #[test]
    fn policy() {
        assert!(Plane::new([0.0; 3], [0.0, -0.0, 0.0]).is_none());
        assert!(Plane::new([f64::INFINITY, 0.0, 0.0], [0.0, 1.0, 0.0]).is_none());
        assert!(Ray::new([0.0; 3], [0.0; 3], 0.0, 1.0).is_none());
        assert!(Ray::new([0.0; 3], [1.0; 3], f64::NAN, 1.0).is_none());
        assert!(Ray::new([0.0; 3], [1.0; 3], 0.0, f64::NEG_INFINITY).is_none());
    }
}
