//! One shaded ray: the kit's way, by sides, and the lab's, by shadow rays.

use super::kernels::{exact, light_sample, sign};
use super::surface::{Ends, Surface, Valid, interval};
use crate::film::Film;
use crate::float::Float;
use crate::integrator::{DirectLighting, Integrator, ShadowQuery};
use crate::light::PointLight;
use crate::quality::Quality;
use crate::ray::{Ray, Span};
use crate::real::{Constant, DoubleDouble, Real, Scalar};
use crate::scene::Scene;
use crate::shadow::Shadow;
use crate::shape::{Shape, Sphere};
use crate::vector::{Triple, Vector};
use std::cmp::Ordering;

/// A ray, and the scene it sees. A hit counts in `(tmin, tmax]`.
#[derive(Clone, Debug)]
pub struct Shade<F: Float> {
    /// The ray; its direction may have any length but zero.
    pub ray: Ray<F>,
    /// `[tmin, tmax]`
    pub ends: Ends<F>,
    /// Every object with its colour. Of several hit at the same point, the first is seen.
    pub objects: Vec<(Surface<F>, F::Vector)>,
    /// Where the light is.
    pub light: F::Vector,
    /// Its colour.
    pub light_color: F::Vector,
    /// The factor of its radiance.
    pub power: F,
    /// What a ray sees, in each component, that hits nothing.
    pub background: F,
}

/// The answer: radiance before the clamp, and the bytes after it.
#[derive(Clone, Copy, Debug)]
pub struct Shaded<F: Float> {
    /// The radiance.
    pub li: F::Vector,
    /// Its bytes (clause 3.3).
    pub bytes: [u8; 3],
}

/// A number, a vector and a shape in double-double.
type D = DoubleDouble;
type V = Triple<D>;

/// Results this near to zero, over their terms, are within the error of double-double and count as
/// 0: 2^-90, where a chain of some twenty roundings leaves about 2^-97.
const ZERO: f64 = 1.0 / (1u128 << 90) as f64;

impl<F: Float> Shade<F> {
    /// The kit's way. The hit is decided in exact arithmetic, everything after it in double-double.
    /// Nothing leaves a surface: another plane blocks where it parts the point from the light,
    /// another sphere where the way reaches into it, and for the surface itself the normal's side
    /// is enough.
    pub(super) fn by_sides(&self) -> Shaded<F> {
        let shapes: Vec<Option<Valid<D>>> = self
            .objects
            .iter()
            .map(|(surface, _)| surface.shape(F::to_double_double))
            .collect();
        let background = self.background.to_double_double();
        let Some(hit) = self.nearest(&shapes) else {
            return developed(Triple(background, background, background));
        };
        let color = exact::<F>(self.objects[hit.objects[0]].1);
        let zero = D::from_f64(0.0);
        let black = Triple(zero, zero, zero);
        let (position, light_color) = (exact::<F>(self.light), exact::<F>(self.light_color));
        let power = self.power.to_double_double();
        let finite = color.to_array().into_iter().all(D::is_finite);
        let sample = light_sample(hit.point, position, light_color, power, Quality::Stable);
        let Some(sample) = sample.filter(|_| finite) else {
            return developed(black);
        };
        let cosine = hit.normal.dot(sample.direction);
        let lit = cosine > D::from_f64(ZERO);
        if !lit || !hit.blockers(&shapes, position).is_empty() {
            return developed(black);
        }
        developed(color * sample.radiance * cosine)
    }

    /// What the ray meets first.
    fn nearest(&self, shapes: &[Option<Valid<D>>]) -> Option<Met> {
        let span = interval(&self.ray, self.ends)?;
        let ray = Ray::<D> {
            origin: exact::<F>(self.ray.origin),
            direction: exact::<F>(self.ray.direction),
        };
        let span = Span {
            min: just_above(span.min.to_double_double()),
            max: span.max.to_double_double(),
        };
        let mut nearest: Option<(D, Vec<usize>)> = None;
        for (number, shape) in shapes.iter().enumerate() {
            let hit = match shape {
                Some(Valid::Plane(plane)) => plane.intersect(&ray, &span, Quality::Wide),
                Some(Valid::Sphere(sphere)) => sphere.intersect(&ray, &span, Quality::Wide),
                None => continue,
            };
            if !hit.mask {
                continue;
            }
            match &mut nearest {
                Some((t, objects)) => match apart(hit.t - *t, *t) {
                    Ordering::Less => nearest = Some((hit.t, vec![number])),
                    Ordering::Equal => objects.push(number),
                    Ordering::Greater => {}
                },
                None => nearest = Some((hit.t, vec![number])),
            }
        }
        let (t, objects) = nearest?;
        let point = ray.point_at(t);
        let outward = match shapes[objects[0]]? {
            Valid::Plane(plane) => plane.normal_at::<D>(point),
            Valid::Sphere(sphere) => sphere.normal_at::<D>(point),
        };
        let along = outward.dot(ray.direction);
        let away = apart(along, outward.abs().dot(ray.direction.abs())).is_gt();
        let normal = if away { -outward } else { outward };
        Some(Met {
            objects,
            point,
            normal,
        })
    }

