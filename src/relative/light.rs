//! A light, seen from the camera, and what stands between it and a point.

use super::Nearest;
use crate::real::{Constant, Mask, Real, Scalar};
use crate::vector::Vector;

/// A light that no surface separates from the camera.
#[derive(Clone, Debug)]
pub(super) struct Light<S: Constant> {
    pub position: S::Vector,
    /// Colour times power.
    pub intensity: S::Vector,
    /// Its height above each plane, by the plane's number: ascending, and above every sphere's.
    pub heights: Vec<(S, S)>,
    /// The spheres to which it is much nearer than to the camera.
    pub near: Vec<Near<S>>,
    /// The spheres that may stand before it; none where shadows are off.
    pub occluders: Vec<Occluder<S>>,
    /// Half-spaces of directions in which a surface through the camera itself blocks the light:
    /// those with a positive product.
    pub edges: Vec<S::Vector>,
}

/// A sphere much nearer to a light than the camera is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near<S: Constant> {
    pub number: S,
    /// From the center to the light.
    pub to_light: S::Vector,
    /// Negative where the normal that faces the camera points inward.
    pub radius: S,
}

/// A sphere with the camera and a light outside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Occluder<S: Constant> {
    pub center: S::Vector,
    pub radius_squared: S,
    pub number: S,
    /// From the center to the light, and its square.
    pub to_light: S::Vector,
    pub to_light_squared: S,
}

impl<S: Constant> Light<S> {
    /// How high the light is above the tangent plane of the hit: where it is not above 0, the hit
    /// turns away from it.
    ///
    /// With N the normal it is `dot(N, L)`, L the way to the light, which is known without the hit
    /// point: `dot(N, light) + t slope`, and for planes a constant. Far from the camera that sum
    /// cancels; for a sphere near the light it is `dot(N, center to light) - radius`.
    #[inline(always)]
    pub fn height<R: Real<Scalar = S>>(&self, hit: &Nearest<R>) -> R {
        let token = hit.meeting.t.token();
        let position = R::Vector::splat(token, &self.position);
        let mut height = hit.normal.dot(position) + hit.meeting.t * hit.meeting.slope;
        for &(number, constant) in &self.heights {
            let from_here_on = hit.meeting.number.ge(R::splat(token, number));
            height = R::select(from_here_on, R::splat(token, constant), height);
        }
        for near in &self.near {
            let above = hit.normal.dot(R::Vector::splat(token, &near.to_light));
            let above = above - R::splat(token, near.radius);
            height = R::select(hit.meeting.is_with(near.number), above, height);
        }
        height
    }

    /// Adds to `sum` what the hit point sends back of this light.
    ///
    /// With N the normal and L the way to the light, `color * intensity / L² * dot(N, L) / |L|`.
    #[inline(always)]
    pub fn add<R: Real<Scalar = S>>(
        &self,
        sum: R::Vector,
        hit: &Nearest<R>,
        direction: R::Vector,
    ) -> R::Vector {
        let token = hit.meeting.t.token();
        let zero = hit.meeting.t.constant(0.0);
        let height = self.height(hit);
        let facing = hit.meeting.mask & height.gt(zero);
        if !facing.any() {
            return sum;
        }
        let point = direction * hit.meeting.t;
        let to_light = R::Vector::splat(token, &self.position) - point;
        let square = to_light.square();
        let visible = facing & !self.blocked(hit, direction, point, square);
        let y = square.inverse_root();
        let intensity = R::Vector::splat(token, &self.intensity);
        let lit = sum + hit.color * intensity * (height * y * (y * y));
        R::Vector::select(visible, lit, sum)
    }

    /// Whether something stands between the hit and the light.
    pub fn blocked_on_the_way(&self, hit: &Nearest<S>, direction: S::Vector) -> bool
    where
        S: Scalar,
    {
        let point = direction * hit.meeting.t;
        let to_light = self.position - point;
        self.blocked(hit, direction, point, to_light.square())
    }

    /// Whether something stands between the point and the light, at distance `√square` of each
    /// other.
    #[inline(always)]
    fn blocked<R: Real<Scalar = S>>(
        &self,
        hit: &Nearest<R>,
        direction: R::Vector,
        point: R::Vector,
        square: R,
    ) -> R::Mask {
        let token = square.token();
        let mut blocked = R::never(token);
        for &edge in &self.edges {
            let beyond = R::Vector::splat(token, &edge).dot(direction);
            blocked = blocked | beyond.gt(beyond.constant(0.0));
        }
        for occluder in &self.occluders {
            if let Some(blocks) = occluder.blocks(point, square) {
                blocked = blocked | (blocks & !hit.meeting.is_with(occluder.number));
            }
        }
        blocked
    }
}

impl<S: Constant> Occluder<S> {
    /// Whether the sphere reaches into the way from `point` to the light, of squared length
    /// `square`.
    ///
    /// With p and l from the center to either end, the line passes at distance `|p x l| / |l - p|`,
    /// and the nearest point lies between the ends where `dot(p, l)` is below both p² and l². A way
    /// that only touches the sphere is blocked: a tangent ray hits. `None` if no lane's line passes
    /// through.
    #[inline(always)]
    fn blocks<R: Real<Scalar = S>>(&self, point: R::Vector, square: R) -> Option<R::Mask> {
        let token = square.token();
        let to_point = point - R::Vector::splat(token, &self.center);
        let to_light = R::Vector::splat(token, &self.to_light);
        let (product, moment_squared) = to_point.products(to_light);
        let near = moment_squared.le(R::splat(token, self.radius_squared) * square);
        if !near.any() {
            return None;
        }
        let before = product.lt(to_point.square());
        Some(near & before & product.lt(R::splat(token, self.to_light_squared)))
    }
}
