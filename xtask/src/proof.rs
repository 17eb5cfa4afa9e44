//! What tables say of a proven picture.

use crate::table::grouped;
use ombrage::{Proven, Rung, Undecided};
use serde::{Deserialize, Serialize};

/// Pixels by what proved them, and those that nothing did.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Proof {
    /// Pixels by the rung that proved them.
    pub rungs: Rungs,
    /// How many pixels are not proven.
    pub undecided: usize,
    /// Where they are, and why.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    undecided_pixels: Vec<Place>,
}

/// How many pixels each rung proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rungs {
    /// Single precision.
    pub f32: usize,
    /// Double precision.
    pub f64: usize,
    /// Double-double.
    pub double_double: usize,
    /// Exact arithmetic.
    pub exact: usize,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Place {
    column: u32,
    row: u32,
    reason: String,
}

impl Proof {
    /// The heads of the table's columns.
    pub const HEADS: [&str; 5] = ["f32", "f64", "double-double", "exact", "undecided"];

    /// The proof of a picture.
    pub fn of(proven: &Proven) -> Self {
        let place = |pixel: &Undecided| Place {
            column: pixel.column,
            row: pixel.row,
            reason: pixel.reason.into(),
        };
        Self {
            rungs: Rungs {
                f32: proven.count(Rung::F32),
                f64: proven.count(Rung::F64),
                double_double: proven.count(Rung::DoubleDouble),
                exact: proven.count(Rung::Exact),
            },
            undecided: proven.undecided().len(),
            undecided_pixels: proven.undecided().iter().map(place).collect(),
        }
    }

    /// Whether every pixel is proven.
    pub fn is_complete(&self) -> bool {
        self.undecided == 0
    }

    /// The cells of the table's row.
    pub fn cells(&self) -> Vec<String> {
        let Rungs {
            f32,
            f64,
            double_double,
            exact,
        } = self.rungs;
        let counts = [f32, f64, double_double, exact, self.undecided];
        counts.map(|count| grouped(count as u64)).to_vec()
    }

    /// One line for each pixel that is not proven.
    pub fn list(&self, picture: &str) -> String {
        let line = |p: &Place| {
            format!(
                "{picture}: column {}, row {}: {}\n",
                p.column, p.row, p.reason
            )
        };
        self.undecided_pixels.iter().map(line).collect()
    }
}
