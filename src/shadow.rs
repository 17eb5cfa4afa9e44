//! How a shadow ray leaves its surface.

use crate::ray::{Ray, Span};
use crate::real::Real;
use crate::scene::HitRecord;

/// What keeps a shadow ray from hitting the surface it starts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shadow {
    /// Nothing: the ray starts at the rounded hit point and counts hits from 0 on. About half of the
    /// lit pixels are falsely black, whatever the precision: acne, Figure 3(a).
    SelfHitting,
    /// The origin moves 256 units in the last place along the normal: [`Ray::offset`], Figure 3(c).
    UlpOffset,
}

impl Shadow {
    /// The ray from a hit toward the light in the unit `direction`, and the part of it on which a hit
    /// blocks the light: closed, from the origin to the light's distance.
    #[inline(always)]
    pub fn ray<R: Real>(
        self,
        hit: &HitRecord<R>,
        direction: R::Vector,
        distance: R,
    ) -> (Ray<R>, Span<R>) {
        let ray = Ray {
            origin: hit.point,
            direction,
        };
        let ray = match self {
            Shadow::SelfHitting => ray,
            Shadow::UlpOffset => ray.offset(hit.normal),
        };
        (ray, Span::new(distance.constant(0.0), distance))
    }
}
