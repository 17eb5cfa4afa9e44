//! The strategies, and what each of them says of every pixel.

use crate::case::{self, Case};
use crate::error::Result;
use crate::truth;
use ombrage::{
    Chain, HitRecord, Integrator, LabChain, Lighting, Pixel, Quality, Relative, Scalar, Scene,
    Shadow, ShadowRay, Shape, Span, Vector,
};

/// A way to tell whether a light reaches a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Strategy {
    /// The lab's chain, with shadow rays that leave their surface in this way.
    Lab(Shadow),
    /// The kit's default, the ray-relative chain: by the sides of surfaces.
    Sidedness,
}

impl Strategy {
    /// All of them, in the order of the tables.
    pub fn all() -> Vec<Strategy> {
        let lab = Shadow::ALL.into_iter().map(Strategy::Lab);
        lab.chain([Strategy::Sidedness]).collect()
    }

    /// The name, as tables give it.
    pub fn name(self) -> String {
        match self {
            Strategy::Lab(shadow) => shadow.name(),
            Strategy::Sidedness => "sidedness".into(),
        }
    }
}

/// What the camera sees in the lab's chain: the part that all of its strategies share.
pub struct Hits<S: Scalar> {
    scene: Scene<S>,
    quality: Quality,
    surfaces: Vec<usize>,
    hits: Vec<HitRecord<S>>,
}

impl<S: Scalar> Hits<S> {
    /// The nearest hit of every pixel, row-major.
    ///
    /// # Errors
    /// If the case is invalid in this format.
    pub fn new(case: &Case, quality: Quality) -> Result<Self> {
        let scene = case.scene.cast::<S>()?;
        let camera = case.camera::<S>()?;
        let span = Span::new(S::from_f64(0.0), scene.t_max());
        let size = case.size;
        let mut hits = Vec::with_capacity(size.pixels());
        for row in 0..size.height() {
            let down = LabChain::coordinate(row, size.height());
            for column in 0..size.width() {
                let across = LabChain::coordinate(column, size.width());
                let ray = camera.ray::<S>(across, down);
                hits.push(scene.intersect(&ray, &span, quality));
            }
        }
        Ok(Self {
            surfaces: truth::surfaces(&case.scene),
            scene,
            quality,
            hits,
        })
    }

    /// What a strategy says of every pixel, with objects that are equal counted as one surface;
    /// without one, nothing blocks.
    pub fn verdicts(&self, shadow: Option<Shadow>) -> impl Iterator<Item = Pixel> {
        self.hits.iter().map(move |hit| self.verdict(hit, shadow))
    }

    /// A task that casts every shadow ray once, for its time to be taken, and how many there are.
    pub fn cast(&self, shadow: Shadow) -> (Box<dyn FnMut() + '_>, usize) {
        let mut aims = vec![];
        for light in self.scene.lights() {
            for hit in self.hits.iter().filter(|hit| hit.mask) {
                let sample = light.sample::<S>(hit.point, self.quality);
                if hit.normal.dot(sample.direction).gt(S::from_f64(0.0)) {
                    aims.push((*hit, sample.direction, sample.distance));
                }
            }
        }
        let rays = aims.len();
        let task = move || {
            let mut blocked = 0;
            for (hit, direction, distance) in &aims {
                let ShadowRay { ray, span, skip } =
                    shadow.ray(&self.scene, hit, *direction, *distance);
                let blocks = self.scene.intersect_other(&ray, &span, self.quality, skip);
                blocked += usize::from(blocks);
            }
            std::hint::black_box(blocked);
        };
        (Box::new(task), rays)
    }

    /// What it says of a pixel whose camera ray hit this.
    fn verdict(&self, hit: &HitRecord<S>, shadow: Option<Shadow>) -> Pixel {
        if !hit.mask {
            return Pixel::default();
        }
        let object = hit.object.to_f64() as usize;
        let own = self.surfaces[object];
        let mut pixel = Pixel {
            object: Some(own),
            on_sphere: object < self.scene.spheres().len(),
            ..Pixel::default()
        };
        for light in self.scene.lights() {
            let sample = light.sample::<S>(hit.point, self.quality);
            if !hit.normal.dot(sample.direction).gt(S::from_f64(0.0)) {
                continue;
            }
            pixel.faces_light = true;
            if let Some(shadow) = shadow {
                let ray = shadow.ray(&self.scene, hit, sample.direction, sample.distance);
                self.ask(&ray, own, &mut pixel);
            }
        }
        pixel
    }

    /// Asks every object whether it blocks a shadow ray that leaves the surface `own`.
    fn ask(&self, shadow: &ShadowRay<S>, own: usize, pixel: &mut Pixel) {
        let ShadowRay { ray, span, skip } = shadow;
        let skip = skip.map(|number| number.to_f64() as usize);
        let spheres = self.scene.spheres().iter();
        let spheres = spheres.map(|s| s.shape.intersect_any::<S>(ray, span, self.quality));
        let planes = self.scene.planes().iter();
        let planes = planes.map(|p| p.shape.intersect_any::<S>(ray, span, self.quality));
        for (object, blocks) in spheres.chain(planes).enumerate() {
            if !blocks || Some(object) == skip {
                continue;
            }
            if self.surfaces[object] == own {
                pixel.blocked_by_itself = true;
            } else {
                pixel.blocked_by_another = true;
            }
        }
    }
}

/// What the ray-relative chain says of every pixel.
///
/// # Errors
/// If the view is invalid.
pub fn by_sidedness<S: Scalar>(case: &Case, lighting: Lighting) -> Result<Vec<Pixel>> {
    let size = case.size;
    let chain = Relative::<S>::new(&case.scene, &case.view, size, lighting)?;
    let surfaces = truth::surfaces(&case.scene);
    let mut pixels = Vec::with_capacity(size.pixels());
    for row in 0..size.height() {
        let down = Relative::<S>::coordinate(row, size.height());
        for column in 0..size.width() {
            let across = Relative::<S>::coordinate(column, size.width());
            let mut pixel = chain.follow(across, down);
            pixel.object = pixel.object.map(|object| surfaces[object]);
            pixels.push(pixel);
        }
    }
    Ok(pixels)
}

/// A task that computes a picture, for its time to be taken: in the lab's chain, or, without an
/// integrator, in the ray-relative chain.
///
/// # Errors
/// If the case is invalid in this format.
pub fn draw<S: Scalar>(
    case: &Case,
    integrator: Option<Integrator>,
    lighting: Lighting,
) -> Result<Box<dyn FnMut()>> {
    let size = case.size;
    if let Some(integrator) = integrator {
        let (scene, camera) = (case.scene.cast::<S>()?, case.camera::<S>()?);
        return Ok(Box::new(move || {
            let (scene, camera) = (&scene, &camera);
            let chain = LabChain {
                scene,
                camera,
                integrator,
            };
            std::hint::black_box(case::radiance(&chain, size));
        }));
    }
    let chain = Relative::<S>::new(&case.scene, &case.view, size, lighting)?;
    Ok(Box::new(move || {
        std::hint::black_box(case::radiance(&chain, size));
    }))
}
