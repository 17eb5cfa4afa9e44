//! Once a frame: the scene relative to its camera, in numbers that are exact or nearly so.

use super::light::{Light, Near, Occluder};
use super::sphere::Sphere;
use super::{Lighting, Plane, Relative};
use crate::camera::{Axes, View};
use crate::error::Invalid;
use crate::light::PointLight;
use crate::picture::Size;
use crate::quality::Scale;
use crate::real::{Constant, DoubleDouble, Precise, Scalar};
use crate::scene::{Object, Scene};
use crate::shape;
use crate::vector::Vector;
use glam::DVec3;
use std::cmp::Ordering;
use std::collections::HashSet;

/// Objects are told apart by a number that `f32` must hold exactly.
const MOST_OBJECTS: usize = 1 << 24;

impl<S: Scalar> Relative<S> {
    /// The scene as a camera with this view sees it in a picture of this size.
    ///
    /// Scene and view are taken as exact; what is rounded to `S` is the scene relative to the
    /// camera, computed in double-double.
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
        let wide = Relative::<DoubleDouble>::of(scene, view, size, lighting)?;
        let square = |square: DoubleDouble| match square.is_finite() {
            true => S::from_double_double(square),
            false => S::MAX,
        };
        Ok(Self {
            endless: false,
            ..wide.map(S::from_double_double, square)
        })
    }
}

impl<T: Precise> Relative<T> {
    /// The same before it is rounded.
    pub(crate) fn of(
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
        let axes = axes::<T>(view, size)?;
        let t_max = T::from_f64(scene.t_max());
        let surfaces = Surfaces::new(scene, view.position);
        let lights = || scene.lights().iter();
        let lights = || lights().filter_map(|light| surfaces.light(light, lighting));
        Ok(Self {
            forward: axes.forward,
            right: axes.right,
            up: axes.up,
            lights: (lighting != Lighting::Eye).then(|| lights().collect()),
            spheres: surfaces.spheres.iter().map(Ball::prepared).collect(),
            first_plane: scene.spheres().len(),
            planes: surfaces
                .planes
                .iter()
                .filter_map(|plane| plane.prepared(t_max))
                .collect(),
            background: vector::<T>(scene.background()),
            t_max_squared: t_max * t_max,
            endless: scene.t_max().is_infinite(),
        })
    }
}

/// The viewport's axes.
fn axes<T: Precise>(view: &View<f64>, size: Size) -> Result<Axes<T>, Invalid> {
    view.cast::<DoubleDouble>()
        .axes(DoubleDouble::from_f64(size.aspect()))?;
    let [width, height] = [size.width(), size.height()].map(|n| T::from_f64(f64::from(n)));
    let [position, look_at, up] = [view.position, view.look_at, view.up].map(vector::<T>);
    let backward = unit::<T>(position - look_at);
    let right = unit::<T>(unit::<T>(up).cross(backward));
    Ok(Axes::new(
        backward,
        right,
        T::half_tangent(view.fov),
        width / height,
    ))
}

/// The unit vector of the same direction, whatever the length.
fn unit<T: Precise>(vector: T::Vector) -> T::Vector {
    let [x, y, z] = vector.to_array().map(T::near);
    let scale = Scale::of([x, y, z, z]).reciprocal;
    (vector * T::from_f64(scale)).normalized()
}

/// A sphere relative to the camera.
struct Ball<'a, T: Precise> {
    object: &'a Object<f64, shape::Sphere<f64>>,
    number: usize,
    center: T::Vector,
    radius: T,
    /// On which side the camera is.
    camera: Ordering,
}

/// A plane relative to the camera, which is on its positive side or on it.
struct Wall<'a, T: Precise> {
    object: &'a Object<f64, shape::Plane<f64>>,
    number: usize,
    /// Whether the scene's own normal shows away from the camera.
    turned: bool,
    camera: Ordering,
    normal: T::Vector,
    /// `dot(normal, x)` for its points x: 0 or below.
    height: T,
}

/// All surfaces of a scene relative to the camera. Of equal ones only the first: the others are
/// never seen, and shade what it shades.
struct Surfaces<'a, T: Precise> {
    camera: DVec3,
    spheres: Vec<Ball<'a, T>>,
    planes: Vec<Wall<'a, T>>,
}

impl<'a, T: Precise> Surfaces<'a, T> {
    fn new(scene: &'a Scene<f64>, camera: DVec3) -> Self {
        let mut known = HashSet::new();
        let spheres = (0..).zip(scene.spheres()).filter(|(_, sphere)| {
            let (center, radius) = (sphere.shape.center(), sphere.shape.radius());
            // -0 and 0 are one place.
            known.insert([center.x, center.y, center.z, radius].map(|x| (x + 0.0).to_bits()))
        });
        let mut planes: Vec<Wall<'a, T>> = vec![];
        for (number, object) in (scene.spheres().len()..).zip(scene.planes()) {
            let equal = |other: &Wall<T>| other.object.shape.coincides_with(&object.shape);
            if !planes.iter().any(equal) {
                planes.push(Wall::new(object, number, camera));
            }
        }
        Self {
            camera,
            spheres: spheres
                .map(|(number, object)| Ball::new(object, number, camera))
                .collect(),
            planes,
        }
    }

