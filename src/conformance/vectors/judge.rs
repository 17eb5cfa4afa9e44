//! One answer, judged by the exact truth of its test vector.

use super::Case;
use super::margin::{doubles, format, is_marginal};
use crate::conformance::{Allowed, Answer, Offset, Question, Shaded, Surface};
use crate::float::Float;
use crate::light::LightSample;
use crate::real::Scalar;
use crate::vector::Vector;
use ombrage_oracle::decimal::parse;
use ombrage_oracle::error::{in_ulps, in_units};
use ombrage_oracle::exact::vector;
use ombrage_oracle::offset::Side;
use ombrage_oracle::{Object, Plane, Real, Sphere};
use serde_json::Value;

/// What cannot be right by any tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrong {
    /// A hit where there is none, or none where there is one; lit or dark.
    Decision,
    /// The other root of the sphere.
    Root,
    /// A byte, by so much.
    Byte(u8),
    /// A shadow ray's origin on the surface, or on its other side.
    Side,
    /// A shadow ray's origin too far from its point.
    Far,
    /// Not an answer of this kind.
    Malformed,
}

/// How far an answer is from the truth.
#[derive(Clone, Copy, Debug)]
pub struct Verdict {
    /// What is wrong with it, whatever the tolerance.
    pub wrong: Option<Wrong>,
    /// The largest error of a component in units in the last place of the exact value.
    pub ulps: f64,
    /// The error in a-priori bounds, where the case has one.
    pub bounds: Option<f64>,
}

impl Verdict {
    fn of(wrong: Option<Wrong>) -> Self {
        Self {
            wrong,
            ulps: 0.0,
            bounds: None,
        }
    }

    fn right_if(right: bool, wrong: Wrong) -> Self {
        Self::of((!right).then_some(wrong))
    }
}

/// A decision nearer to another than this many a-priori bounds may fall either way, where the
/// allowed error is one of those bounds: what the stable forms promise.
const MARGIN: f64 = 3.0;

impl Case {
    /// Judges the `out` of an answer.
    pub fn judge(&self, out: &Value) -> Verdict {
        let verdict = match self.float {
            "f32" => self.judge_in::<f32>(out),
            _ => self.judge_in::<f64>(out),
        };
        verdict.unwrap_or(Verdict::of(Some(Wrong::Malformed)))
    }

    /// Whether an answer with this verdict is more wrong than allowed.
    pub fn fails(&self, verdict: &Verdict, allowed: Allowed) -> bool {
        match (allowed, verdict.wrong) {
            (Allowed::Bound(_), Some(Wrong::Decision | Wrong::Root)) => !self.excused(MARGIN),
            (Allowed::Bytes(n), Some(Wrong::Byte(off))) => off > n,
            (_, Some(_)) => true,
            (Allowed::Exact | Allowed::Bytes(_), None) => false,
            (Allowed::CorrectlyRounded, None) => verdict.ulps > 0.5,
            (Allowed::Ulp(n), None) => verdict.ulps > f64::from(n),
            (Allowed::Bound(k), None) => verdict.bounds.is_some_and(|bounds| bounds > f64::from(k)),
        }
    }

    /// Whether a decision is so close that an error of k bounds may change it.
    fn excused(&self, k: f64) -> bool {
        let excused = match self.float {
            "f32" => self.question().map(|question| near::<f32>(&question, k)),
            _ => self.question().map(|question| near::<f64>(&question, k)),
        };
        excused.unwrap_or(false)
    }

    fn judge_in<F: Float>(&self, out: &Value) -> Option<Verdict> {
        let exp = self.truth();
        match Answer::<F>::of(self.kernel, out).ok()? {
            Answer::Hit(t) => hit(exp, t),
            Answer::AnyHit(occluded) => {
                let right = occluded == exp["occluded"]["closed"].as_bool()?;
                Some(Verdict::right_if(right, Wrong::Decision))
            }
            Answer::LightSample(sample) => light_sample(exp, sample),
            Answer::Shade(shaded) => shade(exp, &shaded),
            Answer::Offset(after) => match self.question::<F>().ok()? {
                Question::Offset(question) => Some(offset(&question, after)),
                _ => None,
            },
            Answer::Quantise(byte) => {
                let off = byte.abs_diff(exp["floor"].as_u64()?.try_into().ok()?);
                Some(Verdict::right_if(off == 0, Wrong::Byte(off)))
            }
        }
    }
}

fn near<F: Float>(question: &Question<F>, k: f64) -> bool {
    let (ray, ends, surfaces) = match question {
        Question::Hit { ray, ends, surface } => (ray, ends, std::slice::from_ref(surface)),
        Question::AnyHit {
            ray,
            ends,
            surfaces,
        } => (ray, ends, surfaces.as_slice()),
        _ => return false,
    };
    surfaces
        .iter()
        .any(|surface| is_marginal(ray, *ends, surface, k))
}

/// The exact value of a number of the truth.
fn exact(number: &Value) -> Option<Real> {
    parse(number["dec"].as_str()?).map(Real::from)
}

