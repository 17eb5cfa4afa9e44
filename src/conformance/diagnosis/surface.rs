//! What each pixel shows, as far as it does not depend on light, colour and film.

use super::recipe::{ShadowRay, Viewpoint};
use crate::camera::{PerspectiveCamera, View};
use crate::error::Invalid;
use crate::lab;
use crate::light::PointLight;
use crate::picture::Size;
use crate::quality::Quality;
use crate::ray::{Ray, Span};
use crate::scene::{HitRecord, Scene};
use glam::{DVec3, dvec3};

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Object {
    Background,
    Sphere,
    Plane,
}

impl Object {
    /// Its place in lists of sphere and plane.
    pub fn index(self) -> Option<usize> {
        match self {
            Object::Background => None,
            Object::Sphere => Some(0),
            Object::Plane => Some(1),
        }
    }
}

/// One ray's hit, as far as shading needs it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surfel {
    pub object: Object,
    /// Whether something else stands between it and the light.
    pub is_shadowed: bool,
    /// `dot(normal, to light)`; the normal faces the camera.
    pub cosine: f32,
    /// To the light, in scene units.
    pub distance: f32,
    /// `dot(normal, to camera)`.
    pub slope: f32,
}

const NOTHING: Surfel = Surfel {
    object: Object::Background,
    is_shadowed: false,
    cosine: 0.0,
    distance: 1.0,
    slope: 0.0,
};

/// The surfels of a region's pixels, row-major; a pixel has one, or several to be averaged.
#[derive(Debug)]
pub(super) struct Surfels {
    surfels: Vec<Surfel>,
    /// Where each pixel's surfels end.
    ends: Vec<u32>,
}

impl Surfels {
    /// The surfels of each pixel.
    pub fn pixels(&self) -> impl Iterator<Item = &[Surfel]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        let range = starts.zip(&self.ends);
        range.map(|(start, &end)| &self.surfels[start as usize..end as usize])
    }
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// Its first column.
    pub left: u32,
    /// Its first row.
    pub top: u32,
    /// Its columns.
    pub width: u32,
    /// Its rows.
    pub height: u32,
}

impl Region {
    /// Its pixels, row-major.
    pub(super) fn pixels(self) -> impl Iterator<Item = (u32, u32)> {
        let rows = self.top..self.top + self.height;
        let columns = move || self.left..self.left + self.width;
        rows.flat_map(move |y| columns().map(move |x| (x, y)))
    }

    /// Whether two rectangles have a pixel in common, or touch.
    pub(super) fn meets(self, other: Region) -> bool {
        let apart = |a: u32, width: u32, b: u32| a + width < b;
        !apart(self.left, self.width, other.left)
            && !apart(other.left, other.width, self.left)
            && !apart(self.top, self.height, other.top)
            && !apart(other.top, other.height, self.top)
    }
}

/// Rays a side of a pixel that is averaged where it is not of one piece.
const SIDE: u32 = 4;

/// The lab's scene as one viewpoint sees it.
pub(super) struct Eye {
    scene: Scene<f64>,
    light: PointLight<f64>,
    camera: PerspectiveCamera<f64>,
    viewpoint: Viewpoint,
    size: Size,
}

impl Eye {
    pub fn new(viewpoint: &Viewpoint, size: Size) -> Result<Self, Invalid> {
        let lab = lab::scene::<f64>()?;
        let mut scene = Scene::new(lab.background(), viewpoint.t_max)?;
        for sphere in lab.spheres() {
            scene = scene.with_sphere(sphere.shape, sphere.color())?;
        }
        for plane in lab.planes().iter().filter(|_| viewpoint.has_plane) {
            scene = scene.with_plane(plane.shape, plane.color())?;
        }
        let light = match lab.lights() {
            [light, ..] => *light,
            [] => PointLight::new(DVec3::ZERO, DVec3::ONE, 0.0)?,
        };
        let fov = viewpoint.fov;
        let view = View {
            fov,
            ..lab::view::<f64>()
        };
        Ok(Self {
            scene,
            light,
            camera: PerspectiveCamera::new(&view, size.aspect())?,
            viewpoint: *viewpoint,
            size,
        })
    }

