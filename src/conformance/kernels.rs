//! The kit's answers to the questions of the kernel protocol.

use super::shade::{Shade, Shaded};
use super::surface::{Ends, Surface, Valid, interval};
use crate::film::Film;
use crate::float::Float;
use crate::leave::leave;
use crate::light::{LightSample, PointLight};
use crate::quality::Quality;
use crate::ray::{Ray, Span};
use crate::real::{DoubleDouble, Scalar};
use crate::shadow::Shadow;
use crate::shape::{Shape, Sphere};
use crate::vector::{Triple, Vector};
use std::cmp::Ordering;

/// The kit's kernels, as a question may be asked of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Kernels {
    /// How well rays and light samples are computed.
    pub quality: Quality,
    /// How shadow rays leave their surface in the lab's chain. `None`, the default: there are no
    /// shadow rays; which side of a surface a point is on says what blocks.
    pub shadow: Option<Shadow>,
}

/// A rounded hit point that a shadow ray is to leave from.
#[derive(Clone, Copy, Debug)]
pub struct Offset<F: Float> {
    /// The ray that found the hit.
    pub ray: Ray<F>,
    /// What it hit.
    pub surface: Surface<F>,
    /// The rounded hit point.
    pub point: F::Vector,
    /// The unit normal there, on the side the ray came from.
    pub normal: F::Vector,
}

impl Kernels {
    /// The nearest hit of a surface in the closed interval; `None` for none, and for input that
    /// policy calls a miss.
    pub fn hit<F: Float>(&self, ray: &Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
        let span = interval(ray, ends)?;
        let hit = match surface.shape(|x: F| x)? {
            Valid::Plane(plane) => plane.intersect(ray, &span, self.quality),
            Valid::Sphere(sphere) => sphere.intersect(ray, &span, self.quality),
        };
        hit.mask.then_some(hit.t)
    }

    /// Whether any of the surfaces is hit in the closed interval.
    pub fn any_hit<F: Float>(&self, ray: &Ray<F>, ends: Ends<F>, surfaces: &[Surface<F>]) -> bool {
        let meets = |span: &Span<F>, surface: &Surface<F>| match surface.shape(|x: F| x) {
            Some(Valid::Plane(plane)) => plane.intersect_any(ray, span, self.quality),
            Some(Valid::Sphere(sphere)) => sphere.intersect_any(ray, span, self.quality),
            None => false,
        };
        interval(ray, ends).is_some_and(|span| surfaces.iter().any(|surface| meets(&span, surface)))
    }

    /// The sample of a light (position, colour, power) from a point; `None` where it contributes
    /// nothing: at the light itself, and where a number is not finite.
    pub fn light_sample<F: Float>(
        &self,
        point: F::Vector,
        [position, color]: [F::Vector; 2],
        power: F,
    ) -> Option<LightSample<F>> {
        let finite = point.to_array().into_iter().all(F::is_finite);
        if !finite || point == position {
            return None;
        }
        light_sample(point, position, color, power, self.quality)
    }

    /// The radiance along a ray.
    ///
    /// # Errors
    /// If the lab's chain, asked for by [`shadow`](Self::shadow), does not know such a scene: why.
    pub fn shade<F: Float>(&self, question: &Shade<F>) -> Result<Shaded<F>, String> {
        match self.shadow {
            None => Ok(question.by_sides()),
            Some(shadow) => question.by_shadow_rays(self.quality, shadow),
        }
    }

    /// A shadow ray's origin strictly on the side the ray came from, near the hit point; the point
    /// itself where the ray cannot have seen the surface. See [`leave`].
    pub fn offset<F: Float>(&self, question: &Offset<F>) -> F::Vector {
        let Offset {
            ray,
            surface,
            point,
            normal,
        } = *question;
        match surface.shape(|x: F| x) {
            Some(Valid::Plane(plane)) => {
                let along = exact::<F>(plane.normal()).dot(exact::<F>(ray.direction));
                let from = seen_from(plane.side(ray.origin), sign(-along));
                leave::<F>(point, normal, |x| plane.side(x), from)
            }
            Some(Valid::Sphere(sphere)) => {
                let from = seen_from(sphere.side(ray.origin), outward(&sphere, ray));
                leave::<F>(point, normal, |x| sphere.side(x), from)
            }
            None => point,
        }
    }

    /// The byte of a component of radiance.
    pub fn quantise<F: Float>(&self, x: F) -> u8 {
        Film::Clamp.byte(x).to_f64() as u8
    }
}

/// The sample of a light whose colour and power may be below 0, which no scene's light has: that of
/// their magnitudes, with their signs; `None` where a number is not finite.
pub(super) fn light_sample<S: Scalar>(
    point: S::Vector,
    position: S::Vector,
    color: S::Vector,
    power: S,
    quality: Quality,
) -> Option<LightSample<S>> {
    let one = S::from_f64(1.0);
    let sign = |x: S| if x < S::from_f64(0.0) { -one } else { one };
    let [r, g, b] = color.to_array().map(|c| sign(c) * sign(power));
    let light = PointLight::<S>::new(position, color.abs(), power.abs()).ok()?;
    let sample = light.sample::<S>(point, quality);
    Some(LightSample {
        radiance: sample.radiance * S::Vector::new(r, g, b),
        ..sample
    })
}

/// The side of the ray's origin; for an origin on the surface, that which its direction tells.
fn seen_from(origin: Ordering, by_direction: Ordering) -> Ordering {
    origin.then(by_direction)
}

/// Greater for a direction that leaves the sphere at the ray's origin on it, less for one that
/// enters.
fn outward<F: Float>(sphere: &Sphere<F>, ray: Ray<F>) -> Ordering {
    let from_center = exact::<F>(ray.origin) - exact::<F>(sphere.center());
    sign(from_center.dot(exact::<F>(ray.direction)))
}

/// Where a number is, seen from zero.
pub(super) fn sign(x: DoubleDouble) -> Ordering {
    x.partial_cmp(&DoubleDouble::from_f64(0.0))
        .unwrap_or(Ordering::Equal)
}

/// A vector as double-doubles.
pub(super) fn exact<F: Float>(v: F::Vector) -> Triple<DoubleDouble> {
    let [x, y, z] = v.to_array().map(Scalar::to_double_double);
    Triple(x, y, z)
}
