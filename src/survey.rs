//! What happens at every pixel of a picture: counts by cause, where a picture shows only colours.

use crate::camera::PerspectiveCamera;
use crate::film::Film;
use crate::integrator::{DirectLighting, Integrator};
use crate::picture::Size;
use crate::ray::{Ray, Span};
use crate::real::Scalar;
use crate::render::position;
use crate::scene::{HitRecord, Scene};
use crate::shadow::ShadowRay;
use crate::shape::Shape;
use crate::vector::Vector;

/// What happens at one pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pixel {
    /// The number of the object it shows; `None`: the background.
    pub object: Option<usize>,
    /// Whether a light stands before the surface: dot(normal, to light) > 0.
    pub faces_light: bool,
    /// Whether a shadow ray met the surface it started on: acne, unless another object blocks too.
    pub blocked_by_itself: bool,
    /// Whether a shadow ray met another object: shadow.
    pub blocked_by_another: bool,
    /// The largest component before it became a byte, in units of a byte: floor(255 x).
    pub level: u64,
}

impl Pixel {
    /// Falsely black: the surface shadows itself and nothing else does.
    pub fn is_acne(&self) -> bool {
        self.blocked_by_itself && !self.blocked_by_another
    }
}

/// What happens at every pixel of a picture, row-major.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Survey {
    size: Size,
    spheres: usize,
    pixels: Vec<Pixel>,
    film: Film,
}

/// How many pixels of a picture are what.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// They show a sphere.
    pub sphere: usize,
    /// They show a plane.
    pub plane: usize,
    /// Another object blocks a light that stands before the surface.
    pub shadowed: usize,
    /// A component passed 255 and wrapped.
    pub wrapped: usize,
    /// A plane that falsely shadows itself.
    pub acne_plane: usize,
    /// A sphere that falsely shadows itself.
    pub acne_sphere: usize,
    /// The largest component, in units of a byte.
    pub largest_level: u64,
}

impl Survey {
    /// Follows the ray of every pixel, as [`render`](crate::render::render) does.
    pub fn new<S: Scalar>(
        scene: &Scene<S>,
        camera: &PerspectiveCamera<S>,
        size: Size,
        integrator: Integrator,
        film: Film,
    ) -> Self {
        let mut pixels = Vec::with_capacity(size.pixels());
        for y in 0..size.height() {
            let sy = position(y, size.height());
            for x in 0..size.width() {
                let ray = camera.ray(position(x, size.width()), sy);
                pixels.push(follow(scene, &ray, integrator));
            }
        }
        Self {
            size,
            spheres: scene.spheres().len(),
            pixels,
            film,
        }
    }

    /// The size of the picture.
    pub fn size(&self) -> Size {
        self.size
    }

    /// All pixels, row-major.
    pub fn pixels(&self) -> &[Pixel] {
        &self.pixels
    }

    /// Whether the pixel shows a sphere; false on a plane and on the background.
    pub fn shows_sphere(&self, pixel: &Pixel) -> bool {
        pixel.object.is_some_and(|object| object < self.spheres)
    }

    /// Whether the pixel shows a plane.
    pub fn shows_plane(&self, pixel: &Pixel) -> bool {
        pixel.object.is_some_and(|object| object >= self.spheres)
    }

    /// Whether a component of the pixel passed 255 and wrapped.
    pub fn is_wrapped(&self, pixel: &Pixel) -> bool {
        self.film == Film::Wrap && pixel.level > 255
    }

    /// The numbers of pixels.
    pub fn counts(&self) -> Counts {
        let count =
            |is: &dyn Fn(&Pixel) -> bool| self.pixels.iter().filter(|pixel| is(pixel)).count();
        Counts {
            sphere: count(&|p| self.shows_sphere(p)),
            plane: count(&|p| self.shows_plane(p)),
            shadowed: count(&|p| p.blocked_by_another),
            wrapped: count(&|p| self.is_wrapped(p)),
            acne_plane: count(&|p| p.is_acne() && self.shows_plane(p)),
            acne_sphere: count(&|p| p.is_acne() && self.shows_sphere(p)),
            largest_level: self.pixels.iter().map(|p| p.level).max().unwrap_or(0),
        }
    }
}

/// What happens along one primary ray.
fn follow<S: Scalar>(scene: &Scene<S>, ray: &Ray<S>, integrator: Integrator) -> Pixel {
    let brightest = integrator
        .radiance(scene, ray)
        .to_array()
        .map(|x| (x.to_f64() * 255.0) as u64);
    let level = brightest.into_iter().max().unwrap_or(0);
    let span = Span::new(S::from_f64(0.0), scene.t_max());
    let hit = scene.intersect(ray, &span, integrator.quality());
    if !hit.mask {
        return Pixel {
            level,
            ..Pixel::default()
        };
    }
    let object = hit.object.to_f64() as usize;
    let pixel = Pixel {
        object: Some(object),
        level,
        ..Pixel::default()
    };
    match integrator {
        Integrator::RayCast(_) => pixel,
        Integrator::DirectLighting(direct) => follow_to_lights(scene, &hit, direct, pixel),
    }
}

/// What happens between a hit point and the lights.
fn follow_to_lights<S: Scalar>(
    scene: &Scene<S>,
    hit: &HitRecord<S>,
    direct: DirectLighting,
    mut pixel: Pixel,
) -> Pixel {
    let own = hit.object.to_f64() as usize;
    for light in scene.lights() {
        let sample = light.sample::<S>(hit.point, direct.quality);
        if !hit.normal.dot(sample.direction).gt(S::from_f64(0.0)) {
            continue;
        }
        pixel.faces_light = true;
        let Some(shadow) = direct.shadow else {
            continue;
        };
        let ShadowRay { ray, span, skip } =
            shadow.ray(scene, hit, sample.direction, sample.distance);
        let skip = skip.map(|number| number.to_f64() as usize);
        let spheres = scene
            .spheres()
            .iter()
            .map(|s| s.shape.intersect_any(&ray, &span, direct.quality));
        let planes = scene
            .planes()
            .iter()
            .map(|p| p.shape.intersect_any(&ray, &span, direct.quality));
        for (object, blocks) in spheres.chain(planes).enumerate() {
            let blocks = blocks && Some(object) != skip;
            pixel.blocked_by_itself |= blocks && object == own;
            pixel.blocked_by_another |= blocks && object != own;
        }
    }
    pixel
}
