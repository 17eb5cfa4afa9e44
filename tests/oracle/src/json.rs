//! Reading requests and writing expectations as JSON.

use crate::case::Error;
use crate::exact::vector;
use crate::format::Format;
use crate::object::Object;
use crate::plane::Plane;
use crate::ray::{PerInterval, Ray};
use crate::real::Real;
use crate::shade::Item;
use crate::sphere::Sphere;
use serde_json::{Value, json};

/// A JSON object whose numbers are bits of one format.
#[derive(Clone, Copy)]
pub struct Fields<'a> {
    value: &'a Value,
    pub format: Format,
}

impl<'a> Fields<'a> {
    pub fn new(value: &'a Value, format: Format) -> Self {
        Fields { value, format }
    }

    pub fn get(&self, key: &'static str) -> Result<&'a Value, Error> {
        get(self.value, key)
    }

    pub fn number(&self, key: &'static str) -> Result<f64, Error> {
        self.bits(key, self.get(key)?)
    }

    pub fn vector(&self, key: &'static str) -> Result<[f64; 3], Error> {
        let value = self.get(key)?;
        match value.as_array().map(Vec::as_slice) {
            Some([x, y, z]) => Ok([self.bits(key, x)?, self.bits(key, y)?, self.bits(key, z)?]),
            _ => Err(Error::invalid(key, value, "an array of three floats")),
        }
    }

    /// The ray `o`, `d`, `tmin`, `tmax`.
    pub fn ray(&self) -> Result<Option<Ray>, Error> {
        Ok(Ray::new(
            self.vector("o")?,
            self.vector("d")?,
            self.number("tmin")?,
            self.number("tmax")?,
        ))
    }

    pub fn plane(&self) -> Result<Option<Plane>, Error> {
        Ok(Plane::new(self.vector("q")?, self.vector("n")?))
    }

    pub fn sphere(&self) -> Result<Option<Sphere>, Error> {
        Ok(Sphere::new(self.vector("c")?, self.number("r")?))
    }

    pub fn object(&self) -> Result<Option<Object>, Error> {
        let kind = self.get("type")?;
        match kind.as_str() {
            Some("plane") => Ok(self.plane()?.map(Object::Plane)),
            Some("sphere") => Ok(self.sphere()?.map(Object::Sphere)),
            _ => Err(Error::invalid("type", kind, "\"plane\" or \"sphere\"")),
        }
    }

    /// The elements of the array `objs`.
    pub fn objects(&self) -> Result<Vec<Fields<'a>>, Error> {
        let objects = self.get("objs")?;
        let array = objects
            .as_array()
            .ok_or_else(|| Error::invalid("objs", objects, "an array of objects"))?;
        Ok(array
            .iter()
            .map(|object| Fields::new(object, self.format))
            .collect())
    }

    pub fn item(&self) -> Result<Item, Error> {
        Ok(Item {
            object: self.object()?,
            color: vector(self.vector("color")?),
        })
    }

    fn bits(&self, key: &'static str, value: &Value) -> Result<f64, Error> {
        let expected = match self.format {
            Format::F32 => "the bits of an f32 as 8 hexadecimal digits",
            Format::F64 => "the bits of an f64 as 16 hexadecimal digits",
        };
        value
            .as_str()
            .and_then(|hex| self.format.parse(hex))
            .ok_or_else(|| Error::invalid(key, value, expected))
    }
}

/// The member `key` of a JSON object.
pub fn get<'a>(value: &'a Value, key: &'static str) -> Result<&'a Value, Error> {
    value.get(key).ok_or(Error::Missing { key })
}

/// `{"bits", "dec"}` of an exact number rounded to a format.
pub fn number(x: &Real, format: Format) -> Value {
    json!({ "bits": format.hex(x.round(format)), "dec": x.decimal() })
}

/// The same of three numbers.
pub fn numbers<T: Clone + Into<Real>>(v: &[T; 3], format: Format) -> Value {
    v.iter()
        .map(|x| number(&x.clone().into(), format))
        .collect()
}

/// The bits of three floats.
pub fn bits(v: [f64; 3], format: Format) -> Value {
    v.iter().map(|&x| Value::from(format.hex(x))).collect()
}

/// `{"closed", "half", "open"}`.
pub fn per_interval<T: Into<Value> + Clone>(answers: &PerInterval<T>) -> Value {
    json!({ "closed": answers.closed.clone().into(), "half": answers.half.clone().into(), "open": answers.open.clone().into() })
}
