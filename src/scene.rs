//! Scenes: typed lists of shapes and lights, and the nearest hit among them.

use crate::error::Invalid;
use crate::light::PointLight;
use crate::quality::Quality;
use crate::ray::{Ray, Span};
use crate::real::{Mask, Real, Scalar};
use crate::shape::{Plane, Projection, Shape, Sphere};
use crate::vector::Vector;

/// A shape with its material: one flat linear colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object<S: Scalar, G> {
    /// The shape.
    pub shape: G,
    color: S::Vector,
}

impl<S: Scalar, G> Object<S, G> {
    /// The linear colour.
    pub fn color(&self) -> S::Vector {
        self.color
    }
}

/// Spheres, planes and point lights before a background.
///
/// Objects are numbered from 0 in the order spheres, then planes. Their number is unlimited, but
/// only the first 2^24 can be told apart in `f32`.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene<S: Scalar> {
    spheres: Vec<Object<S, Sphere<S>>>,
    planes: Vec<Object<S, Plane<S>>>,
    lights: Vec<PointLight<S>>,
    background: S::Vector,
    t_max: S,
}

/// What a ray found first (the lab's `HitRecord`).
#[derive(Clone, Copy, Debug)]
pub struct HitRecord<R: Real> {
    /// Whether anything was hit; where it is false, nothing else here means anything.
    pub mask: R::Mask,
    /// The point of the hit.
    pub point: R::Vector,
    /// The unit normal there, on the side the ray came from.
    pub normal: R::Vector,
    /// The ray's parameter there: the distance, where its direction is a unit vector.
    pub distance: R,
    /// The number of the object.
    pub object: R,
    /// The linear colour of the object.
    pub color: R::Vector,
}

impl<S: Scalar> Scene<S> {
    /// An empty scene: every ray sees the `background`, a linear colour. Primary rays see objects
    /// up to the parameter `t_max`, which may be infinite.
    ///
    /// # Errors
    /// If a component of the background is not finite or below 0, or `t_max` is NaN or not above 0.
    pub fn new(background: S::Vector, t_max: S) -> Result<Self, Invalid> {
        let background = Invalid::unless_color::<S>("background", background)?;
        let t_max = Invalid::unless(t_max.to_f64() > 0.0, "t_max", t_max, "greater than 0")?;
        Ok(Self {
            spheres: vec![],
            planes: vec![],
            lights: vec![],
            background,
            t_max,
        })
    }

    /// Adds a sphere of a linear colour.
    ///
    /// # Errors
    /// If a component of the colour is not finite or below 0.
    pub fn with_sphere(mut self, shape: Sphere<S>, color: S::Vector) -> Result<Self, Invalid> {
        let color = Invalid::unless_color::<S>("sphere color", color)?;
        self.spheres.push(Object { shape, color });
        Ok(self)
    }

    /// Adds a plane of a linear colour.
    ///
    /// # Errors
    /// If a component of the colour is not finite or below 0.
    pub fn with_plane(mut self, shape: Plane<S>, color: S::Vector) -> Result<Self, Invalid> {
        let color = Invalid::unless_color::<S>("plane color", color)?;
        self.planes.push(Object { shape, color });
        Ok(self)
    }

    /// Adds a light.
    #[must_use]
    pub fn with_light(mut self, light: PointLight<S>) -> Self {
        self.lights.push(light);
        self
    }

    /// The spheres, objects number 0 and up.
    pub fn spheres(&self) -> &[Object<S, Sphere<S>>] {
        &self.spheres
    }

    /// The planes, numbered after the spheres.
    pub fn planes(&self) -> &[Object<S, Plane<S>>] {
        &self.planes
    }

    /// The lights.
    pub fn lights(&self) -> &[PointLight<S>] {
        &self.lights
    }

    /// The linear colour that a ray sees which hits nothing.
    pub fn background(&self) -> S::Vector {
        self.background
    }

    /// The largest parameter at which a primary ray sees an object.
    pub fn t_max(&self) -> S {
        self.t_max
    }

