//! The exact meeting of a ray and a sphere.

use crate::exact::{Rational, Vector, abs, dot, rational, sign, square, sub, vector};
use crate::format::Format;
use crate::plane::saturate;
use crate::ray::{Interval, PerInterval, Ray};
use crate::real::{Real, root_between};
use crate::surd::Surd;

/// The points at distance `radius` from `center`.
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere {
    /// The centre.
    pub center: Vector,
    /// Greater than 0.
    pub radius: Rational,
}

/// What is true of a ray and a sphere.
#[derive(Clone, Debug)]
pub struct SphereTruth {
    /// The sign of the discriminant: -1 the line misses, 0 it touches, 1 it crosses.
    pub disc_sign: i8,
    /// `1 - (m / radius)²`, m being the distance by which the line misses the centre: 0 at a tangent.
    pub tangent_margin: f64,
    /// The distance of the origin from the centre, over the radius.
    pub f_over_r: f64,
    /// Where the origin lies: -1 inside, 0 on the sphere, 1 outside.
    pub origin_side: i8,
    /// Both meetings of the line, the lower t first; `None` if the line misses.
    pub roots: Option<[Surd; 2]>,
    /// Which root the ray meets first in its interval, if any.
    pub root: PerInterval<Option<usize>>,
    /// The nearest hit in the closed interval, if any.
    pub hit: Option<SphereHit>,
}

/// A hit of a sphere.
#[derive(Clone, Debug)]
pub struct SphereHit {
    /// Its parameter along the ray.
    pub t: Surd,
    /// The point.
    pub p: [Surd; 3],
    /// The unit normal there, away from the centre.
    pub n_out: [Surd; 3],
    /// `|t_computed - t| <= K u bound_u |t|`, where a stable form keeps K below 9. `None` at t = 0
    /// and at a tangent.
    pub bound_u: Option<f64>,
}

impl Sphere {
    /// `None` where policy calls the sphere missed by every ray: a NaN or infinity, a radius of 0 or less.
    pub fn new(center: [f64; 3], radius: f64) -> Option<Sphere> {
        let radius = rational(radius).filter(|r| sign(r) > 0)?;
        Some(Sphere {
            center: vector(center)?,
            radius,
        })
    }

    /// -1 for a point inside, 0 on the sphere, 1 outside.
    pub fn side(&self, x: &[Surd; 3]) -> i8 {
        (&Surd::norm(&self.from_center(x)) - &Surd::from(square(&self.radius))).sign()
    }

    /// `x - center`.
    pub fn from_center(&self, x: &[Surd; 3]) -> [Surd; 3] {
        std::array::from_fn(|i| &x[i] - &Surd::from(self.center[i].clone()))
    }

    /// Where a ray meets the sphere.
    pub fn meet(&self, ray: &Ray) -> SphereTruth {
        let quadratic = Quadratic::new(self, ray);
        let roots = quadratic.roots();
        let first =
            |interval: Interval| roots.as_ref()?.iter().position(|t| ray.admits(t, interval));
        let root = PerInterval::of(first);
        let hit = roots
            .as_ref()
            .zip(root.closed)
            .map(|(roots, which)| self.hit(ray, &quadratic, which, &roots[which]));
        let radius2 = square(&self.radius);
        let margin = &quadratic.discriminant / (&quadratic.dd * &radius2);
        SphereTruth {
            disc_sign: sign(&quadratic.discriminant),
            tangent_margin: saturate(Format::F64.round(&margin)),
            f_over_r: saturate(
                Real::root(1, Surd::from(&quadratic.ff / radius2)).round(Format::F64),
            ),
            origin_side: sign(&quadratic.constant),
            roots,
            root,
            hit,
        }
    }

    /// Both meetings of the ray's line, each with its bound ([`SphereHit::bound_u`]); `None` if the line misses.
    pub fn bounded_roots(&self, ray: &Ray) -> Option<[(Surd, Option<f64>); 2]> {
        let quadratic = Quadratic::new(self, ray);
        let bounded = |which: usize, t: Surd| {
            let bound = (t.sign() != 0).then(|| quadratic.bound(which)).flatten();
            (t, bound)
        };
        let [near, far] = quadratic.roots()?;
        Some([bounded(0, near), bounded(1, far)])
    }