    /// Adds the surfels of a region.
    pub fn see(&self, region: Region, surfels: &mut Surfels) {
        for (x, y) in region.pixels() {
            self.pixel(x, y, surfels);
        }
    }

    fn pixel(&self, x: u32, y: u32, out: &mut Surfels) {
        if self.viewpoint.sampling.is_average() && !self.is_of_one_piece(x, y) {
            for row in 0..SIDE {
                for column in 0..SIDE {
                    let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(SIDE);
                    out.surfels
                        .push(self.surfel(x, y, [middle(column), middle(row)]));
                }
            }
        } else {
            out.surfels.push(self.surfel(x, y, [0.5, 0.5]));
        }
        out.ends.push(out.surfels.len() as u32);
    }

    /// Whether the corners of a pixel show one surface, in one light, with radiance that hardly
    /// differs: then its middle is the average.
    fn is_of_one_piece(&self, x: u32, y: u32) -> bool {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let [first, rest @ ..] = corners.map(|within| self.surfel(x, y, within));
        let radiance = |s: &Surfel| s.cosine / (s.distance * s.distance);
        rest.iter().all(|other| {
            other.object == first.object
                && other.is_shadowed == first.is_shadowed
                && (other.cosine > 0.0) == (first.cosine > 0.0)
                && (radiance(other) - radiance(&first)).abs() <= 0.1 * radiance(&first).abs()
        })
    }

    /// What the ray through a point within a pixel meets.
    fn surfel(&self, x: u32, y: u32, within: [f64; 2]) -> Surfel {
        let view = &self.viewpoint;
        let across = view.sampling.place(x, self.size.width(), within[0]);
        let down = view.sampling.place(y, self.size.height(), within[1]);
        let turned = |place: f64, turn: bool| if turn { 1.0 - place } else { place };
        let ray: Ray<f64> = self.camera.ray(
            turned(across, view.mirrored),
            turned(down, view.upside_down),
        );
        let span = Span::new(0.0, self.scene.t_max());
        let hit = self.scene.intersect(&ray, &span, Quality::Stable);
        if !hit.mask {
            return NOTHING;
        }
        let sample = self.light.sample::<f64>(hit.point, Quality::Stable);
        Surfel {
            object: if hit.object < 1.0 {
                Object::Sphere
            } else {
                Object::Plane
            },
            is_shadowed: view.shadow.is_some_and(|ray| self.is_shadowed(&hit, ray)),
            cosine: hit.normal.dot(sample.direction) as f32,
            distance: sample.distance as f32,
            slope: -hit.normal.dot(ray.direction) as f32,
        }
    }

    /// Whether anything blocks the light. A ray from the very surface never meets it again, since
    /// both shapes are convex; one that starts elsewhere asks that surface too.
    fn is_shadowed(&self, hit: &HitRecord<f64>, from: ShadowRay) -> bool {
        let [along_x, along_z] = from.light;
        let light = self.light.position() + dvec3(along_x, 0.0, along_z);
        let shift = dvec3(from.shift[0], 0.0, from.shift[1]);
        let origin = hit.point + hit.normal * from.offset + shift;
        // The light is where the parameter is 1.
        let direction = light - origin;
        let ray = Ray { origin, direction };
        if from.is_exact() {
            let span = Span::new(0.0, 1.0);
            self.scene
                .intersect_other(&ray, &span, Quality::Stable, Some(hit.object))
        } else {
            let span = Span::new(BEYOND_ROUNDING, 1.0);
            self.scene.intersect_any(&ray, &span, Quality::Stable)
        }
    }
}

/// A part of the way to the light that rounding in `f64` does not reach in the lab's scene.
const BEYOND_ROUNDING: f64 = 1e-8;

/// The surfels of some regions, one after the other.
pub(super) fn surfels(
    viewpoint: &Viewpoint,
    size: Size,
    regions: &[Region],
) -> Result<Surfels, Invalid> {
    let eye = Eye::new(viewpoint, size)?;
    let mut surfels = Surfels {
        surfels: vec![],
        ends: vec![],
    };
    for &region in regions {
        eye.see(region, &mut surfels);
    }
    Ok(surfels)
}
