//! One pixel's way from ray to byte, in `f32`, in `f64` and in truth.
//!
//! The lab's chain is followed as it is: the numbers of `f32` and `f64` are those that its kernels
//! compute. The truth is computed in double-double from the scene as it is written, with decisions
//! by sides.

mod loss;
mod trace;

pub use loss::Loss;
pub use trace::{Drawing, First, FromLight, Trace};

use crate::camera::{PerspectiveCamera, View};
use crate::error::Invalid;
use crate::float::Float;
use crate::real::{DoubleDouble, Real, Scalar};
use crate::scene::Scene;
use crate::vector::Vector;

/// One pixel's way.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// In `f32`: the scene rounded to it, then everything computed in it.
    pub single: Trace<f32>,
    /// In `f64`.
    pub double: Trace<f64>,
    /// In truth.
    pub truth: Trace<DoubleDouble>,
    scene: Scene<DoubleDouble>,
    drawing: Drawing,
    of_direction: [Option<Loss>; 3],
}

/// A number on the way, three times.
#[derive(Clone, Debug)]
pub struct Step {
    /// What it is: `d.x`, `t sphere 0`, `cos`.
    pub name: String,
    /// In `f32`; `None`: there is no such number, for instance no hit.
    pub single: Option<f32>,
    /// In `f64`.
    pub double: Option<f64>,
    /// In truth.
    pub truth: Option<DoubleDouble>,
    /// Why digits are lost here.
    pub loss: Option<Loss>,
}

/// How near a number is to the truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// The distance in units in the last place of the truth.
    pub ulps: f64,
    /// How many leading bits agree; at most all of the format.
    pub bits: u32,
}

impl Agreement {
    /// Of a number with a truth that is finite.
    pub fn of<F: Float>(computed: F, truth: DoubleDouble) -> Self {
        let error = (computed.to_double_double() - truth).abs();
        let unit = truth.binade().to_f64() * F::EPSILON;
        let smallest = F::MIN_POSITIVE * F::EPSILON;
        let ulps = error.to_f64() / unit.max(smallest);
        let relative = (error / truth).abs().to_f64();
        let bits = match error.to_f64() {
            0.0 => F::PRECISION,
            _ => (-relative.log2()).clamp(0.0, f64::from(F::PRECISION)) as u32,
        };
        Self { ulps, bits }
    }
}

impl Step {
    /// How near `f32` and `f64` are to the truth; `None` where there is nothing to compare.
    pub fn agreement(&self) -> (Option<Agreement>, Option<Agreement>) {
        let truth = self.truth.filter(|truth| truth.is_finite());
        (
            self.single
                .zip(truth)
                .map(|(x, truth)| Agreement::of(x, truth)),
            self.double
                .zip(truth)
                .map(|(x, truth)| Agreement::of(x, truth)),
        )
    }
}

/// Follows a pixel of a scene.
///
/// # Errors
/// If the pixel is not in the picture, or a number of the scene or the view is valid in `f64` but
/// not in `f32`.
pub fn explain(
    scene: &Scene<f64>,
    view: &View<f64>,
    drawing: &Drawing,
) -> Result<Explanation, Invalid> {
    let (size, [x, y]) = (drawing.size, drawing.pixel);
    if x >= size.width() || y >= size.height() {
        return Err(Invalid {
            field: "pixel",
            value: format!("({x}, {y})"),
            must_be: "in the picture: a column and a row, both from 0",
        });
    }
    let exact = scene.cast::<DoubleDouble>()?;
    let truth = Trace::truth(&exact, &camera(view, drawing)?, drawing);
    let axes = view.cast::<DoubleDouble>().axes(aspect(drawing))?;
    Ok(Explanation {
        of_direction: loss::of_view(&axes, truth.place),
        single: Trace::of(&scene.cast()?, &camera(view, drawing)?, drawing),
        double: Trace::of(scene, &camera(view, drawing)?, drawing),
        truth,
        scene: exact,
        drawing: *drawing,
    })
}

fn camera<S: Scalar>(view: &View<f64>, drawing: &Drawing) -> Result<PerspectiveCamera<S>, Invalid> {
    PerspectiveCamera::new(&view.cast(), aspect(drawing))
}

fn aspect<S: Scalar>(drawing: &Drawing) -> S {
    let [width, height] = [drawing.size.width(), drawing.size.height()].map(f64::from);
    S::from_f64(width) / S::from_f64(height)
}

/// The components of an optional vector.
fn components<S: Scalar>(vector: Option<S::Vector>) -> [Option<S>; 3] {
    match vector.map(Vector::to_array) {
        Some(components) => components.map(Some),
        None => [None; 3],
    }
}

