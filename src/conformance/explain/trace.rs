//! One pixel's way in one format.

use crate::camera::PerspectiveCamera;
use crate::chain::{Chain, LabChain};
use crate::conformance::shade::Met;
use crate::conformance::surface::Valid;
use crate::film::Film;
use crate::integrator::Integrator;
use crate::light::LightSample;
use crate::picture::Size;
use crate::quality::Quality;
use crate::ray::{Ray, Span};
use crate::real::{DoubleDouble, Scalar};
use crate::scene::{HitRecord, Object, Scene};
use crate::shadow::{Shadow, ShadowRay};
use crate::shape::Shape;
use crate::vector::Vector;

/// Everything that is computed for one pixel, in one format.
#[derive(Clone, Debug)]
pub struct Trace<S: Scalar> {
    /// Where the pixel is in the picture: across and down, from 0 to 1.
    pub place: [S; 2],
    /// The primary ray.
    pub ray: Ray<S>,
    /// Where it meets each object, by number.
    pub hits: Vec<Option<S>>,
    /// What it meets first.
    pub first: Option<First<S>>,
    /// What comes from each light; nothing where nothing is hit, or the light is at the eye.
    pub lights: Vec<FromLight<S>>,
    /// The radiance.
    pub radiance: S::Vector,
    /// Its bytes.
    pub bytes: [u8; 3],
}

/// The hit that is seen.
#[derive(Clone, Copy, Debug)]
pub struct First<S: Scalar> {
    /// The number of the object.
    pub object: usize,
    /// Where the ray meets it.
    pub t: S,
    /// The point.
    pub point: S::Vector,
    /// The unit normal on the side the ray came from.
    pub normal: S::Vector,
}

/// What a hit point receives from a light.
#[derive(Clone, Debug)]
pub struct FromLight<S: Scalar> {
    /// The light's sample.
    pub sample: LightSample<S>,
    /// dot(normal, to light), before it is restricted to 0 and more.
    pub cosine: S,
    /// The objects that each strategy of [`Shadow::ALL`] finds on the way; of the truth, for every
    /// strategy alike, those that stand strictly between.
    pub blockers: Vec<Vec<usize>>,
}

/// How a pixel is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Drawing {
    /// The size of the picture.
    pub size: Size,
    /// Column and row.
    pub pixel: [u32; 2],
    /// How light is summed up.
    pub integrator: Integrator,
    /// How radiance becomes bytes.
    pub film: Film,
}

impl<S: Scalar> Trace<S> {
    /// As the lab's chain computes it.
    pub(super) fn of(scene: &Scene<S>, camera: &PerspectiveCamera<S>, drawing: &Drawing) -> Self {
        let quality = drawing.integrator.quality();
        let mut trace = Self::to_first(scene, camera, drawing, quality, S::from_f64(0.0));
        let span = Span::new(S::from_f64(0.0), scene.t_max());
        let hit = scene.intersect(&trace.ray, &span, quality);
        if let (true, Integrator::DirectLighting(_)) = (hit.mask, drawing.integrator) {
            let lights = scene.lights().iter();
            let from = |sample: LightSample<S>| FromLight {
                cosine: hit.normal.dot(sample.direction),
                blockers: Shadow::ALL
                    .map(|shadow| blockers(scene, &hit, &sample, shadow, quality))
                    .to_vec(),
                sample,
            };
            trace.lights = lights
                .map(|light| from(light.sample::<S>(hit.point, quality)))
                .collect();
        }
        let radiance = drawing.integrator.radiance(scene, &trace.ray);
        trace.develop(radiance, drawing.film);
        trace
    }