/// A number of the truth, rounded to the format.
fn rounded<F: Float>(number: &Value) -> Option<f64> {
    super::fields::float::<F>(&number["bits"]).map(Scalar::to_f64)
}

fn hit<F: Float>(exp: &Value, t: Option<F>) -> Option<Verdict> {
    let should_hit = exp["hit"]["closed"].as_bool()?;
    // A hit needs a t that is a number: where the exact one is beyond the format, there is none.
    let beyond = should_hit && rounded::<F>(&exp["t"])?.is_infinite();
    let Some(t) = t.filter(|_| should_hit) else {
        let right = t.is_none() && (!should_hit || beyond);
        return Some(Verdict::right_if(right, Wrong::Decision));
    };
    let t = t.to_f64();
    let truth = exact(&exp["t"])?;
    let format = format::<F>();
    let ulps = in_ulps(t, &truth, format);
    let distance = |root: &Value| Some((t - root["dec"].as_str()?.parse::<f64>().ok()?).abs());
    let other = match exp.get("root") {
        Some(root) if root["closed"] == 0 => distance(&exp["t1"]),
        Some(_) => distance(&exp["t0"]),
        None => None,
    };
    let own = distance(&exp["t"])?;
    let wrong = ulps > 1.0 && other.is_some_and(|other| other < own);
    let units = exp["bound_u"]
        .as_f64()
        .map(|bound| in_units(t, &truth, format) / bound);
    Some(Verdict {
        wrong: wrong.then_some(Wrong::Root),
        ulps,
        bounds: units,
    })
}

/// The largest error of three floats.
fn vector_error<F: Float>(v: F::Vector, exp: &Value) -> Option<f64> {
    let mut largest = 0f64;
    for (x, exp) in v.to_array().into_iter().zip(exp.as_array()?) {
        largest = largest.max(in_ulps(x.to_f64(), &exact(exp)?, format::<F>()));
    }
    Some(largest)
}

fn light_sample<F: Float>(exp: &Value, sample: Option<LightSample<F>>) -> Option<Verdict> {
    let nothing = exp.get("dir").is_none_or(Value::is_null);
    let Some(sample) = sample.filter(|_| !nothing) else {
        let right = sample.is_none() && nothing;
        return Some(Verdict::right_if(right, Wrong::Decision));
    };
    let distance = sample.distance.to_f64();
    let errors = [
        in_ulps(distance, &exact(&exp["dist"])?, format::<F>()),
        vector_error::<F>(sample.direction, &exp["dir"])?,
        vector_error::<F>(sample.radiance, &exp["radiance"])?,
    ];
    Some(Verdict {
        wrong: None,
        ulps: errors.into_iter().fold(0.0, f64::max),
        bounds: None,
    })
}

fn shade<F: Float>(exp: &Value, shaded: &Shaded<F>) -> Option<Verdict> {
    let dark = shaded.li.to_array().map(|x| x.to_f64() == 0.0);
    let truth = exp["li"].as_array()?.iter();
    let truth: Option<Vec<bool>> = truth.map(|x| Some(rounded::<F>(x)? == 0.0)).collect();
    let mut off = 0;
    for (byte, exp) in shaded.bytes.into_iter().zip(exp["byte"].as_array()?) {
        off = off.max(byte.abs_diff(exp.as_u64()?.try_into().ok()?));
    }
    let wrong = if dark.into_iter().all(|dark| dark) != truth?.into_iter().all(|dark| dark) {
        Some(Wrong::Decision)
    } else {
        (off > 0).then_some(Wrong::Byte(off))
    };
    Some(Verdict {
        wrong,
        ulps: vector_error::<F>(shaded.li, &exp["li"])?,
        bounds: None,
    })
}

/// The way a shadow ray's origin may move, over max(1, |p|): 1e-3 in f32, 1e-9 in f64.
fn reach<F: Float>() -> f64 {
    if F::PRECISION == f32::MANTISSA_DIGITS {
        1e-3
    } else {
        1e-9
    }
}

fn offset<F: Float>(question: &Offset<F>, after: F::Vector) -> Verdict {
    let object = match question.surface {
        Surface::Plane { point, normal } => {
            Plane::new(doubles::<F>(point), doubles::<F>(normal)).map(Object::Plane)
        }
        Surface::Sphere { center, radius } => {
            Sphere::new(doubles::<F>(center), radius.to_f64()).map(Object::Sphere)
        }
    };
    let [origin, direction] = [question.ray.origin, question.ray.direction].map(doubles::<F>);
    let side = object
        .as_ref()
        .and_then(|object| Side::seen_by(object, origin, direction));
    let [before, after] = [question.point, after].map(doubles::<F>);
    let above = |side: Side| vector(after).is_some_and(|after| side.height(&after).sign() > 0);
    if !side.is_none_or(above) {
        return Verdict::of(Some(Wrong::Side));
    }
    let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let moved = length([0, 1, 2].map(|i| after[i] - before[i]));
    let near = moved <= reach::<F>() * length(before).max(1.0);
    Verdict::right_if(near, Wrong::Far)
}