/// The steps of one value of all three traces: a number and its name, or three numbers and their
/// names with their losses.
macro_rules! steps {
    ($self:ident, $name:expr, $loss:expr, |$trace:ident| $value:expr) => {
        Step {
            name: $name.into(),
            single: (|$trace: &Trace<f32>| $value)(&$self.single),
            double: (|$trace: &Trace<f64>| $value)(&$self.double),
            truth: (|$trace: &Trace<DoubleDouble>| $value)(&$self.truth),
            loss: $loss,
        }
    };
    ($self:ident, $names:expr; $losses:expr, |$trace:ident| $value:expr) => {{
        let single = components::<f32>((|$trace: &Trace<f32>| $value)(&$self.single));
        let double = components::<f64>((|$trace: &Trace<f64>| $value)(&$self.double));
        let truth = (|$trace: &Trace<DoubleDouble>| $value)(&$self.truth);
        let truth = components::<DoubleDouble>(truth);
        [0, 1, 2].map(|i| Step {
            name: $names[i].into(),
            single: single[i],
            double: double[i],
            truth: truth[i],
            loss: $losses[i],
        })
    }};
}

impl Explanation {
    /// The name of an object: `sphere 0`.
    pub fn object(&self, number: usize) -> String {
        match number < self.scene.spheres().len() {
            true => format!("sphere {number}"),
            false => format!("plane {number}"),
        }
    }

    /// Every number on the way, in order; of the light of this number alone.
    pub fn steps(&self, light: usize) -> Vec<Step> {
        const NONE: [Option<Loss>; 3] = [None; 3];
        let quality = self.drawing.integrator.quality();
        let mut steps = vec![
            steps!(self, "sx", None, |t| Some(t.place[0])),
            steps!(self, "sy", None, |t| Some(t.place[1])),
        ];
        steps.extend(steps!(self, ["o.x", "o.y", "o.z"]; NONE, |t| Some(t.ray.origin)));
        steps.extend(
            steps!(self, ["d.x", "d.y", "d.z"]; self.of_direction, |t| Some(t.ray.direction)),
        );
        for number in 0..self.truth.hits.len() {
            let loss = loss::of_object(&self.truth.ray, &self.scene, number, quality);
            let name = format!("t {}", self.object(number));
            steps.push(steps!(self, name, loss, |t| t.hits[number]));
        }
        steps.extend(self.at_hit());
        steps.extend(self.at_light(light));
        steps.extend(steps!(self, ["L.r", "L.g", "L.b"]; NONE, |t| Some(t.radiance)));
        steps
    }

    /// Which bytes wrap.
    pub fn wraps(&self) -> [Option<Loss>; 3] {
        loss::of_byte(&self.truth, &self.drawing)
    }

    /// The hit point and its normal, if there is one in truth.
    fn at_hit(&self) -> Vec<Step> {
        let Some(first) = &self.truth.first else {
            return vec![];
        };
        let sphere = self.scene.spheres().get(first.object);
        let of_normal = sphere.map(|sphere| loss::of_normal(first, sphere.shape.center()));
        let of_normal = of_normal.unwrap_or_default();
        let of_point = loss::of_point(&self.truth.ray, first);
        let (p, n) = (["p.x", "p.y", "p.z"], ["n.x", "n.y", "n.z"]);
        let mut steps = steps!(self, p; of_point, |t| t.first.map(|first| first.point)).to_vec();
        steps.extend(steps!(self, n; of_normal, |t| t.first.map(|first| first.normal)));
        steps
    }

    /// What comes from a light.
    fn at_light(&self, light: usize) -> Vec<Step> {
        let (Some(from), Some(first)) = (self.truth.lights.get(light), &self.truth.first) else {
            return vec![];
        };
        let losses = loss::of_direction(first, self.scene.lights()[light].position());
        let of_cosine = loss::of_cosine(first.normal, &from.sample);
        let (l, e) = (["l.x", "l.y", "l.z"], ["E.r", "E.g", "E.b"]);
        let mut steps = steps!(self, l; losses, |t| {
            t.lights.get(light).map(|from| from.sample.direction)
        })
        .to_vec();
        steps.push(steps!(self, "distance", None, |t| {
            t.lights.get(light).map(|from| from.sample.distance)
        }));
        steps.extend(steps!(self, e; [None; 3], |t| {
            t.lights.get(light).map(|from| from.sample.radiance)
        }));
        steps.push(steps!(self, "cos", of_cosine, |t| {
            t.lights.get(light).map(|from| from.cosine)
        }));
        steps
    }
}
