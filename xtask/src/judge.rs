//! One answer, judged by the exact truth of its test vector.

use crate::fields::{Fields, float};
use crate::margin::{doubles, format, is_marginal};
use ombrage::Float;
use ombrage::conformance::{Allowed, Kernel, Surface};
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
    /// A byte.
    Byte,
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

/// Judges an answer's `out` to a test vector.
pub fn judge(case: &Value, out: &Value) -> Verdict {
    let verdict = if case["prec"] == "f32" {
        judge_in::<f32>(case, out)
    } else {
        judge_in::<f64>(case, out)
    };
    verdict.unwrap_or(Verdict::of(Some(Wrong::Malformed)))
}

/// A decision nearer to another than this many a-priori bounds may fall either way, where the
/// allowed error is one of those bounds: what the stable forms promise.
const MARGIN: f64 = 3.0;

/// Whether an answer with this verdict is more wrong than allowed.
pub fn fails(case: &Value, verdict: &Verdict, allowed: Allowed) -> bool {
    match (allowed, verdict.wrong) {
        (Allowed::Bound(_), Some(Wrong::Decision | Wrong::Root)) => !excused(case, MARGIN),
        (_, Some(_)) => true,
        (Allowed::Exact, None) => false,
        (Allowed::CorrectlyRounded, None) => verdict.ulps > 0.5,
        (Allowed::Ulp(n), None) => verdict.ulps > f64::from(n),
        (Allowed::Bound(k), None) => verdict.bounds.is_some_and(|bounds| bounds > f64::from(k)),
    }
}

/// Whether a decision is so close that an error of k bounds may change it.
fn excused(case: &Value, k: f64) -> bool {
    let excused = if case["prec"] == "f32" {
        excused_in::<f32>(case, k)
    } else {
        excused_in::<f64>(case, k)
    };
    excused.unwrap_or(false)
}

fn excused_in<F: Float>(case: &Value, k: f64) -> Result<bool, String> {
    let input = Fields::of("in", &case["in"])?;
    let surfaces: Vec<Surface<F>> = match case["kind"].as_str() {
        Some("ray_plane") => vec![input.plane()?],
        Some("ray_sphere") => vec![input.sphere()?],
        _ => input
            .objects("objs")?
            .iter()
            .map(Fields::surface)
            .collect::<Result<_, _>>()?,
    };
    let (ray, ends) = (input.ray()?, input.ends()?);
    Ok(surfaces
        .iter()
        .any(|surface| is_marginal(&ray, ends, surface, k)))
}

fn judge_in<F: Float>(case: &Value, out: &Value) -> Option<Verdict> {
    let exp = &case["exp"];
    match Kernel::named(case["kind"].as_str()?)? {
        Kernel::RayPlane | Kernel::RaySphere => hit::<F>(exp, out.get("t")?),
        Kernel::AnyHit => {
            let right = out.get("occluded")?.as_bool()? == exp["occluded"]["closed"].as_bool()?;
            Some(Verdict::right_if(right, Wrong::Decision))
        }
        Kernel::LightSample => light_sample::<F>(exp, out),
        Kernel::Shade => shade::<F>(exp, out),
        Kernel::Offset => offset::<F>(case, out).ok(),
        Kernel::Quantise => {
            let right = out.get("byte")?.as_u64()? == exp["floor"].as_u64()?;
            Some(Verdict::right_if(right, Wrong::Byte))
        }
    }
}

/// The exact value of a number of the truth.
fn exact(number: &Value) -> Option<Real> {
    parse(number["dec"].as_str()?).map(Real::from)
}

