//! The scene of the lab: a blue sphere over a red plane, one white light.

use crate::camera::View;
use crate::error::Invalid;
use crate::light::PointLight;
use crate::real::Scalar;
use crate::scene::Scene;
use crate::shape::{Plane, Sphere};
use crate::vector::Vector;

/// Three constants as a vector of this format.
fn vector<S: Scalar>(components: [f64; 3]) -> S::Vector {
    S::Vector::constant((), components)
}

/// The sphere, the plane at y = -2 (clause 1.3), the light at (1, 10, 1) of power 100 (clause 3.2),
/// before grey; primary rays see up to 1000.
///
/// # Errors
/// None for the formats there are: every number of the scene is a number of each of them.
pub fn scene<S: Scalar>() -> Result<Scene<S>, Invalid> {
    let number = S::from_f64;
    let sphere = Sphere::new(vector::<S>([0.0, 0.0, 3.0]), number(1.0))?;
    let plane = Plane::new(vector::<S>([0.0, -2.0, 0.0]), vector::<S>([0.0, 1.0, 0.0]))?;
    let white = vector::<S>([1.0, 1.0, 1.0]);
    let light = PointLight::new(vector::<S>([1.0, 10.0, 1.0]), white, number(100.0))?;
    let scene = Scene::new(vector::<S>([0.5, 0.5, 0.5]), number(1000.0))?
        .with_sphere(sphere, vector::<S>([0.0, 0.0, 1.0]))?
        .with_plane(plane, vector::<S>([1.0, 0.0, 0.0]))?
        .with_light(light);
    Ok(scene)
}

/// From (0, 0, -2) toward (0, 0, 79), with a vertical field of view of 60 degrees.
pub fn view<S: Scalar>() -> View<S> {
    View {
        position: vector::<S>([0.0, 0.0, -2.0]),
        look_at: vector::<S>([0.0, 0.0, 79.0]),
        up: vector::<S>([0.0, 1.0, 0.0]),
        fov: S::from_f64(60.0),
    }
}
