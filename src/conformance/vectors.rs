//! The test vectors of the kernel protocol, and judging by them. Behind the feature `vectors`.

mod behaviour;
mod fields;
mod judge;
mod margin;
mod measured;
mod protocol;
mod trial;

pub use behaviour::{Behaviour, Evidence, recognise};
pub use judge::{Verdict, Wrong};
pub use measured::Measured;
pub use protocol::{answer, output};
pub use trial::{Judged, Trial, failing};

use super::{Kernel, Question};
use crate::float::Float;
use fields::{member, word};
use serde_json::{Value, json};

/// A request of the kernel protocol with the exact truth about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    value: Value,
    kernel: Kernel,
    float: &'static str,
}

/// The test vectors of a kernel, in both formats: those of `tests/vectors`, which are compiled in.
///
/// # Errors
/// None: the vectors are valid. The message would say which line is not, and why.
pub fn vectors(kernel: Kernel) -> Result<Vec<Case>, String> {
    let text = match kernel {
        Kernel::RayPlane => include_str!("../../tests/vectors/ray_plane.jsonl"),
        Kernel::RaySphere => include_str!("../../tests/vectors/ray_sphere.jsonl"),
        Kernel::AnyHit => include_str!("../../tests/vectors/any_hit.jsonl"),
        Kernel::LightSample => include_str!("../../tests/vectors/light_sample.jsonl"),
        Kernel::Shade => include_str!("../../tests/vectors/shade.jsonl"),
        Kernel::Offset => include_str!("../../tests/vectors/offset.jsonl"),
        Kernel::Quantise => include_str!("../../tests/vectors/quantise.jsonl"),
    };
    let case = |(number, line)| {
        let value = serde_json::from_str(line).map_err(|error| error.to_string());
        value
            .and_then(Case::new)
            .map_err(|error| format!("{}.jsonl:{number}: {error}", kernel.name()))
    };
    (1..).zip(text.lines()).map(case).collect()
}

impl Case {
    /// A case of one's own: a request with `exp`, the exact truth.
    ///
    /// # Errors
    /// If a key is missing or has a value that no request has: which, and what it should be.
    pub fn new(value: Value) -> Result<Self, String> {
        word(&value, "id", "a string", |id| Some(id.len()))?;
        let kernel = word(&value, "kind", "a kind of the protocol", Kernel::named)?;
        let float = word(&value, "prec", "\"f32\" or \"f64\"", |name| match name {
            "f32" => Some("f32"),
            "f64" => Some("f64"),
            _ => None,
        })?;
        member(&value, "exp")?;
        Ok(Self {
            value,
            kernel,
            float,
        })
    }

    /// Its name, which no other vector has.
    pub fn id(&self) -> &str {
        self.value["id"].as_str().unwrap_or_default()
    }

    /// The name of its difficulty; empty for a case without one.
    pub fn family(&self) -> &str {
        self.value["family"].as_str().unwrap_or_default()
    }

    /// What it asks about.
    pub fn kernel(&self) -> Kernel {
        self.kernel
    }

    /// Its format: `f32` or `f64`.
    pub fn float(&self) -> &'static str {
        self.float
    }

    /// The whole of it, as JSON.
    pub fn value(&self) -> &Value {
        &self.value
    }

    /// The exact truth.
    pub fn truth(&self) -> &Value {
        &self.value["exp"]
    }

    /// What a program is asked: the request alone.
    pub fn request(&self) -> Value {
        let [id, kind, prec, input] = ["id", "kind", "prec", "in"].map(|key| &self.value[key]);
        json!({ "id": id, "kind": kind, "prec": prec, "in": input })
    }

    /// The question, whose numbers must be of this format.
    ///
    /// # Errors
    /// If the request is malformed: which key, its value, and what it should be.
    pub fn question<F: Float>(&self) -> Result<Question<F>, String> {
        Question::of(&self.value)
    }
}
