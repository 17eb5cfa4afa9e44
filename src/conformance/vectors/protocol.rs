//! The kernel protocol: questions and answers as JSON (`docs/protocol.md`).

use super::fields::{Fields, bits, byte, float, member, word};
use crate::conformance::{Answer, Kernel, Kernels, Offset, Question, Shade, Shaded};
use crate::float::Float;
use crate::light::LightSample;
use serde_json::{Value, json};

/// The names of the kinds, for messages.
const KINDS: &str = "ray_plane, ray_sphere, any_hit, light_sample, shade, offset or quantise";

/// The kit's answer to a request: `{"id", "out"}`, or `{"id", "unsupported"}`. Keys it does not
/// know are ignored.
///
/// # Errors
/// If the request is malformed: which key, its value, and what it should be.
pub fn answer(kernels: &Kernels, request: &Value) -> Result<Value, String> {
    if !request.is_object() {
        return Err("the line is not a JSON object".into());
    }
    let id = member(request, "id")?;
    if !id.is_string() {
        return Err("\"id\" is not a string".into());
    }
    Ok(match output(kernels, request)? {
        Ok(out) => json!({ "id": id, "out": out }),
        Err(why) => json!({ "id": id, "unsupported": why }),
    })
}

/// What follows `out` in the answer, or why the kit has none.
///
/// # Errors
/// As [`answer`].
pub fn output(kernels: &Kernels, request: &Value) -> Result<Result<Value, String>, String> {
    let compute = word(request, "prec", "\"f32\" or \"f64\"", |name| match name {
        "f32" => Some(compute::<f32> as fn(&Kernels, &Value) -> Out),
        "f64" => Some(compute::<f64> as fn(&Kernels, &Value) -> Out),
        _ => None,
    })?;
    compute(kernels, request)
}

type Out = Result<Result<Value, String>, String>;

fn compute<F: Float>(kernels: &Kernels, request: &Value) -> Out {
    let question = Question::<F>::of(request)?;
    Ok(kernels.answer(&question).map(|answer| answer.out()))
}

impl<F: Float> Question<F> {
    /// The question of a request, whose numbers must be of this format.
    ///
    /// # Errors
    /// If the request is malformed: which key, its value, and what it should be.
    pub fn of(request: &Value) -> Result<Self, String> {
        let kernel = word(request, "kind", KINDS, Kernel::named)?;
        let input = Fields::of("in", member(request, "in")?)?;
        Ok(match kernel {
            Kernel::RayPlane => Question::Hit {
                ray: input.ray()?,
                ends: input.ends()?,
                surface: input.plane()?,
            },
            Kernel::RaySphere => Question::Hit {
                ray: input.ray()?,
                ends: input.ends()?,
                surface: input.sphere()?,
            },
            Kernel::AnyHit => {
                let objects = input.objects("objs")?;
                let surfaces: Result<_, _> = objects.iter().map(Fields::surface::<F>).collect();
                Question::AnyHit {
                    ray: input.ray()?,
                    ends: input.ends()?,
                    surfaces: surfaces?,
                }
            }
            Kernel::LightSample => Question::LightSample {
                point: input.vector::<F>("p")?,
                light: input.vector::<F>("light")?,
                color: input.vector::<F>("color")?,
                power: input.number("power")?,
            },
            Kernel::Shade => Question::Shade(shade(input)?),
            Kernel::Offset => Question::Offset(Offset {
                ray: input.ray()?,
                surface: input.object("obj")?.surface()?,
                point: input.vector::<F>("p")?,
                normal: input.vector::<F>("n")?,
            }),
            Kernel::Quantise => Question::Quantise(input.number("x")?),
        })
    }
}

fn shade<F: Float>(input: Fields) -> Result<Shade<F>, String> {
    let object = |fields: &Fields| Ok((fields.surface()?, fields.vector::<F>("color")?));
    Ok(Shade {
        ray: input.ray()?,
        ends: input.ends()?,
        objects: input
            .objects("objs")?
            .iter()
            .map(object)
            .collect::<Result<_, String>>()?,
        light: input.vector::<F>("light")?,
        light_color: input.vector::<F>("light_color")?,
        power: input.number("power")?,
        background: input.number("background")?,
    })
}

impl<F: Float> Answer<F> {
    /// What follows `out` in an answer.
    pub fn out(&self) -> Value {
        match self {
            Answer::Hit(t) => json!({ "t": t.map(F::hex) }),
            Answer::AnyHit(occluded) => json!({ "occluded": occluded }),
            Answer::LightSample(None) => json!({ "none": true }),
            Answer::LightSample(Some(sample)) => json!({
                "dist": sample.distance.hex(),
                "dir": bits::<F>(sample.direction),
                "radiance": bits::<F>(sample.radiance),
            }),
            Answer::Shade(shaded) => json!({ "li": bits::<F>(shaded.li), "byte": shaded.bytes }),
            Answer::Offset(p) => json!({ "p": bits::<F>(*p) }),
            Answer::Quantise(byte) => json!({ "byte": byte }),
        }
    }

    /// The answer that follows `out` in an answer about a kernel.
    ///
    /// # Errors
    /// If it is malformed: which key, its value, and what it should be.
    pub fn of(kernel: Kernel, out: &Value) -> Result<Self, String> {
        let fields = Fields::of("out", out)?;
        Ok(match kernel {
            Kernel::RayPlane | Kernel::RaySphere => {
                let t = member(out, "t")?;
                Answer::Hit(match float(t) {
                    None if !t.is_null() => Some(fields.number("t")?),
                    t => t,
                })
            }
            Kernel::AnyHit => Answer::AnyHit(fields.truth("occluded")?),
            Kernel::LightSample if out.get("none").is_some() => {
                Answer::LightSample(match fields.truth("none")? {
                    true => None,
                    false => return Err("\"none\" is false: leave it out".into()),
                })
            }
            Kernel::LightSample => Answer::LightSample(Some(LightSample {
                distance: fields.number("dist")?,
                direction: fields.vector::<F>("dir")?,
                radiance: fields.vector::<F>("radiance")?,
                pdf: F::from_f64(1.0),
            })),
            Kernel::Shade => {
                let bytes = member(out, "byte")?;
                let three = match bytes.as_array().map(Vec::as_slice) {
                    Some([r, g, b]) => [r, g, b],
                    _ => [bytes; 3],
                };
                let [r, g, b] = three.map(|value| byte("byte", value));
                Answer::Shade(Shaded {
                    li: fields.vector::<F>("li")?,
                    bytes: [r?, g?, b?],
                })
            }
            Kernel::Offset => Answer::Offset(fields.vector::<F>("p")?),
            Kernel::Quantise => Answer::Quantise(byte("byte", member(out, "byte")?)?),
        })
    }
}
