//! Once a frame: the scene relative to its camera, in double-double, rounded at the end.

use super::light::{Light, Near, Occluder};
use super::sphere::Sphere;
use super::{Lighting, Plane, Relative};
use crate::camera::View;
use crate::error::Invalid;
use crate::light::PointLight;
use crate::picture::Size;
use crate::real::{DoubleDouble, Scalar};
use crate::scene::Scene;
use crate::vector::{Triple, Vector};
use glam::DVec3;
use std::cmp::Ordering;
use std::collections::HashSet;

/// Objects are told apart by a number that `f32` must hold exactly.
const MOST_OBJECTS: usize = 1 << 24;

impl<S: Scalar> Relative<S> {
    /// The scene as a camera with this view sees it in a picture of this size.
    ///
    /// Scene and view are taken as exact; what is rounded to `S` is the scene relative to the
    /// camera.
    ///
    /// # Errors
    /// If the view is invalid ([`PerspectiveCamera::new`](crate::PerspectiveCamera::new) says
    /// when), or there are more than 2^24 objects.
    pub fn new(
        scene: &Scene<f64>,
        view: &View<f64>,
        size: Size,
        lighting: Lighting,
    ) -> Result<Self, Invalid> {
        let objects = scene.spheres().len() + scene.planes().len();
        if objects > MOST_OBJECTS {
            let (field, value) = ("number of objects", objects.to_string());
            return Err(Invalid {
                field,
                value,
                must_be: "at most 2^24",
            });
        }
        let [width, height] = [size.width(), size.height()].map(|n| exact(f64::from(n)));
        let axes = view.cast::<DoubleDouble>().axes(width / height)?;
        let t_max = exact(scene.t_max());
        let surfaces = Surfaces::new(scene, exact_vector(view.position));
        let lights = || {
            scene
                .lights()
                .iter()
                .filter_map(|light| surfaces.light(light, lighting))
        };
        Ok(Self {
            forward: round::<S>(axes.forward),
            right: round::<S>(axes.right),
            up: round::<S>(axes.up),
            spheres: surfaces.spheres.iter().map(ExactSphere::round).collect(),
            first_plane: scene.spheres().len(),
            planes: surfaces
                .planes
                .iter()
                .filter_map(|plane| plane.round(t_max))
                .collect(),
            lights: (lighting != Lighting::Eye).then(|| lights().collect()),
            background: round::<S>(exact_vector(scene.background())),
            t_max_squared: square(t_max),
        })
    }
}

/// Three numbers relative to the camera, before they are rounded.
type Exact = Triple<DoubleDouble>;

/// A sphere relative to the camera.
struct ExactSphere {
    center: Exact,
    radius: DoubleDouble,
    /// `|center|² - radius²`: its sign is the side the camera is on.
    power: DoubleDouble,
    number: usize,
    color: DVec3,
}

/// A plane relative to the camera, which is on its positive side or on it.
struct ExactPlane {
    normal: Exact,
    /// `dot(normal, x)` for its points x: 0 or below.
    height: DoubleDouble,
    number: usize,
    color: DVec3,
}

/// All surfaces of a scene relative to the camera. Of spheres that coincide only the first, which is
/// the one that is seen.
struct Surfaces {
    camera: Exact,
    spheres: Vec<ExactSphere>,
    planes: Vec<ExactPlane>,
}

impl Surfaces {
    fn new(scene: &Scene<f64>, camera: Exact) -> Self {
        let mut seen = HashSet::new();
        let numbered = scene.spheres().iter().enumerate();
        let spheres = numbered.filter_map(|(number, sphere)| {
            let (center, radius) = (sphere.shape.center(), sphere.shape.radius());
            let bits = [center.x, center.y, center.z, radius].map(f64::to_bits);
            let (center, radius) = (exact_vector(center) - camera, exact(radius));
            let power = center.dot(center) - radius * radius;
            seen.insert(bits).then(|| ExactSphere {
                center,
                radius,
                power,
                number,
                color: sphere.color(),
            })
        });
        let planes = scene.planes().iter().enumerate().map(|(number, plane)| {
            let normal = exact_vector(plane.shape.normal()).normalized();
            let height = (exact_vector(plane.shape.point()) - camera).dot(normal);
            let above = height > exact(0.0);
            let (normal, height) = if above {
                (-normal, -height)
            } else {
                (normal, height)
            };
            let number = number + scene.spheres().len();
            ExactPlane {
                normal,
                height,
                number,
                color: plane.color(),
            }
        });
        Self {
            camera,
            spheres: spheres.collect(),
            planes: planes.collect(),
        }
    }

