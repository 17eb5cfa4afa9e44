//! How a shadow ray leaves its surface: every known strategy of the lab's chain.
//!
//! The point a shadow ray starts from is rounded, so it lies a little above or below its surface,
//! and the ray may hit what it starts on. Every strategy here trades that acne against shadows that
//! are lost or displaced. The kit's default, [`Relative`](crate::Relative), needs none of them.

use crate::ray::{Ray, Span};
use crate::real::{Constant, Real, Scalar};
use crate::scene::{HitRecord, Scene};
use crate::shape::Projection;
use crate::vector::Vector;

/// What keeps a shadow ray from hitting the surface it starts on. Lengths are in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shadow {
    /// Nothing: the ray starts at the rounded hit point and hits count from 0 on. Half to nine
    /// tenths of the lit pixels are falsely black, whatever the precision: acne, Figure 3(a).
    SelfHitting,
    /// Nothing, but a hit at exactly 0 does not count. Cures points that lie exactly on a plane,
    /// and no others.
    HalfOpen,
    /// Hits count from this distance on. Leaks at contacts closer than that, and fails at scales
    /// where the error of the hit point is larger.
    TMin(f64),
    /// The origin moves by this length along the normal. Fails as [`Shadow::TMin`] does, and moves
    /// the shadow's edge.
    ConstantOffset(f64),
    /// The origin moves 256 units in the last place along the normal: [`Ray::offset`], Figure 3(c).
    /// Fails where the hit point's error is larger, for instance on spheres far larger than their
    /// distance.
    UlpOffset,
    /// The origin moves clear of a box around the hit point that is proven to contain the true one.
    /// No acne within its assumptions, but at large coordinates the boxes are large. Source: Pharr,
    /// Jakob, Humphreys, "Physically Based Rendering", 4th edition (2023), section 6.8.
    ErrorBound,
    /// The hit point is projected onto its surface once more; hits at exactly 0 do not count.
    /// Halves the error at best, since the projection rounds too.
    Reprojection,
    /// The surface the ray starts on is not asked. Exact for a convex surface seen from outside,
    /// but leaks where a sphere shadows its own inside, and shows acne on coincident surfaces.
    SkipSelf,
}

impl Shadow {
    /// The strategies that the kit measures, in the order of its tables.
    pub const ALL: [Shadow; 11] = [
        Shadow::SelfHitting,
        Shadow::HalfOpen,
        Shadow::TMin(1e-4),
        Shadow::TMin(1e-3),
        Shadow::ConstantOffset(1e-3),
        Shadow::ConstantOffset(1e-2),
        Shadow::ConstantOffset(0.1),
        Shadow::UlpOffset,
        Shadow::ErrorBound,
        Shadow::Reprojection,
        Shadow::SkipSelf,
    ];

    /// The name, as options and tables give it: `t-min=0.001`, `ulp-offset`.
    pub fn name(self) -> String {
        match self {
            Shadow::SelfHitting => "self-hitting".into(),
            Shadow::HalfOpen => "half-open".into(),
            Shadow::TMin(t) => format!("t-min={t}"),
            Shadow::ConstantOffset(length) => format!("offset={length}"),
            Shadow::UlpOffset => "ulp-offset".into(),
            Shadow::ErrorBound => "error-bound".into(),
            Shadow::Reprojection => "reprojection".into(),
            Shadow::SkipSelf => "skip-self".into(),
        }
    }

    /// The strategy of this name; lengths may be any finite number from 0 on.
    pub fn named(name: &str) -> Option<Shadow> {
        let length = |text: &str| {
            text.parse()
                .ok()
                .filter(|x: &f64| x.is_finite() && *x >= 0.0)
        };
        match name.split_once('=') {
            Some(("t-min", t)) => length(t).map(Shadow::TMin),
            Some(("offset", distance)) => length(distance).map(Shadow::ConstantOffset),
            _ => Self::ALL.into_iter().find(|shadow| shadow.name() == name),
        }
    }

    /// The ray from a hit toward the light in the unit `direction`, and the part of it on which a
    /// hit blocks the light: closed, up to the light's distance.
    #[inline(always)]
    pub fn ray<R: Real<Scalar: Scalar>>(
        self,
        scene: &Scene<R::Scalar>,
        hit: &HitRecord<R>,
        direction: R::Vector,
        distance: R,
    ) -> ShadowRay<R> {
        let zero = distance.constant(0.0);
        let smallest = zero.constant(R::Scalar::MIN_POSITIVE * R::Scalar::EPSILON);
        let ray = Ray {
            origin: hit.point,
            direction,
        };
        let (ray, from) = match self {
            Shadow::SelfHitting | Shadow::SkipSelf => (ray, zero),
            Shadow::HalfOpen => (ray, smallest),
            Shadow::TMin(t) => (ray, zero.constant(t)),
            Shadow::ConstantOffset(length) => (
                Ray {
                    origin: hit.point + hit.normal * zero.constant(length),
                    direction,
                },
                zero,
            ),
            Shadow::UlpOffset => (ray.offset(hit.normal), zero),
            Shadow::ErrorBound => {
                let origin = clear_of(scene.project(hit), hit.normal);
                (Ray { origin, direction }, zero)
            }
            Shadow::Reprojection => {
                let origin = scene.project(hit).point;
                (Ray { origin, direction }, smallest)
            }
        };
        let skip = (self == Shadow::SkipSelf).then_some(hit.object);
        ShadowRay {
            ray,
            span: Span::new(from, distance),
            skip,
        }
    }
}

/// A ray toward a light.
#[derive(Clone, Copy, Debug)]
pub struct ShadowRay<R: Real> {
    /// The ray; its direction is a unit vector.
    pub ray: Ray<R>,
    /// Where a hit blocks the light.
    pub span: Span<R>,
    /// The number of an object that is not asked.
    pub skip: Option<R>,
}

/// The point moved along the normal until the box of its error is behind, then one place further,
/// so that rounding does not undo it (pbrt's `OffsetRayOrigin`).
#[inline(always)]
fn clear_of<R: Real>(on_surface: Projection<R>, normal: R::Vector) -> R::Vector {
    let [nx, ny, nz] = normal.to_array();
    let distance = normal.abs().dot(on_surface.error);
    let moved = on_surface.point + normal * distance;
    R::Vector::new(
        one_place_further(moved.x(), nx),
        one_place_further(moved.y(), ny),
        one_place_further(moved.z(), nz),
    )
}

/// The next number in the direction of the normal's component.
#[inline(always)]
fn one_place_further<R: Real>(x: R, toward: R) -> R {
    let (zero, one) = (x.constant(0.0), x.constant(1.0));
    let next = R::select(toward.gt(zero), x.step(one), x.step(-one));
    R::select(x.abs().gt(zero) & toward.abs().gt(zero), next, x)
}
