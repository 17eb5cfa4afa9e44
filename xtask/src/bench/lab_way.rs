//! The lab's program, built as the lab's C++ engine is: what speed is measured against.
//!
//! Objects are trait objects in a map by name and share their materials; the camera, the lights and
//! the integrator are trait objects too; a shadow ray asks for the nearest hit and fills a whole
//! record; one pixel after the other. It takes from the kit the description of a scene and glam's
//! vectors, and no kernel.

mod engine;
mod object;

use engine::{DirectLighting, Integrator, Perspective, PointLight, Scene};
use object::{ColorMaterial, Object, Plane, Sphere};
use ombrage::{Float, Invalid, Picture, Size, Vector, View};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The program with a scene loaded.
pub struct Program<F: Float> {
    scene: Scene<F>,
    integrator: Box<dyn Integrator<F>>,
    camera: Box<dyn engine::Camera<F>>,
    t_max: F,
}

impl<F: Float> Program<F> {
    /// Loads a scene, seen by a camera with pictures of this size.
    pub fn new(scene: &ombrage::Scene<f64>, view: &View<f64>, size: Size) -> Self {
        let vector = |v: glam::DVec3| F::Vector::constant((), v.to_array());
        let mut objects: BTreeMap<String, Box<dyn Object<F>>> = BTreeMap::new();
        for (number, sphere) in scene.spheres().iter().enumerate() {
            let object = Sphere {
                center: vector(sphere.shape.center()),
                radius: F::from_f64(sphere.shape.radius()),
                material: Rc::new(ColorMaterial(vector(sphere.color()))),
            };
            objects.insert(format!("Sphere{number}"), Box::new(object));
        }
        for (number, plane) in scene.planes().iter().enumerate() {
            let object = Plane {
                point: vector(plane.shape.point()),
                normal: vector(plane.shape.normal()),
                material: Rc::new(ColorMaterial(vector(plane.color()))),
            };
            objects.insert(format!("Plane{number}"), Box::new(object));
        }
        let light = |light: &ombrage::PointLight<f64>| -> Box<dyn engine::Light<F>> {
            Box::new(PointLight {
                position: vector(light.position()),
                color: vector(light.color()),
                power: F::from_f64(light.power()),
            })
        };
        Self {
            scene: Scene {
                objects,
                lights: scene.lights().iter().map(light).collect(),
                background: vector(scene.background()),
            },
            integrator: Box::new(DirectLighting),
            camera: Box::new(Perspective::new(view, F::from_f64(size.aspect()))),
            t_max: F::from_f64(scene.t_max()),
        }
    }

    /// Renders a picture of at least two columns and two rows.
    ///
    /// # Errors
    /// None: there are as many pixels as the size says.
    pub fn render(&self, size: Size) -> Result<Picture, Invalid> {
        let zero = F::from_f64(0.0);
        let place = |i: u32, n: u32| F::from_f64(f64::from(i)) / F::from_f64(f64::from(n - 1));
        let mut pixels = Vec::with_capacity(size.pixels());
        for j in 0..size.height() {
            let sy = place(j, size.height());
            for i in 0..size.width() {
                let ray = self.camera.ray(place(i, size.width()), sy);
                let color = self.integrator.li(&self.scene, &ray, zero, self.t_max);
                pixels.push(color.to_array().map(byte));
            }
        }
        Picture::from_pixels(size, pixels)
    }
}

fn byte<F: Float>(x: F) -> u8 {
    let (zero, one) = (F::from_f64(0.0), F::from_f64(1.0));
    let x = if x < zero { zero } else { x };
    let x = if x > one { one } else { x };
    (x * F::from_f64(255.0)).to_f64() as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::differing;
    use ombrage::{Figure, lab};

    /// It does the whole work: its picture is Figure 3(c), but for a handful of bytes.
    fn draws_figure_3c<F: Float>() {
        let (scene, view) = (lab::scene().expect("valid"), lab::view());
        let found = Program::<F>::new(&scene, &view, Size::LAB).render(Size::LAB);
        let figure = Figure::named("3c").expect("a figure");
        let expected = figure.draw::<F>(Size::LAB).expect("valid");
        let others = differing(found.expect("a picture").bytes(), expected.bytes());
        assert!(others <= 10, "{others} bytes differ");
    }

    #[test]
    fn draws_figure_3c_in_f32() {
        draws_figure_3c::<f32>();
    }

    #[test]
    fn draws_figure_3c_in_f64() {
        draws_figure_3c::<f64>();
    }
}