    /// Up to what is hit first; hits count from `from` on.
    fn to_first(
        scene: &Scene<S>,
        camera: &PerspectiveCamera<S>,
        drawing: &Drawing,
        quality: Quality,
        from: S,
    ) -> Self {
        let (size, [x, y]) = (drawing.size, drawing.pixel);
        let place = [
            LabChain::coordinate(x, size.width()),
            LabChain::coordinate(y, size.height()),
        ];
        let ray = camera.ray::<S>(place[0], place[1]);
        let span = Span::new(from, scene.t_max());
        let spheres = scene.spheres().iter();
        let spheres = spheres.map(|sphere| sphere.shape.intersect(&ray, &span, quality));
        let planes = scene.planes().iter();
        let planes = planes.map(|plane| plane.shape.intersect(&ray, &span, quality));
        let hit = scene.intersect(&ray, &span, quality);
        Self {
            place,
            hits: spheres
                .chain(planes)
                .map(|hit| hit.mask.then_some(hit.t))
                .collect(),
            first: hit.mask.then(|| First {
                object: hit.object.to_f64() as usize,
                t: hit.distance,
                point: hit.point,
                normal: hit.normal,
            }),
            ray,
            lights: vec![],
            radiance: scene.background(),
            bytes: [0; 3],
        }
    }

    fn develop(&mut self, radiance: S::Vector, film: Film) {
        self.radiance = radiance;
        self.bytes = radiance.to_array().map(|x| film.byte(x).to_f64() as u8);
    }
}

impl Trace<DoubleDouble> {
    /// The truth: every decision in exact arithmetic or by sides, every number in double-double.
    pub(super) fn truth(
        scene: &Scene<DoubleDouble>,
        camera: &PerspectiveCamera<DoubleDouble>,
        drawing: &Drawing,
    ) -> Self {
        // A surface through the camera itself is not seen at t = 0.
        let from = DoubleDouble::from_f64(1e-18);
        let mut trace = Self::to_first(scene, camera, drawing, Quality::Wide, from);
        let Some(first) = trace.first else {
            trace.develop(scene.background(), drawing.film);
            return trace;
        };
        let spheres = scene.spheres().iter();
        let planes = scene.planes().iter();
        let colors: Vec<_> = spheres
            .clone()
            .map(Object::color)
            .chain(planes.clone().map(Object::color))
            .collect();
        let color = colors[first.object];
        let shapes: Vec<Option<Valid<DoubleDouble>>> = spheres
            .map(|sphere| Some(Valid::Sphere(sphere.shape)))
            .chain(planes.map(|plane| Some(Valid::Plane(plane.shape))))
            .collect();
        let same = |number: &usize| shapes[*number] == shapes[first.object];
        let met = Met {
            objects: (0..shapes.len()).filter(same).collect(),
            point: first.point,
            normal: first.normal,
        };
        let zero = DoubleDouble::from_f64(0.0);
        let positive = |x: DoubleDouble| if x > zero { x } else { zero };
        let radiance = match drawing.integrator {
            Integrator::RayCast(_) => color * positive(first.normal.dot(-trace.ray.direction)),
            Integrator::DirectLighting(direct) => {
                let mut sum = Vector::new(zero, zero, zero);
                for light in scene.lights() {
                    let sample = light.sample::<DoubleDouble>(first.point, Quality::Stable);
                    let cosine = first.normal.dot(sample.direction);
                    let blockers: Vec<usize> = match cosine > zero {
                        true => met.blockers(&shapes, light.position()),
                        false => vec![],
                    };
                    if direct.shadow.is_none() || blockers.is_empty() {
                        sum = sum + color * sample.radiance * positive(cosine);
                    }
                    trace.lights.push(FromLight {
                        sample,
                        cosine,
                        blockers: vec![blockers; Shadow::ALL.len()],
                    });
                }
                sum
            }
        };
        trace.develop(radiance, drawing.film);
        trace
    }
}

/// The objects that a strategy's shadow ray finds on its way.
fn blockers<S: Scalar>(
    scene: &Scene<S>,
    hit: &HitRecord<S>,
    sample: &LightSample<S>,
    shadow: Shadow,
    quality: Quality,
) -> Vec<usize> {
    let ShadowRay { ray, span, skip } = shadow.ray(scene, hit, sample.direction, sample.distance);
    let skip = skip.map(|number: S| number.to_f64() as usize);
    let spheres = scene.spheres().iter();
    let spheres = spheres.map(|sphere| sphere.shape.intersect_any(&ray, &span, quality));
    let planes = scene.planes().iter();
    let planes = planes.map(|plane| plane.shape.intersect_any(&ray, &span, quality));
    let all = spheres.chain(planes).enumerate();
    all.filter(|(number, blocks)| *blocks && Some(*number) != skip)
        .map(|(number, _)| number)
        .collect()
}
