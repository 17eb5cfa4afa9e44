//! A relative scene in another format, number by number.

use super::light::{Light, Near, Occluder};
use super::sphere::Sphere;
use super::{Plane, Relative};
use crate::real::Constant;
use crate::vector::Vector;

impl<T: Constant> Relative<T> {
    /// The scene with every number as `number` makes it, but `square` the squares of `t_max`, which
    /// may be beyond any format.
    pub(crate) fn map<S: Constant>(
        &self,
        number: impl Fn(T) -> S + Copy,
        square: impl Fn(T) -> S,
    ) -> Relative<S> {
        let planes = self.planes.iter().map(|plane| Plane {
            normal: vector(plane.normal, number),
            height: number(plane.height),
            reach: square(plane.reach),
            number: number(plane.number),
            color: vector(plane.color, number),
        });
        let lights = |lights: &Vec<Light<T>>| lights.iter().map(|l| l.map(number)).collect();
        Relative {
            forward: vector(self.forward, number),
            right: vector(self.right, number),
            up: vector(self.up, number),
            spheres: self.spheres.iter().map(|s| s.map(number)).collect(),
            first_plane: self.first_plane,
            planes: planes.collect(),
            lights: self.lights.as_ref().map(lights),
            background: vector(self.background, number),
            t_max_squared: square(self.t_max_squared),
            endless: self.endless,
        }
    }
}

impl<T: Constant> Sphere<T> {
    fn map<S: Constant>(&self, number: impl Fn(T) -> S + Copy) -> Sphere<S> {
        Sphere {
            center: vector(self.center, number),
            radius_squared: number(self.radius_squared),
            curvature: number(self.curvature),
            power: number(self.power),
            camera: self.camera,
            number: number(self.number),
            color: vector(self.color, number),
        }
    }
}

impl<T: Constant> Light<T> {
    fn map<S: Constant>(&self, number: impl Fn(T) -> S + Copy) -> Light<S> {
        let heights = self.heights.iter();
        let near = self.near.iter().map(|near| Near {
            number: number(near.number),
            to_light: vector(near.to_light, number),
            radius: number(near.radius),
        });
        let occluders = self.occluders.iter().map(|occluder| Occluder {
            center: vector(occluder.center, number),
            radius_squared: number(occluder.radius_squared),
            number: number(occluder.number),
            to_light: vector(occluder.to_light, number),
            to_light_squared: number(occluder.to_light_squared),
        });
        Light {
            position: vector(self.position, number),
            intensity: vector(self.intensity, number),
            heights: heights.map(|&(n, h)| (number(n), number(h))).collect(),
            near: near.collect(),
            occluders: occluders.collect(),
            edges: self.edges.iter().map(|&e| vector(e, number)).collect(),
        }
    }
}

fn vector<T: Constant, S: Constant>(value: T::Vector, number: impl Fn(T) -> S) -> S::Vector {
    let [x, y, z] = value.to_array().map(number);
    S::Vector::new(x, y, z)
}
