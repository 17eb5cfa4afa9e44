//! Requests of the kernel protocol, and the truth about them as the `exp` of a test vector.

use crate::any_hit::any_hit;
use crate::exact::{Rational, abs, rational, vector};
use crate::format::Format;
use crate::json::{Fields, bits, get, number, numbers, per_interval};
use crate::light::{Light, flags};
use crate::offset::{Side, wachter_binder};
use crate::quantise::quantise;
use crate::ray::PerInterval;
use crate::real::Real;
use crate::shade::{Item, Lighting, ShadeHit, shade};
use serde_json::{Value, json};
use std::fmt;

/// Why a request has no truth.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// A key is missing.
    Missing {
        /// Which.
        key: &'static str,
    },
    /// A value is not what the protocol asks for.
    Invalid {
        /// Its key.
        key: &'static str,
        /// The value, as JSON.
        value: String,
        /// What it should be.
        expected: &'static str,
    },
}

impl Error {
    pub(crate) fn invalid(key: &'static str, value: &Value, expected: &'static str) -> Error {
        Error::Invalid {
            key,
            value: value.to_string(),
            expected,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Error::Missing { key } => write!(f, "key \"{key}\" is missing"),
            Error::Invalid {
                key,
                value,
                expected,
            } => write!(f, "\"{key}\" is {value}, expected {expected}"),
        }
    }
}

impl std::error::Error for Error {}

/// The kinds of request.
pub const KINDS: [&str; 7] = [
    "ray_plane",
    "ray_sphere",
    "any_hit",
    "light_sample",
    "shade",
    "offset",
    "quantise",
];

/// The `exp` of a protocol request `{"kind", "prec", "in"}`: the exact truth about it. Other keys are ignored.
pub fn truth(request: &Value) -> Result<Value, Error> {
    let prec = get(request, "prec")?;
    let format = Format::ALL
        .into_iter()
        .find(|f| prec == f.name())
        .ok_or_else(|| Error::invalid("prec", prec, "\"f32\" or \"f64\""))?;
    let input = Fields::new(get(request, "in")?, format);
    let kind = get(request, "kind")?;
    match kind.as_str() {
        Some("ray_plane") => ray_plane(input),
        Some("ray_sphere") => ray_sphere(input),
        Some("any_hit") => any_hit_truth(input),
        Some("light_sample") => light_sample(input),
        Some("shade") => shade_truth(input),
        Some("offset") => offset(input),
        Some("quantise") => quantise_truth(input),
        _ => Err(Error::invalid("kind", kind, "a kind of the protocol")),
    }
}

fn ray_plane(input: Fields) -> Result<Value, Error> {
    let Some((ray, plane)) = input.ray()?.zip(input.plane()?) else {
        return Ok(json!({
            "hit": per_interval(&PerInterval::of(|_| false)),
            "t": null,
            "policy": "non-finite input, zero direction or zero normal: miss",
        }));
    };
    let truth = plane.meet(&ray);
    let hit = per_interval(&truth.hit);
    Ok(match truth.t.zip(truth.p) {
        Some((t, p)) => json!({
            "hit": hit,
            "t": number(&Real::from(t), input.format),
            "p": numbers(&p, input.format),
            "den_sign": truth.den_sign,
            "kappa_num": truth.kappa_num,
            "kappa_den": truth.kappa_den,
            "bound_u": truth.bound_u,
        }),
        None => json!({ "hit": hit, "t": null, "den_sign": 0, "num_sign": truth.num_sign }),
    })
}

fn ray_sphere(input: Fields) -> Result<Value, Error> {
    let Some((ray, sphere)) = input.ray()?.zip(input.sphere()?) else {
        return Ok(json!({
            "hit": per_interval(&PerInterval::of(|_| false)),
            "t0": null,
            "t1": null,
            "t": null,
            "policy": "non-finite input, zero direction or radius <= 0: miss",
        }));
    };
    let truth = sphere.meet(&ray);
    let mut exp = json!({
        "disc_sign": truth.disc_sign,
        "tangent_margin": truth.tangent_margin,
        "f_over_r": truth.f_over_r,
        "origin_side": truth.origin_side,
        "hit": per_interval(&truth.root.map(Option::is_some)),
    });
    if truth.roots.is_some() {
        exp["root"] = per_interval(&truth.root);
    }
    let [t0, t1] = match truth.roots {
        Some(roots) => roots.map(|t| number(&t.into(), input.format)),
        None => [Value::Null, Value::Null],
    };
    exp["t0"] = t0;
    exp["t1"] = t1;
    exp["t"] = Value::Null;
    if let Some(hit) = truth.hit {
        exp["t"] = number(&hit.t.into(), input.format);
        exp["p"] = numbers(&hit.p, input.format);
        exp["n_out"] = numbers(&hit.n_out, input.format);
        exp["bound_u"] = json!(hit.bound_u);
    }
    Ok(exp)
}

fn any_hit_truth(input: Fields) -> Result<Value, Error> {
    let objects = input
        .objects()?
        .iter()
        .map(Fields::object)
        .collect::<Result<Vec<_>, _>>()?;
    let Some(ray) = input.ray()? else {
        return Ok(json!({
            "occluded": per_interval(&PerInterval::of(|_| false)),
            "blockers": per_interval(&PerInterval::of(|_| Vec::<usize>::new())),
            "nearest_half": null,
            "policy": "non-finite input or zero direction: miss",
        }));
    };
    let truth = any_hit(&ray, objects.iter().map(Option::as_ref));
    let nearest = truth
        .nearest_half
        .map(|nearest| json!({ "ids": nearest.ids, "t": number(&nearest.t.into(), input.format) }));
    Ok(json!({
        "occluded": per_interval(&truth.blockers.map(|ids| !ids.is_empty())),
        "blockers": per_interval(&truth.blockers),
        "nearest_half": nearest,
    }))
}