    /// A light, unless a surface separates it from the camera and shadows are wanted.
    fn light(&self, light: &PointLight<f64>, lighting: Lighting) -> Option<Light<T>> {
        use Ordering::{Equal, Greater, Less};
        let position = vector::<T>(light.position()) - vector::<T>(self.camera);
        let shadows = lighting == Lighting::Shadowed;
        let (mut occluders, mut edges) = (vec![], vec![]);
        for sphere in self.spheres.iter().filter(|_| shadows) {
            match (sphere.camera, sphere.object.shape.side(light.position())) {
                (Greater, Less) | (Less, Greater) => return None,
                (Less, _) | (Equal, Equal) => {}
                (Equal, Less) => edges.push(-sphere.center),
                (at_camera, _) => {
                    occluders.push(sphere.occluder(position));
                    if at_camera == Equal {
                        edges.push(sphere.center);
                    }
                }
            }
        }
        let near = self.spheres.iter();
        let near = near.filter_map(|sphere| sphere.near(position)).collect();
        let mut heights = vec![];
        for plane in &self.planes {
            let side = plane.side_of(light.position());
            heights.push((number(plane.number), plane.height_of(position, side)));
            match (plane.camera, side) {
                _ if !shadows => {}
                (Greater, Less) => return None,
                (Equal, Less) => edges.push(plane.normal),
                (Equal, Greater) => edges.push(-plane.normal),
                _ => {}
            }
        }
        Some(Light {
            position,
            intensity: vector::<T>(light.color()) * T::from_f64(light.power()),
            heights,
            near,
            occluders,
            edges,
        })
    }
}

impl<'a, T: Precise> Ball<'a, T> {
    fn new(object: &'a Object<f64, shape::Sphere<f64>>, number: usize, camera: DVec3) -> Self {
        Self {
            object,
            number,
            center: vector::<T>(object.shape.center()) - vector::<T>(camera),
            radius: T::from_f64(object.shape.radius()),
            camera: object.shape.side(camera),
        }
    }

    /// The sphere, if it is at least 4 times nearer to the light than the camera is.
    fn near(&self, light: T::Vector) -> Option<Near<T>> {
        let to_light = light - self.center;
        let squared = |v: T::Vector| v.dot(v).near();
        let outside = self.camera == Ordering::Greater;
        (squared(to_light) * 16.0 < squared(light)).then(|| Near {
            number: number(self.number),
            to_light,
            radius: if outside { self.radius } else { -self.radius },
        })
    }

    fn occluder(&self, light: T::Vector) -> Occluder<T> {
        let to_light = light - self.center;
        Occluder {
            center: self.center,
            radius_squared: self.radius * self.radius,
            number: number(self.number),
            to_light,
            to_light_squared: to_light.dot(to_light),
        }
    }

    fn prepared(&self) -> Sphere<T> {
        let curvature = T::from_f64(1.0) / self.radius;
        let radius_squared = self.radius * self.radius;
        let outside = self.camera == Ordering::Greater;
        Sphere {
            center: self.center,
            radius_squared,
            curvature: if outside { curvature } else { -curvature },
            power: self.center.dot(self.center) - radius_squared,
            camera: self.camera,
            number: number(self.number),
            color: vector::<T>(self.object.color()),
        }
    }
}

impl<'a, T: Precise> Wall<'a, T> {
    fn new(object: &'a Object<f64, shape::Plane<f64>>, number: usize, camera: DVec3) -> Self {
        let side = object.shape.side(camera);
        let normal = vector::<T>(object.shape.normal()).normalized();
        let height = (vector::<T>(object.shape.point()) - vector::<T>(camera)).dot(normal);
        let turned = side == Ordering::Less;
        Self {
            object,
            number,
            turned,
            camera: if turned { side.reverse() } else { side },
            normal: if turned { -normal } else { normal },
            height: if turned { -height } else { height },
        }
    }

    /// On which side a position is; the camera's is the greater.
    fn side_of(&self, position: DVec3) -> Ordering {
        let side = self.object.shape.side(position);
        if self.turned { side.reverse() } else { side }
    }

    /// The height of a position relative to the camera, which is on the side given.
    fn height_of(&self, position: T::Vector, side: Ordering) -> T {
        match side {
            Ordering::Equal => T::from_f64(0.0),
            _ => self.normal.dot(position) - self.height,
        }
    }

    /// The plane, unless the camera is on it and cannot see it.
    fn prepared(&self, t_max: T) -> Option<Plane<T>> {
        let reach = t_max / self.height;
        (self.camera != Ordering::Equal).then(|| Plane {
            normal: self.normal,
            height: self.height,
            reach: reach * reach,
            number: number(self.number),
            color: vector::<T>(self.object.color()),
        })
    }
}

/// An object's number as a lane holds it.
fn number<T: Constant>(number: usize) -> T {
    T::from_f64(number as f64)
}

fn vector<T: Constant>(value: DVec3) -> T::Vector {
    let [x, y, z] = value.to_array().map(T::from_f64);
    T::Vector::new(x, y, z)
}
