//! A sphere, seen from the camera.

use super::Meeting;
use crate::real::{Constant, Mask, Real};
use crate::vector::Vector;
use std::cmp::Ordering;

/// A sphere around `center`, relative to the camera.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sphere<S: Constant> {
    pub center: S::Vector,
    pub radius_squared: S,
    /// 1 / radius, negative where the normal that faces the camera points inward.
    pub curvature: S,
    /// The power of the camera: `|center|² - radius²`.
    pub power: S,
    /// Its sign, exactly: the camera is outside where it is greater, inside where it is less.
    pub camera: Ordering,
    pub number: S,
    pub color: S::Vector,
}

impl<S: Constant> Sphere<S> {
    /// Where a ray from the camera meets the sphere; `None` if no lane does.
    ///
    /// From outside the near root is `power / (b + √disc)`, from inside or on the sphere the far
    /// one `(b + √disc) / D²`: neither subtracts.
    #[inline(always)]
    pub fn meet<R: Real<Scalar = S>>(
        &self,
        direction: R::Vector,
        square: R,
        t_max_squared: R,
        endless: bool,
    ) -> Option<Meeting<R>> {
        let token = square.token();
        let zero = square.constant(0.0);
        let center = R::Vector::splat(token, &self.center);
        let (ahead, moment_squared) = center.products(direction);
        let discriminant = R::splat(token, self.radius_squared) * square - moment_squared;
        let mut mask = discriminant.ge(zero);
        if self.camera != Ordering::Less {
            mask = mask & ahead.gt(zero);
        }
        if !mask.any() {
            return None;
        }
        let root = discriminant.sqrt();
        let t = if self.camera == Ordering::Greater {
            R::splat(token, self.power) / (ahead + root)
        } else {
            (ahead + root) / square
        };
        if !endless {
            mask = mask & (t * t * square).le(t_max_squared);
        }
        Some(Meeting {
            mask,
            t,
            slope: root * R::splat(token, self.curvature).abs(),
            number: R::splat(token, self.number),
        })
    }

    /// The unit normal on the camera's side, where the ray meets the sphere.
    #[inline(always)]
    pub fn normal<R: Real<Scalar = S>>(&self, direction: R::Vector, t: R) -> R::Vector {
        let token = t.token();
        let center = R::Vector::splat(token, &self.center);
        (direction * t - center) * R::splat(token, self.curvature)
    }
}