fn light_sample(input: Fields) -> Result<Value, Error> {
    let light = Light::new(
        input.vector("light")?,
        input.number("power")?,
        input.vector("color")?,
    );
    let Some((light, p)) = light.zip(vector(input.vector("p")?)) else {
        return Ok(json!({ "dist": null, "policy": "non-finite: no contribution" }));
    };
    Ok(match light.sample(&p) {
        None => json!({
            "dist": number(&Real::from(Rational::ZERO), input.format),
            "dir": null,
            "radiance": null,
            "policy": "light at the point: direction undefined, contributes nothing",
        }),
        Some(sample) => json!({
            "dist": number(&sample.dist, input.format),
            "d2": number(&Real::from(sample.d2.clone()), input.format),
            "dir": numbers(&sample.dir, input.format),
            "radiance": numbers(&sample.radiance, input.format),
            "flags": flags(&sample.d2, input.format),
        }),
    })
}

fn shade_truth(input: Fields) -> Result<Value, Error> {
    let scene = input
        .objects()?
        .iter()
        .map(Fields::item)
        .collect::<Result<Vec<Item>, _>>()?;
    let light = Light::new(
        input.vector("light")?,
        input.number("power")?,
        input.vector("light_color")?,
    );
    let background = rational(input.number("background")?).ok_or_else(|| {
        let value = input.get("background").unwrap_or(&Value::Null);
        Error::invalid("background", value, "a finite float")
    })?;
    let truth = shade(input.ray()?.as_ref(), &scene, light.as_ref(), &background);
    let bytes = truth.bytes();
    let mut exp = json!({ "hit": truth.hit.as_ref().map(|hit| shade_hit(hit, input.format)) });
    if truth.hit.is_some() {
        describe_lighting(&mut exp, truth.lighting.as_ref(), input.format);
    }
    exp["li"] = numbers(&truth.li, input.format);
    exp["byte"] = json!(bytes);
    match (&truth.hit, &truth.lighting) {
        (Some(_), None) => exp["policy"] = json!("non-finite light or colour: no contribution"),
        (_, Some(lighting)) if lighting.light_at_hit => {
            exp["policy"] = json!("light at the hit point: no contribution");
        }
        _ => {}
    }
    Ok(exp)
}

fn shade_hit(hit: &ShadeHit, format: Format) -> Value {
    json!({
        "id": hit.id,
        "ties": hit.ties,
        "t": number(&hit.t.clone().into(), format),
        "p": numbers(&hit.p, format),
        "n": numbers(&hit.n, format),
        "flipped": hit.flipped,
    })
}

fn describe_lighting(exp: &mut Value, lighting: Option<&Lighting>, format: Format) {
    let Some(lighting) = lighting else { return };
    exp["cos_sign"] = json!(lighting.cos_sign);
    exp["occluded"] = json!(!lighting.blockers.is_empty());
    exp["blockers"] = json!(lighting.blockers);
    exp["touch"] = json!(lighting.touch);
    exp["vis_margin"] = json!(lighting.vis_margin);
    if let Some(cos) = &lighting.cos {
        exp["cos"] = number(cos, format);
    }
}

fn offset(input: Fields) -> Result<Value, Error> {
    let object = Fields::new(input.get("obj")?, input.format).object()?;
    let (origin, direction) = (input.vector("o")?, input.vector("d")?);
    let (p, n) = (input.vector("p")?, input.vector("n")?);
    let side = object
        .as_ref()
        .and_then(|object| Side::seen_by(object, origin, direction));
    let Some(((side, before), _)) = side.zip(vector(p)).zip(vector(n)) else {
        return Ok(
            json!({ "height_before": null, "policy": "no surface seen from the ray's origin: any point conforms" }),
        );
    };
    // Heights in units in the last place of the largest coordinate of p, were it a power of two.
    let largest = before
        .iter()
        .map(|x| abs(x.clone()))
        .max()
        .unwrap_or(Rational::ZERO);
    let scale = Format::F64.round(&largest) * 2.0 * input.format.unit_roundoff();
    let in_ulps =
        |height: &Real| json!(Some(height.round(Format::F64) / scale).filter(|x| x.is_finite()));
    let height = side.height(&before);
    let moved = wachter_binder(p, n, input.format);
    let moved_height = vector(moved).map(|moved| side.height(&moved));
    Ok(json!({
        "height_before": height.decimal(),
        "height_before_ulps": in_ulps(&height),
        "wb": {
            "p": bits(moved, input.format),
            "height": moved_height.as_ref().map(Real::decimal),
            "height_ulps": moved_height.as_ref().map(in_ulps),
        },
        "must": "exact height of the offset point > 0 on the side the ray came from",
    }))
}

fn quantise_truth(input: Fields) -> Result<Value, Error> {
    let x = input.number("x")?;
    let truth = quantise(x, input.format);
    let mut exp = json!({
        "floor": truth.floor,
        "round": truth.round,
        "float_mul_then_trunc": truth.float_mul_then_trunc,
        "float_mul_add_half_trunc": truth.float_mul_add_half_trunc,
        "trap_floor": truth.float_mul_then_trunc != truth.floor,
        "trap_round": truth.float_mul_add_half_trunc != truth.round,
    });
    if x.is_nan() {
        exp["policy"] = json!("NaN: byte 0");
    }
    Ok(exp)
}