    /// The lab's way: a shadow ray from the hit point, which `shadow` lets leave the surface.
    pub(super) fn by_shadow_rays(
        &self,
        quality: Quality,
        shadow: Shadow,
    ) -> Result<Shaded<F>, String> {
        let gray = F::Vector::new(self.background, self.background, self.background);
        let [tmin, tmax] = self.ends;
        if interval(&self.ray, self.ends).is_none() {
            return Ok(developed(exact::<F>(gray)));
        }
        if tmin.to_f64() != 0.0 {
            return Err("the lab's rays start at t = 0".into());
        }
        let scene = || {
            let mut scene = Scene::<F>::new(gray, tmax)?;
            for (surface, color) in &self.objects {
                scene = match surface.shape(|x: F| x) {
                    Some(Valid::Plane(plane)) => scene.with_plane(plane, *color)?,
                    Some(Valid::Sphere(sphere)) => scene.with_sphere(sphere, *color)?,
                    None => scene,
                };
            }
            let light = PointLight::new(self.light, self.light_color, self.power)?;
            Ok(scene.with_light(light))
        };
        let scene: Result<_, crate::error::Invalid> = scene();
        let direct = DirectLighting {
            quality,
            shadow: Some(shadow),
            query: ShadowQuery::Any,
        };
        let integrator = Integrator::DirectLighting(direct);
        scene
            .map(|scene| developed(exact::<F>(integrator.radiance(&scene, &self.ray))))
            .map_err(|invalid| invalid.to_string())
    }
}

/// A hit: the objects that share its point, the first one seen.
pub(super) struct Met {
    pub objects: Vec<usize>,
    pub point: V,
    pub normal: V,
}

impl Met {
    /// The objects whose surfaces cross the way to the light strictly between its ends.
    pub fn blockers(&self, shapes: &[Option<Valid<D>>], light: V) -> Vec<usize> {
        let crosses = |number: &usize| {
            let own = self.objects.contains(number);
            match &shapes[*number] {
                Some(Valid::Plane(plane)) => {
                    let height = self.point - plane.point();
                    let at_point = sign(height.dot(plane.normal()));
                    !own && at_point.is_ne() && plane.side(light) == at_point.reverse()
                }
                Some(Valid::Sphere(sphere)) => self.crosses_sphere(sphere, own, light),
                None => false,
            }
        };
        (0..shapes.len()).filter(crosses).collect()
    }

    /// By the sides of both ends. Where both are outside, the sphere blocks if the nearest point
    /// lies between them and `|p x l|² <= r² |l - p|²` (Lagrange), p and l seen from the center.
    fn crosses_sphere(&self, sphere: &Sphere<D>, own: bool, light: V) -> bool {
        let point = self.point - sphere.center();
        let to_light = light - sphere.center();
        let rr = sphere.radius() * sphere.radius();
        let from = match own {
            true => Ordering::Equal,
            false => sign(point.dot(point) - rr),
        };
        let way = light - self.point;
        let length2 = way.dot(way);
        let toward_center = -point.dot(way);
        match (from, sphere.side(light)) {
            (Ordering::Greater, Ordering::Greater) => {
                let moment = point.cross(to_light);
                let (reach, limit) = (moment.dot(moment), rr * length2);
                apart(reach - limit, limit).is_le()
                    && sign(toward_center).is_gt()
                    && toward_center < length2
            }
            (Ordering::Equal, Ordering::Greater) => sign(toward_center).is_gt(),
            (Ordering::Greater, Ordering::Equal) => point.dot(point) - rr < length2,
            (from, to) => from.is_ne() && from == to.reverse(),
        }
    }
}

/// Where a difference is, seen from zero, beyond what rounding may have made of it.
fn apart(difference: D, terms: D) -> Ordering {
    if difference.abs() <= terms.abs() * ZERO {
        Ordering::Equal
    } else {
        sign(difference)
    }
}

/// The lower end of an interval that does not contain its end. Hits at parameters between 0 and
/// 2^-400, whose squares would be lost, are given up for it.
fn just_above(t: D) -> D {
    let step = t.abs() * (4.0 * D::EPSILON);
    if step > D::from_f64(0.0) {
        t + step
    } else {
        D::from_f64(2f64.powi(-400))
    }
}

/// Radiance and bytes, each rounded once.
fn developed<F: Float>(li: V) -> Shaded<F> {
    let bytes = li.to_array().map(|x| Film::Clamp.byte(x).to_f64() as u8);
    let [x, y, z] = li.to_array().map(F::from_double_double);
    Shaded {
        li: F::Vector::new(x, y, z),
        bytes,
    }
}
