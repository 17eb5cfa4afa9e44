//! What happens at every pixel of a picture: counts by cause, where a picture shows only colours.

use crate::camera::PerspectiveCamera;
use crate::chain::{Chain, LabChain};
use crate::film::Film;
use crate::integrator::{DirectLighting, Integrator};
use crate::level::Level;
use crate::picture::Size;
use crate::ray::{Ray, Span};
use crate::real::Scalar;
use crate::render::Frame;
use crate::scene::{HitRecord, Scene};
use crate::shadow::ShadowRay;
use crate::shape::Shape;
use crate::vector::Vector;

/// What happens at one pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pixel {
    /// The number of the object it shows; `None`: the background.
    pub object: Option<usize>,
    /// Whether that object is a sphere.
    pub on_sphere: bool,
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
    /// The level of a radiance.
    pub(crate) fn level_of<S: Scalar>(radiance: S::Vector) -> u64 {
        let levels = radiance.to_array().map(|x| (x.to_f64() * 255.0) as u64);
        levels.into_iter().max().unwrap_or(0)
    }

    /// Falsely black: the surface shadows itself and nothing else does.
    pub fn is_acne(&self) -> bool {
        self.blocked_by_itself && !self.blocked_by_another
    }

    /// Whether a light shines on it: it stands before the surface and no other object blocks it.
    pub fn is_lit(&self) -> bool {
        self.faces_light && !self.blocked_by_another
    }

    /// Whether it shows a plane.
    pub fn on_plane(&self) -> bool {
        self.object.is_some() && !self.on_sphere
    }

    /// Whether a component passes 255: it wraps, or is clamped.
    pub fn is_too_bright(&self) -> bool {
        self.level > 255
    }
}

/// What happens at every pixel of a picture, row-major.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Survey {
    size: Size,
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
    /// A plane that a light shines on: it stands before it and no other object blocks it.
    pub lit_plane: usize,
    /// A sphere that a light shines on.
    pub lit_sphere: usize,
    /// A component passed 255 and wrapped.
    pub wrapped: usize,
    /// A plane that falsely shadows itself.
    pub acne_plane: usize,
    /// A sphere that falsely shadows itself.
    pub acne_sphere: usize,
    /// The largest component, in units of a byte.
    pub largest_level: u64,
}

impl Counts {
    /// Counts one more pixel of a picture that this film turns into bytes.
    pub fn add(&mut self, pixel: &Pixel, film: Film) {
        let wrapped = film == Film::Wrap && pixel.is_too_bright();
        self.sphere += usize::from(pixel.on_sphere);
        self.plane += usize::from(pixel.on_plane());
        self.shadowed += usize::from(pixel.blocked_by_another);
        self.lit_plane += usize::from(pixel.is_lit() && pixel.on_plane());
        self.lit_sphere += usize::from(pixel.is_lit() && pixel.on_sphere);
        self.wrapped += usize::from(wrapped);
        self.acne_plane += usize::from(pixel.is_acne() && pixel.on_plane());
        self.acne_sphere += usize::from(pixel.is_acne() && pixel.on_sphere);
        self.largest_level = self.largest_level.max(pixel.level);
    }
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
        visit(scene, camera, size, integrator, |_, _, pixel| {
            pixels.push(pixel);
        });
        Self { size, pixels, film }
    }

    /// The size of the picture.
    pub fn size(&self) -> Size {
        self.size
    }

    /// All pixels, row-major.
    pub fn pixels(&self) -> &[Pixel] {
        &self.pixels
    }

    /// The numbers of pixels.
    pub fn counts(&self) -> Counts {
        let mut counts = Counts::default();
        for pixel in &self.pixels {
            counts.add(pixel, self.film);
        }
        counts
    }
}

/// Follows the ray of every pixel and hands it over with its column and row, row-major; keeps none.
pub(crate) fn visit<S: Scalar>(
    scene: &Scene<S>,
    camera: &PerspectiveCamera<S>,
    size: Size,
    integrator: Integrator,
    mut pixel: impl FnMut(u32, u32, Pixel),
) {
    let chain = LabChain {
        scene,
        camera,
        integrator,
    };
    let frame = Frame::new(&chain, size);
    let mut radiance = vec![scene.background(); size.width() as usize];
    for y in 0..size.height() {
        S::expose(&frame, Level::best(), y..y + 1, &mut radiance);
        let sy = LabChain::coordinate(y, size.height());
        for (x, &radiance) in (0..).zip(&radiance) {
            let ray = camera.ray(LabChain::coordinate(x, size.width()), sy);
            let found = Pixel {
                level: Pixel::level_of::<S>(radiance),
                ..Pixel::default()
            };
            pixel(x, y, follow(scene, &ray, integrator, found));
        }
    }
}

/// What happens along one primary ray, added to what was found.
fn follow<S: Scalar>(
    scene: &Scene<S>,
    ray: &Ray<S>,
    integrator: Integrator,
    found: Pixel,
) -> Pixel {
    let span = Span::new(S::from_f64(0.0), scene.t_max());
    let hit = scene.intersect(ray, &span, integrator.quality());
    if !hit.mask {
        return found;
    }
    let object = hit.object.to_f64() as usize;
    let pixel = Pixel {
        object: Some(object),
        on_sphere: object < scene.spheres().len(),
        ..found
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
