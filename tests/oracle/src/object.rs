//! Objects of a scene.

use crate::plane::Plane;
use crate::ray::Ray;
use crate::sphere::Sphere;
use crate::surd::Surd;

/// A plane or a sphere.
#[derive(Clone, Debug, PartialEq)]
pub enum Object {
    /// A plane.
    Plane(Plane),
    /// A sphere.
    Sphere(Sphere),
}

impl Object {
    /// Where the line of a ray meets the object: none, one or two t, the lower first.
    pub fn roots(&self, ray: &Ray) -> Vec<Surd> {
        match self {
            Object::Plane(plane) => plane.meet(ray).t.into_iter().map(Surd::from).collect(),
            Object::Sphere(sphere) => sphere.meet(ray).roots.into_iter().flatten().collect(),
        }
    }

    /// On which side of the surface a point lies: 1 where the normal points (for a sphere outside), 0 on it, -1 behind.
    pub fn side(&self, x: &[Surd; 3]) -> i8 {
        match self {
            Object::Plane(plane) => plane.side(x).sign(),
            Object::Sphere(sphere) => sphere.side(x),
        }
    }

    /// A normal at the point `x` of the surface, away from a sphere's centre, not of length 1.
    pub fn normal(&self, x: &[Surd; 3]) -> [Surd; 3] {
        match self {
            Object::Plane(plane) => plane.normal.clone().map(Surd::from),
            Object::Sphere(sphere) => sphere.from_center(x),
        }
    }
}
