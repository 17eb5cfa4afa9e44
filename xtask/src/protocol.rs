//! The kernel protocol, the answering side (`docs/protocol.md`).

use crate::fields::{Fields, bits, member, word};
use ombrage::Float;
use ombrage::conformance::{Kernel, Kernels, Offset, Shade};
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
    let kernel = word(request, "kind", KINDS, Kernel::named)?;
    let float = |name: &str| match name {
        "f32" => Some(compute::<f32> as fn(&Kernels, Kernel, Fields) -> Out),
        "f64" => Some(compute::<f64> as fn(&Kernels, Kernel, Fields) -> Out),
        _ => None,
    };
    let compute = word(request, "prec", "\"f32\" or \"f64\"", float)?;
    compute(kernels, kernel, Fields::of("in", member(request, "in")?)?)
}

type Out = Result<Result<Value, String>, String>;

fn compute<F: Float>(kernels: &Kernels, kernel: Kernel, input: Fields) -> Out {
    Ok(Ok(match kernel {
        Kernel::RayPlane => {
            let hit = kernels.hit::<F>(&input.ray()?, input.ends()?, &input.plane()?);
            json!({ "t": hit.map(F::hex) })
        }
        Kernel::RaySphere => {
            let hit = kernels.hit::<F>(&input.ray()?, input.ends()?, &input.sphere()?);
            json!({ "t": hit.map(F::hex) })
        }
        Kernel::AnyHit => {
            let surfaces: Result<Vec<_>, _> = input
                .objects("objs")?
                .iter()
                .map(Fields::surface::<F>)
                .collect();
            json!({ "occluded": kernels.any_hit(&input.ray()?, input.ends()?, &surfaces?) })
        }
        Kernel::LightSample => {
            let light = [input.vector::<F>("light")?, input.vector::<F>("color")?];
            let power = input.number::<F>("power")?;
            match kernels.light_sample::<F>(input.vector::<F>("p")?, light, power) {
                Some(sample) => json!({
                    "dist": sample.distance.hex(),
                    "dir": bits::<F>(sample.direction),
                    "radiance": bits::<F>(sample.radiance),
                }),
                None => json!({ "none": true }),
            }
        }
        Kernel::Shade => {
            let shaded = match kernels.shade(&shade::<F>(input)?) {
                Ok(shaded) => shaded,
                Err(why) => return Ok(Err(why)),
            };
            json!({ "li": bits::<F>(shaded.li), "byte": shaded.bytes })
        }
        Kernel::Offset => {
            let question = Offset::<F> {
                ray: input.ray()?,
                surface: input.object("obj")?.surface()?,
                point: input.vector::<F>("p")?,
                normal: input.vector::<F>("n")?,
            };
            json!({ "p": bits::<F>(kernels.offset(&question)) })
        }
        Kernel::Quantise => json!({ "byte": kernels.quantise(input.number::<F>("x")?) }),
    }))
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