    /// The nearest hit in the interval, of all objects (clause 1.2). Of two at the same distance,
    /// the one with the lower number.
    #[inline(always)]
    pub fn intersect<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
    ) -> HitRecord<R> {
        match self.nearest(ray, span, quality) {
            Some(hit) => hit,
            None => HitRecord::none(ray),
        }
    }

    /// The same; `None` where no lane hits anything.
    #[inline(always)]
    pub(crate) fn nearest<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
    ) -> Option<HitRecord<R>> {
        let mut nearest = None;
        let mut number = 0.0;
        for sphere in &self.spheres {
            HitRecord::keep_nearer(&mut nearest, ray, span, quality, sphere, number);
            number += 1.0;
        }
        for plane in &self.planes {
            HitRecord::keep_nearer(&mut nearest, ray, span, quality, plane, number);
            number += 1.0;
        }
        let hit = nearest?;
        let away = hit.normal.dot(ray.direction).gt(hit.distance.constant(0.0));
        Some(HitRecord {
            point: ray.point_at(hit.distance),
            normal: R::Vector::select(away, -hit.normal, hit.normal),
            ..hit
        })
    }

    /// Whether there is any hit in the interval; stops at the first (clause 5.1).
    #[inline(always)]
    pub fn intersect_any<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
    ) -> R::Mask {
        self.intersect_other(ray, span, quality, None)
    }

    /// The same, of all objects but the one of number `skip`.
    #[inline(always)]
    pub fn intersect_other<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
        skip: Option<R>,
    ) -> R::Mask {
        let mut hit = R::never(span.max.token());
        for (number, sphere) in (0..).zip(&self.spheres) {
            hit = hit | other(sphere.shape.intersect_any(ray, span, quality), skip, number);
            if !(!hit).any() {
                return hit;
            }
        }
        for (number, plane) in (self.spheres.len()..).zip(&self.planes) {
            hit = hit | other(plane.shape.intersect_any(ray, span, quality), skip, number);
            if !(!hit).any() {
                return hit;
            }
        }
        hit
    }

    /// The hit point projected onto the object it lies on. Not inlined: few strategies need it.
    #[inline(never)]
    pub(crate) fn project<R: Real<Scalar = S>>(&self, hit: &HitRecord<R>) -> Projection<R> {
        let mut projection = Projection {
            point: hit.point,
            error: hit.point,
        };
        for (number, sphere) in (0..).zip(&self.spheres) {
            let own = is_number(hit.object, number);
            if own.any() {
                projection = Projection::select(own, sphere.shape.project(hit.point), projection);
            }
        }
        for (number, plane) in (self.spheres.len()..).zip(&self.planes) {
            let own = is_number(hit.object, number);
            if own.any() {
                projection = Projection::select(own, plane.shape.project(hit.point), projection);
            }
        }
        projection
    }
}

/// The lanes in which an object's number is this one.
#[inline(always)]
fn is_number<R: Real>(object: R, number: usize) -> R::Mask {
    let number = object.constant(number as f64);
    object.ge(number) & object.le(number)
}

/// A hit of object `number`, unless that is the one to skip.
#[inline(always)]
fn other<R: Real>(hit: R::Mask, skip: Option<R>, number: usize) -> R::Mask {
    match skip {
        None => hit,
        Some(object) => hit & !is_number(object, number),
    }
}

impl<R: Real<Scalar: Scalar>> HitRecord<R> {
    /// Nothing was hit.
    #[inline(always)]
    fn none(ray: &Ray<R>) -> Self {
        let zero = ray.origin.x().constant(0.0);
        Self {
            mask: R::never(zero.token()),
            point: ray.origin,
            normal: ray.direction,
            distance: zero,
            object: zero,
            color: R::Vector::new(zero, zero, zero),
        }
    }

    /// Replaces the record where the ray meets `object` sooner. Point and facing side of the
    /// normal are found once, at the end.
    #[inline(always)]
    fn keep_nearer<G: Shape<R::Scalar>>(
        nearest: &mut Option<Self>,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
        object: &Object<R::Scalar, G>,
        number: f64,
    ) {
        let hit = object.shape.intersect(ray, span, quality);
        let nearer = match nearest {
            None => hit.mask,
            Some(old) => hit.mask & (!old.mask | hit.t.lt(old.distance)),
        };
        if !nearer.any() {
            return;
        }
        let new = Self {
            mask: nearer,
            point: ray.origin,
            normal: object.shape.normal_at::<R>(ray.point_at(hit.t)),
            distance: hit.t,
            object: hit.t.constant(number),
            color: R::Vector::splat(hit.t.token(), &object.color),
        };
        *nearest = Some(match nearest {
            None => new,
            Some(old) => Self {
                mask: old.mask | nearer,
                point: old.point,
                normal: R::Vector::select(nearer, new.normal, old.normal),
                distance: R::select(nearer, new.distance, old.distance),
                object: R::select(nearer, new.object, old.object),
                color: R::Vector::select(nearer, new.color, old.color),
            },
        });
    }
}

impl Scene<f64> {
    /// The same scene in another format, every number rounded to it.
    ///
    /// # Errors
    /// If a number is valid here but not there: a radius that becomes 0, a position that overflows.
    pub fn cast<S: Scalar>(&self) -> Result<Scene<S>, Invalid> {
        let vector = |v: glam::DVec3| S::Vector::constant((), v.to_array());
        let mut scene = Scene::new(vector(self.background), S::from_f64(self.t_max))?;
        for Object { shape, color } in &self.spheres {
            let shape = Sphere::new(vector(shape.center()), S::from_f64(shape.radius()))?;
            scene = scene.with_sphere(shape, vector(*color))?;
        }
        for Object { shape, color } in &self.planes {
            let shape = Plane::new(vector(shape.point()), vector(shape.normal()))?;
            scene = scene.with_plane(shape, vector(*color))?;
        }
        for light in &self.lights {
            let (position, color) = (vector(light.position()), vector(light.color()));
            scene = scene.with_light(PointLight::new(
                position,
                color,
                S::from_f64(light.power()),
            )?);
        }
        Ok(scene)
    }
}