fn hit<F: Float>(exp: &Value, t: &Value) -> Option<Verdict> {
    let should_hit = exp["hit"]["closed"].as_bool()?;
    // A hit needs a t that is a number: where the exact one is beyond the format, there is none.
    let beyond = should_hit && float::<F>(&exp["t"]["bits"])?.to_f64().is_infinite();
    if t.is_null() && beyond {
        return Some(Verdict::of(None));
    }
    if t.is_null() || !should_hit {
        return Some(Verdict::right_if(
            t.is_null() != should_hit,
            Wrong::Decision,
        ));
    }
    let t = float::<F>(t)?.to_f64();
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
fn vector_error<F: Float>(out: &Value, exp: &Value) -> Option<f64> {
    let mut largest = 0f64;
    for (out, exp) in out.as_array()?.iter().zip(exp.as_array()?) {
        let ulps = in_ulps(float::<F>(out)?.to_f64(), &exact(exp)?, format::<F>());
        largest = largest.max(ulps);
    }
    Some(largest)
}

fn light_sample<F: Float>(exp: &Value, out: &Value) -> Option<Verdict> {
    let nothing = exp.get("dir").is_none_or(Value::is_null);
    if let Some(none) = out.get("none") {
        return Some(Verdict::right_if(none == nothing, Wrong::Decision));
    }
    if nothing {
        return Some(Verdict::of(Some(Wrong::Decision)));
    }
    let distance = float::<F>(out.get("dist")?)?.to_f64();
    let errors = [
        in_ulps(distance, &exact(&exp["dist"])?, format::<F>()),
        vector_error::<F>(out.get("dir")?, &exp["dir"])?,
        vector_error::<F>(out.get("radiance")?, &exp["radiance"])?,
    ];
    Some(Verdict {
        wrong: None,
        ulps: errors.into_iter().fold(0.0, f64::max),
        bounds: None,
    })
}

fn shade<F: Float>(exp: &Value, out: &Value) -> Option<Verdict> {
    let dark = |components: Vec<bool>| components.into_iter().all(|zero| zero);
    let of_answer = out.get("li")?.as_array()?.iter();
    let of_answer = of_answer.map(|x| Some(float::<F>(x)?.to_f64() == 0.0));
    let of_truth = exp["li"].as_array()?.iter();
    let of_truth = of_truth.map(|x| Some(float::<F>(&x["bits"])?.to_f64() == 0.0));
    let visible = dark(of_answer.collect::<Option<_>>()?) == dark(of_truth.collect::<Option<_>>()?);
    let wrong = if !visible {
        Some(Wrong::Decision)
    } else if out.get("byte")? != &exp["byte"] {
        Some(Wrong::Byte)
    } else {
        None
    };
    Some(Verdict {
        wrong,
        ulps: vector_error::<F>(out.get("li")?, &exp["li"])?,
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

fn offset<F: Float>(case: &Value, out: &Value) -> Result<Verdict, String> {
    let input = Fields::of("in", &case["in"])?;
    let ray = input.ray::<F>()?;
    let object = match input.object("obj")?.surface::<F>()? {
        Surface::Plane { point, normal } => {
            Plane::new(doubles::<F>(point), doubles::<F>(normal)).map(Object::Plane)
        }
        Surface::Sphere { center, radius } => {
            Sphere::new(doubles::<F>(center), radius.to_f64()).map(Object::Sphere)
        }
    };
    let (origin, direction) = (doubles::<F>(ray.origin), doubles::<F>(ray.direction));
    let side = object
        .as_ref()
        .and_then(|object| Side::seen_by(object, origin, direction));
    let before = doubles::<F>(input.vector::<F>("p")?);
    let out = Fields::of("out", out)?;
    let after = doubles::<F>(out.vector::<F>("p")?);
    let above = |side: Side| vector(after).is_some_and(|after| side.height(&after).sign() > 0);
    if !side.is_none_or(above) {
        return Ok(Verdict::of(Some(Wrong::Side)));
    }
    let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let moved = length([0, 1, 2].map(|i| after[i] - before[i]));
    let near = moved <= reach::<F>() * length(before).max(1.0);
    Ok(Verdict::right_if(near, Wrong::Far))
}
