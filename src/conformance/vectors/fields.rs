//! Reading the inputs of a request, and writing floats as their bits.

use crate::conformance::{Ends, Surface};
use crate::float::Float;
use crate::ray::Ray;
use crate::vector::Vector;
use serde_json::{Value, json};

/// A JSON object whose floats are bits of one format.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fields<'a>(&'a Value);

/// What is wrong with a value, and what it should be.
fn wrong(key: &str, value: &Value, expected: &str) -> String {
    let mut text = value.to_string();
    if text.chars().count() > 60 {
        text = text.chars().take(60).chain("…".chars()).collect();
    }
    format!("\"{key}\" is {text}, expected {expected}")
}

/// The member of a JSON object.
///
/// # Errors
/// If there is none: its name.
pub(super) fn member<'a>(value: &'a Value, key: &str) -> Result<&'a Value, String> {
    let missing = || format!("key \"{key}\" is missing");
    value.get(key).ok_or_else(missing)
}

/// A member that must be one of some words.
///
/// # Errors
/// If it is missing or another word.
pub(super) fn word<T>(
    value: &Value,
    key: &str,
    expected: &str,
    named: impl Fn(&str) -> Option<T>,
) -> Result<T, String> {
    let text = member(value, key)?;
    text.as_str()
        .and_then(named)
        .ok_or_else(|| wrong(key, text, expected))
}

impl<'a> Fields<'a> {
    /// The fields of a JSON object.
    ///
    /// # Errors
    /// If it is none.
    pub fn of(key: &str, value: &'a Value) -> Result<Self, String> {
        if value.is_object() {
            Ok(Self(value))
        } else {
            Err(wrong(key, value, "a JSON object"))
        }
    }

    /// A float.
    ///
    /// # Errors
    /// If it is missing or has other digits than its format; likewise below.
    pub fn number<F: Float>(&self, key: &str) -> Result<F, String> {
        number(key, member(self.0, key)?)
    }

    /// Three floats.
    pub fn vector<F: Float>(&self, key: &str) -> Result<F::Vector, String> {
        let value = member(self.0, key)?;
        match value.as_array().map(Vec::as_slice) {
            Some([x, y, z]) => Ok(F::Vector::new(
                number(key, x)?,
                number(key, y)?,
                number(key, z)?,
            )),
            _ => Err(wrong(key, value, "an array of three floats")),
        }
    }

    /// A truth value.
    pub fn truth(&self, key: &str) -> Result<bool, String> {
        let value = member(self.0, key)?;
        let expected = || wrong(key, value, "true or false");
        value.as_bool().ok_or_else(expected)
    }

    /// The ray `o`, `d`.
    pub fn ray<F: Float>(&self) -> Result<Ray<F>, String> {
        Ok(Ray {
            origin: self.vector::<F>("o")?,
            direction: self.vector::<F>("d")?,
        })
    }

    /// The interval `tmin`, `tmax`.
    pub fn ends<F: Float>(&self) -> Result<Ends<F>, String> {
        Ok([self.number("tmin")?, self.number("tmax")?])
    }

    /// The plane `q`, `n`.
    pub fn plane<F: Float>(&self) -> Result<Surface<F>, String> {
        Ok(Surface::Plane {
            point: self.vector::<F>("q")?,
            normal: self.vector::<F>("n")?,
        })
    }

    /// The sphere `c`, `r`.
    pub fn sphere<F: Float>(&self) -> Result<Surface<F>, String> {
        Ok(Surface::Sphere {
            center: self.vector::<F>("c")?,
            radius: self.number("r")?,
        })
    }

    /// The plane or sphere that `type` says it is.
    pub fn surface<F: Float>(&self) -> Result<Surface<F>, String> {
        let kind = member(self.0, "type")?;
        match kind.as_str() {
            Some("plane") => self.plane(),
            Some("sphere") => self.sphere(),
            _ => Err(wrong("type", kind, "\"plane\" or \"sphere\"")),
        }
    }

    /// The object at a key.
    pub fn object(&self, key: &str) -> Result<Fields<'a>, String> {
        Fields::of(key, member(self.0, key)?)
    }

    /// The objects in an array.
    pub fn objects(&self, key: &str) -> Result<Vec<Fields<'a>>, String> {
        let value = member(self.0, key)?;
        let expected = || wrong(key, value, "an array of objects");
        let array = value.as_array().ok_or_else(expected)?;
        array.iter().map(|object| Fields::of(key, object)).collect()
    }
}

/// A whole number that a byte can hold.
///
/// # Errors
/// If it is none: what it is instead.
pub(super) fn byte(key: &str, value: &Value) -> Result<u8, String> {
    let byte = value.as_u64().and_then(|byte| u8::try_from(byte).ok());
    byte.ok_or_else(|| wrong(key, value, "a whole number from 0 to 255"))
}

fn number<F: Float>(key: &str, value: &Value) -> Result<F, String> {
    float(value).ok_or_else(|| {
        let digits = F::from_f64(0.0).hex().len();
        let expected = format!("the bits of an {} as {digits} hexadecimal digits", F::NAME);
        wrong(key, value, &expected)
    })
}

/// The float with these bits, if there are as many digits as its format has.
pub(super) fn float<F: Float>(value: &Value) -> Option<F> {
    let hex = value.as_str()?;
    let digits = hex.bytes().all(|byte| byte.is_ascii_hexdigit());
    if !digits || hex.len() != F::from_f64(0.0).hex().len() {
        return None;
    }
    u64::from_str_radix(hex, 16).ok().map(F::from_bits)
}

/// The bits of three floats.
pub(super) fn bits<F: Float>(v: F::Vector) -> Value {
    json!(v.to_array().map(Float::hex))
}
