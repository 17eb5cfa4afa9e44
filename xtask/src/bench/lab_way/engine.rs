//! The scene, its lights, the camera, and the integrator.

use super::object::{HitRecord, Object, Ray, length, normalize, over};
use ombrage::{Float, Vector, View};
use std::collections::BTreeMap;

pub struct LightSample<F: Float> {
    direction: F::Vector,
    distance: F,
    radiance: F::Vector,
    pdf: F,
}

pub trait Light<F: Float> {
    fn sample(&self, point: F::Vector) -> LightSample<F>;
}

pub struct PointLight<F: Float> {
    pub position: F::Vector,
    pub color: F::Vector,
    pub power: F,
}

impl<F: Float> Light<F> for PointLight<F> {
    fn sample(&self, point: F::Vector) -> LightSample<F> {
        let to_light = self.position - point;
        let distance = length::<F>(to_light);
        LightSample {
            direction: over::<F>(to_light, distance),
            distance,
            radiance: over::<F>(self.color * self.power, distance * distance),
            pdf: F::from_f64(1.0),
        }
    }
}

pub struct Scene<F: Float> {
    pub objects: BTreeMap<String, Box<dyn Object<F>>>,
    pub lights: Vec<Box<dyn Light<F>>>,
    pub background: F::Vector,
}

impl<F: Float> Scene<F> {
    fn intersect<'a>(&'a self, ray: &Ray<F>, min: F, max: F, hit: &mut HitRecord<'a, F>) -> bool {
        let mut nearest = max;
        for object in self.objects.values() {
            if object.intersect(ray, min, nearest, hit) {
                nearest = hit.distance;
            }
        }
        hit.object.is_some()
    }
}

pub trait Camera<F: Float> {
    fn ray(&self, sx: F, sy: F) -> Ray<F>;
}

pub struct Perspective<F: Float> {
    position: F::Vector,
    top_left: F::Vector,
    width: F::Vector,
    height: F::Vector,
}

impl<F: Float> Perspective<F> {
    pub fn new(view: &View<f64>, aspect: F) -> Self {
        let (two, half) = (F::from_f64(2.0), F::from_f64(0.5));
        let vector = |v: glam::DVec3| F::Vector::constant((), v.to_array());
        let position = vector(view.position);
        let w = normalize::<F>(position - vector(view.look_at));
        let u = normalize::<F>(vector(view.up).cross(w));
        let v = w.cross(u);
        let high = two * F::from_f64((view.fov.to_radians() / 2.0).tan());
        let (width, height) = (u * (high * aspect), v * high);
        Self {
            position,
            top_left: position - width * half + height * half - w,
            width,
            height,
        }
    }
}

impl<F: Float> Camera<F> for Perspective<F> {
    fn ray(&self, sx: F, sy: F) -> Ray<F> {
        let through = self.top_left + self.width * sx - self.height * sy;
        Ray {
            origin: self.position,
            direction: normalize::<F>(through - self.position),
        }
    }
}

pub trait Integrator<F: Float> {
    /// The light along a ray; the name is the engine's.
    fn li(&self, scene: &Scene<F>, ray: &Ray<F>, min: F, max: F) -> F::Vector;
}

pub struct DirectLighting;

impl<F: Float> Integrator<F> for DirectLighting {
    fn li(&self, scene: &Scene<F>, ray: &Ray<F>, min: F, max: F) -> F::Vector {
        let zero = F::from_f64(0.0);
        let mut hit = HitRecord::new();
        scene.intersect(ray, min, max, &mut hit);
        let Some(object) = hit.object else {
            return scene.background;
        };
        let mut sum = F::Vector::constant((), [0.0; 3]);
        for light in &scene.lights {
            let sample = light.sample(hit.point);
            let mut shadow = Ray {
                origin: hit.point,
                direction: sample.direction,
            };
            shadow.offset(hit.normal);
            let mut blocker = HitRecord::new();
            if scene.intersect(&shadow, zero, sample.distance, &mut blocker) {
                continue;
            }
            let cosine = hit.normal.dot(sample.direction);
            let cosine = if cosine > zero { cosine } else { zero };
            let color = object.material().flat_color();
            sum = sum + over::<F>(color * sample.radiance * cosine, sample.pdf);
        }
        sum
    }
}
