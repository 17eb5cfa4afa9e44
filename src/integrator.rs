//! Integrators: how much light comes along a ray.

use crate::quality::Quality;
use crate::ray::{Ray, Span};
use crate::real::{Mask, Real, Scalar};
use crate::scene::{HitRecord, Scene};
use crate::shadow::{Shadow, ShadowRay};
use crate::vector::Vector;

/// The light that comes along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Integrator {
    /// A lamp at the eye: `color * max(0, dot(normal, -direction))` (Figure 1).
    RayCast(Quality),
    /// The scene's lights (clause 3.1).
    DirectLighting(DirectLighting),
}

/// Direct light: the sum over all lights of `color * radiance * max(0, dot(normal, to light))`; no
/// division by π, no albedo. The lab's `DirectLightingIntegrator`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectLighting {
    /// How well rays, shadow rays and light samples are computed.
    pub quality: Quality,
    /// How shadow rays start; `None` casts none, and everything is lit.
    pub shadow: Option<Shadow>,
    /// What shadow rays ask the scene.
    pub query: ShadowQuery,
}

/// The question a shadow ray asks (clause 5). Both have the same answer. Under
/// [`Shadow::SkipSelf`] it is always the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShadowQuery {
    /// Is the nearest hit before the light? Clause 4.1, by `intersect`.
    Nearest,
    /// Is there any hit before the light? Clause 5.2, by `intersect_any`.
    Any,
}

impl Integrator {
    /// How well its kernels compute.
    #[inline(always)]
    pub fn quality(self) -> Quality {
        match self {
            Integrator::RayCast(quality) => quality,
            Integrator::DirectLighting(direct) => direct.quality,
        }
    }

    /// The radiance along a ray: a linear colour; the background's where nothing is hit.
    #[inline(always)]
    pub fn radiance<R: Real<Scalar: Scalar>>(
        self,
        scene: &Scene<R::Scalar>,
        ray: &Ray<R>,
    ) -> R::Vector {
        let background = R::Vector::splat(ray.origin.x().token(), &scene.background());
        match self.reflected(scene, ray) {
            None => background,
            Some((mask, reflected)) => R::Vector::select(mask, reflected, background),
        }
    }

    /// What the objects send back along a ray, and in which lanes there is one; `None` where there
    /// is none in any.
    #[inline(always)]
    pub(crate) fn reflected<R: Real<Scalar: Scalar>>(
        self,
        scene: &Scene<R::Scalar>,
        ray: &Ray<R>,
    ) -> Option<(R::Mask, R::Vector)> {
        let zero = ray.origin.x().constant(0.0);
        let span = Span::new(zero, R::splat(zero.token(), scene.t_max()));
        let hit = scene.nearest(ray, &span, self.quality())?;
        let reflected = match self {
            Integrator::RayCast(_) => hit.color * cosine::<R>(hit.normal, -ray.direction),
            Integrator::DirectLighting(direct) => direct.radiance(scene, &hit),
        };
        Some((hit.mask, reflected))
    }
}

impl DirectLighting {
    /// The light that a hit point sends back, from all lights it can see (the lab's
    /// `_directLighting`).
    #[inline(always)]
    fn radiance<R: Real<Scalar: Scalar>>(
        self,
        scene: &Scene<R::Scalar>,
        hit: &HitRecord<R>,
    ) -> R::Vector {
        let zero = hit.distance.constant(0.0);
        let mut sum = R::Vector::new(zero, zero, zero);
        for light in scene.lights() {
            let sample = light.sample::<R>(hit.point, self.quality);
            let cosine = hit.normal.dot(sample.direction);
            let facing = hit.mask & cosine.gt(zero);
            if !facing.any() {
                continue;
            }
            let visible = match self.shadow {
                None => facing,
                Some(shadow) => {
                    let ray = shadow.ray(scene, hit, sample.direction, sample.distance);
                    facing & !self.blocked(scene, &ray)
                }
            };
            let lit = sum + hit.color * sample.radiance * cosine;
            sum = R::Vector::select(visible, lit, sum);
        }
        sum
    }

    /// Whether anything stands on this part of the ray.
    #[inline(always)]
    fn blocked<R: Real<Scalar: Scalar>>(
        self,
        scene: &Scene<R::Scalar>,
        shadow: &ShadowRay<R>,
    ) -> R::Mask {
        let ShadowRay { ray, span, skip } = shadow;
        match (self.query, skip) {
            (ShadowQuery::Nearest, None) => scene.intersect(ray, span, self.quality).mask,
            _ => scene.intersect_other(ray, span, self.quality, *skip),
        }
    }
}

/// The cosine of the angle between two unit vectors, 0 where it would be negative.
#[inline(always)]
fn cosine<R: Real>(a: R::Vector, b: R::Vector) -> R {
    let cosine = a.dot(b);
    let zero = cosine.constant(0.0);
    R::select(cosine.gt(zero), cosine, zero)
}