    /// A light, unless a surface separates it from the camera and shadows are wanted.
    fn light<S: Scalar>(&self, light: &PointLight<f64>, lighting: Lighting) -> Option<Light<S>> {
        let position = exact_vector(light.position()) - self.camera;
        let shadows = lighting == Lighting::Shadowed;
        let (mut occluders, mut edges) = (vec![], vec![]);
        for sphere in self.spheres.iter().filter(|_| shadows) {
            match (side(sphere.power), side(sphere.power_of(position))) {
                (1, -1) | (-1, 1) => return None,
                (-1, _) | (0, 0) => {}
                (0, -1) => edges.push(round::<S>(-sphere.center)),
                (at_camera, _) => {
                    occluders.push(sphere.occluder(position));
                    if at_camera == 0 {
                        edges.push(round::<S>(sphere.center));
                    }
                }
            }
        }
        let near = self
            .spheres
            .iter()
            .filter_map(|sphere| sphere.near(position));
        let near = near.collect();
        let mut heights = vec![];
        for plane in &self.planes {
            let height = plane.height_of(position);
            heights.push((number(plane.number), S::from_double_double(height)));
            match (side(-plane.height), side(height)) {
                _ if !shadows => {}
                (1, -1) => return None,
                (0, -1) => edges.push(round::<S>(plane.normal)),
                (0, 1) => edges.push(round::<S>(-plane.normal)),
                _ => {}
            }
        }
        let intensity = exact_vector(light.color()) * exact(light.power());
        let (position, intensity) = (round::<S>(position), round::<S>(intensity));
        Some(Light {
            position,
            intensity,
            heights,
            near,
            occluders,
            edges,
        })
    }
}

impl ExactSphere {
    /// Above 0 for a position outside, below 0 inside.
    fn power_of(&self, position: Exact) -> DoubleDouble {
        let from_center = position - self.center;
        from_center.dot(from_center) - self.radius * self.radius
    }

    /// The sphere, if it is at least 4 times nearer to the light than the camera is.
    fn near<S: Scalar>(&self, light: Exact) -> Option<Near<S>> {
        let to_light = light - self.center;
        let near = to_light.dot(to_light) * 16.0 < light.dot(light);
        let outside = side(self.power) == 1;
        let radius = if outside { self.radius } else { -self.radius };
        near.then(|| Near {
            number: number(self.number),
            to_light: round::<S>(to_light),
            radius: S::from_double_double(radius),
        })
    }

    fn occluder<S: Scalar>(&self, light: Exact) -> Occluder<S> {
        let to_light = light - self.center;
        Occluder {
            center: round::<S>(self.center),
            radius_squared: S::from_double_double(self.radius * self.radius),
            number: number(self.number),
            to_light: round::<S>(to_light),
            to_light_squared: S::from_double_double(to_light.dot(to_light)),
        }
    }

    fn round<S: Scalar>(&self) -> Sphere<S> {
        let curvature = exact(1.0) / self.radius;
        let outside = side(self.power) == 1;
        Sphere {
            center: round::<S>(self.center),
            radius_squared: S::from_double_double(self.radius * self.radius),
            curvature: S::from_double_double(if outside { curvature } else { -curvature }),
            power: S::from_double_double(self.power),
            number: number(self.number),
            color: round::<S>(exact_vector(self.color)),
        }
    }
}

impl ExactPlane {
    /// Above 0 for a position on the positive side.
    fn height_of(&self, position: Exact) -> DoubleDouble {
        self.normal.dot(position) - self.height
    }

    /// The plane, unless the camera is on it and cannot see it.
    fn round<S: Scalar>(&self, t_max: DoubleDouble) -> Option<Plane<S>> {
        (side(self.height) != 0).then(|| Plane {
            normal: round::<S>(self.normal),
            height: S::from_double_double(self.height),
            reach: square(t_max / self.height),
            number: number(self.number),
            color: round::<S>(exact_vector(self.color)),
        })
    }
}

/// The sign: -1, 0 or 1.
fn side(value: DoubleDouble) -> i8 {
    match value.partial_cmp(&exact(0.0)) {
        Some(Ordering::Less) => -1,
        Some(Ordering::Greater) => 1,
        _ => 0,
    }
}

/// The square of a length, or of a ratio of lengths; the largest number where it is beyond `f64`.
fn square<S: Scalar>(length: DoubleDouble) -> S {
    let square = length * length;
    if square.is_finite() {
        S::from_double_double(square)
    } else {
        S::MAX
    }
}

/// An object's number as a lane holds it.
fn number<S: Scalar>(number: usize) -> S {
    S::from_f64(number as f64)
}

fn exact(value: f64) -> DoubleDouble {
    DoubleDouble::from_f64(value)
}

fn exact_vector(value: DVec3) -> Exact {
    Vector::constant((), value.to_array())
}

fn round<S: Scalar>(value: Exact) -> S::Vector {
    let [x, y, z] = value.to_array().map(S::from_double_double);
    S::Vector::new(x, y, z)
}