    fn hit(&self, ray: &Ray, quadratic: &Quadratic, which: usize, t: &Surd) -> SphereHit {
        let p = ray.at(t);
        let inverse = Rational::ONE / &self.radius;
        SphereHit {
            n_out: self.from_center(&p).map(|x| x.scale(&inverse)),
            bound_u: (t.sign() != 0).then(|| quadratic.bound(which)).flatten(),
            t: t.clone(),
            p,
        }
    }
}

/// `dd t² - 2 half_b t + constant = 0`, with f = center - origin.
struct Quadratic {
    /// `dot(direction, direction)`
    dd: Rational,
    /// `dot(f, direction)`
    half_b: Rational,
    /// `dot(f, f)`
    ff: Rational,
    /// `dot(f, f) - radius²`
    constant: Rational,
    /// `half_b² - dd constant`
    discriminant: Rational,
}

impl Quadratic {
    fn new(sphere: &Sphere, ray: &Ray) -> Quadratic {
        let f = sub(&sphere.center, &ray.origin);
        let (dd, half_b, ff) = (
            dot(&ray.direction, &ray.direction),
            dot(&f, &ray.direction),
            dot(&f, &f),
        );
        let constant = &ff - square(&sphere.radius);
        let discriminant = square(&half_b) - &dd * &constant;
        Quadratic {
            dd,
            half_b,
            ff,
            constant,
            discriminant,
        }
    }

    fn roots(&self) -> Option<[Surd; 2]> {
        let root = |sign: i32| {
            let factor = Rational::from(sign) / &self.dd;
            Surd::new(&self.half_b / &self.dd, factor, self.discriminant.clone())
        };
        (sign(&self.discriminant) >= 0).then(|| [root(-1), root(1)])
    }

    /// With b the distance along the ray to the point nearest the centre, m the distance there, h half the chord,
    /// f the distance of the centre and q = |b| + h: the root at distance q has `2 + f/q + g`, the other, which a stable
    /// form finds as c/q with c = f² - r², has `1 + 2 f²/|c| + f/q + g`, where `g = m (f + m) / (h q)`.
    fn bound(&self, which: usize) -> Option<f64> {
        if sign(&self.discriminant) == 0 {
            return None;
        }
        // Sums and quotients of positive terms: 256 bits of each leave far more than the 53 that are kept.
        let root = |x: &Rational| root_between(x, 256).0;
        let b = sign(&self.half_b);
        // f, m, h and q times |direction|, which cancels.
        let f2 = &self.ff * &self.dd;
        let (f, m, h) = (
            root(&f2),
            root(&(f2 - square(&self.half_b))),
            root(&self.discriminant),
        );
        let q = abs(self.half_b.clone()) + &h;
        let shared = &f / &q + &m * (&f + &m) / (&h * &q);
        let far = b == 0 || (b > 0) == (which == 1);
        let own = if far {
            Rational::from(2)
        } else {
            Rational::ONE + Rational::from(2) * &self.ff / abs(self.constant.clone())
        };
        Some(saturate(Format::F64.round(&(own + shared))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn meet(z: f64, radius: f64) -> SphereTruth {
        let ray = Ray::new([0.0, 1.0, z], [0.0, 0.0, 2.0], 0.0, f64::INFINITY).unwrap();
        Sphere::new([0.0; 3], radius).unwrap().meet(&ray)
    }

    #[test]
    fn an_exact_tangent_is_a_hit() {
        let truth = meet(-4.0, 1.0);
        assert_eq!(
            (truth.disc_sign, truth.tangent_margin, truth.root.open),
            (0, 0.0, Some(0))
        );
        assert_eq!(truth.hit.unwrap().bound_u, None);
        assert_eq!(meet(-4.0, Format::F64.step(1.0, -1)).disc_sign, -1);
        assert_eq!(meet(-4.0, Format::F64.step(1.0, 1)).disc_sign, 1);
    }

    #[test]
    fn normals_have_length_one() {
        let hit = meet(-5.0, 3.0).hit.unwrap();
        assert_eq!(Surd::norm(&hit.n_out), Surd::from(Rational::ONE));
        assert_eq!(
            hit.t.compare(&Surd::from(Rational::ONE)),
            std::cmp::Ordering::Greater
        );
    }

    #[test]
    fn policy() {
        assert!(Sphere::new([0.0; 3], 0.0).is_none());
        assert!(Sphere::new([0.0; 3], -1.0).is_none());
        assert!(Sphere::new([0.0; 3], f64::NAN).is_none());
    }
}
