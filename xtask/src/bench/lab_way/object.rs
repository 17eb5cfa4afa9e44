//! Rays, what they hit, and the record of it.

use ombrage::{Float, Vector};
use std::rc::Rc;

pub struct Ray<F: Float> {
    pub origin: F::Vector,
    pub direction: F::Vector,
}

impl<F: Float> Ray<F> {
    fn point_at(&self, t: F) -> F::Vector {
        self.origin + self.direction * t
    }

    /// The lab's `Ray::offset`: Wächter and Binder, Ray Tracing Gems (2019), chapter 6.
    pub fn offset(&mut self, normal: F::Vector) {
        let moved = |p: F, n: F| {
            if p.abs() < F::from_f64(1.0 / 32.0) {
                return p + n * F::from_f64(128.0 * F::EPSILON);
            }
            let places = i64::from((n * F::from_f64(256.0)).to_f64() as i32);
            let places = if p < F::from_f64(0.0) {
                -places
            } else {
                places
            };
            F::from_bits(p.bits().wrapping_add_signed(places))
        };
        let (p, n) = (self.origin, normal);
        self.origin = Vector::new(
            moved(p.x(), n.x()),
            moved(p.y(), n.y()),
            moved(p.z(), n.z()),
        );
    }
}

pub struct HitRecord<'a, F: Float> {
    pub point: F::Vector,
    pub normal: F::Vector,
    pub distance: F,
    pub object: Option<&'a dyn Object<F>>,
}

impl<F: Float> HitRecord<'_, F> {
    pub fn new() -> Self {
        Self {
            point: F::Vector::constant((), [0.0; 3]),
            normal: F::Vector::constant((), [0.0; 3]),
            distance: F::from_f64(0.0),
            object: None,
        }
    }

    /// Turns the normal to the side the ray came from.
    fn face(&mut self, ray: &Ray<F>) {
        if self.normal.dot(ray.direction) > F::from_f64(0.0) {
            self.normal = -self.normal;
        }
    }
}

pub trait Material<F: Float> {
    fn flat_color(&self) -> F::Vector;
}

pub struct ColorMaterial<F: Float>(pub F::Vector);

impl<F: Float> Material<F> for ColorMaterial<F> {
    fn flat_color(&self) -> F::Vector {
        self.0
    }
}

pub trait Object<F: Float> {
    /// Fills the record and returns true where the ray meets the object in `[min, max]`.
    fn intersect<'a>(&'a self, ray: &Ray<F>, min: F, max: F, hit: &mut HitRecord<'a, F>) -> bool;

    fn material(&self) -> &dyn Material<F>;
}

pub struct Sphere<F: Float> {
    pub center: F::Vector,
    pub radius: F,
    pub material: Rc<dyn Material<F>>,
}

impl<F: Float> Object<F> for Sphere<F> {
    fn intersect<'a>(&'a self, ray: &Ray<F>, min: F, max: F, hit: &mut HitRecord<'a, F>) -> bool {
        let (two, four) = (F::from_f64(2.0), F::from_f64(4.0));
        let from_center = ray.origin - self.center;
        let a = ray.direction.dot(ray.direction);
        let b = two * ray.direction.dot(from_center);
        let c = from_center.dot(from_center) - self.radius * self.radius;
        let discriminant = b * b - four * a * c;
        if discriminant < F::from_f64(0.0) {
            return false;
        }
        let root = discriminant.sqrt();
        let (near, far) = ((-b - root) / (two * a), (-b + root) / (two * a));
        let inside = |t: F| t >= min && t <= max;
        let t = if inside(near) { near } else { far };
        if !inside(t) {
            return false;
        }
        hit.point = ray.point_at(t);
        hit.normal = normalize::<F>(hit.point - self.center);
        hit.distance = t;
        hit.object = Some(self);
        hit.face(ray);
        true
    }

    fn material(&self) -> &dyn Material<F> {
        &*self.material
    }
}

pub struct Plane<F: Float> {
    pub point: F::Vector,
    pub normal: F::Vector,
    pub material: Rc<dyn Material<F>>,
}

impl<F: Float> Object<F> for Plane<F> {
    fn intersect<'a>(&'a self, ray: &Ray<F>, min: F, max: F, hit: &mut HitRecord<'a, F>) -> bool {
        let along = ray.direction.dot(self.normal);
        if along == F::from_f64(0.0) {
            return false;
        }
        let t = (self.point - ray.origin).dot(self.normal) / along;
        if t < min || t > max {
            return false;
        }
        hit.point = ray.point_at(t);
        hit.normal = self.normal;
        hit.distance = t;
        hit.object = Some(self);
        hit.face(ray);
        true
    }

    fn material(&self) -> &dyn Material<F> {
        &*self.material
    }
}

pub fn length<F: Float>(vector: F::Vector) -> F {
    vector.dot(vector).sqrt()
}

pub fn normalize<F: Float>(vector: F::Vector) -> F::Vector {
    vector * (F::from_f64(1.0) / length::<F>(vector))
}

/// The vector divided by a number, component by component.
pub fn over<F: Float>(vector: F::Vector, divisor: F) -> F::Vector {
    let [x, y, z] = vector.to_array().map(|component| component / divisor);
    Vector::new(x, y, z)
}
