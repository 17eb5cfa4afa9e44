//! What a scene or a picture must not contain.

use crate::real::Scalar;
use crate::vector::Vector;
use std::fmt;

/// A value that no scene, camera or picture can be made with: which one it is, and what it must be
/// instead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Invalid {
    /// The field, as users know it: `sphere radius`, `plane normal`, `camera fov`.
    pub field: &'static str,
    /// The value that was given.
    pub value: String,
    /// What the value must be: `finite and greater than 0`.
    pub must_be: &'static str,
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} is {}, but must be {}",
            self.field, self.value, self.must_be
        )
    }
}

impl std::error::Error for Invalid {}

impl Invalid {
    /// Passes a number for which `valid` holds.
    pub(crate) fn unless<S: Scalar>(
        valid: bool,
        field: &'static str,
        value: S,
        must_be: &'static str,
    ) -> Result<S, Self> {
        if valid {
            Ok(value)
        } else {
            Err(Self {
                field,
                value: value.to_f64().to_string(),
                must_be,
            })
        }
    }

    /// Passes three numbers for which `valid` holds.
    pub(crate) fn unless_vector<S: Scalar>(
        valid: bool,
        field: &'static str,
        value: S::Vector,
        must_be: &'static str,
    ) -> Result<S::Vector, Self> {
        let [x, y, z] = value.to_array().map(Scalar::to_f64);
        if valid {
            Ok(value)
        } else {
            Err(Self {
                field,
                value: format!("({x}, {y}, {z})"),
                must_be,
            })
        }
    }

    /// Passes a vector of finite numbers.
    pub(crate) fn unless_finite<S: Scalar>(
        field: &'static str,
        value: S::Vector,
    ) -> Result<S::Vector, Self> {
        let finite = value.to_array().into_iter().all(Scalar::is_finite);
        Self::unless_vector::<S>(finite, field, value, "finite")
    }

    /// Passes a colour: finite components, none below zero.
    pub(crate) fn unless_color<S: Scalar>(
        field: &'static str,
        value: S::Vector,
    ) -> Result<S::Vector, Self> {
        let valid = value
            .to_array()
            .into_iter()
            .all(|c| c.is_finite() && c.to_f64() >= 0.0);
        Self::unless_vector::<S>(valid, field, value, "finite, with no component below 0")
    }
}
