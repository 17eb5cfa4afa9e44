//! What the report rests on: every number of the page stands here.

use super::clauses::Clause;
use super::height::Height;
use super::proofs;
use super::run::Run;
use crate::bench::Bench;
use crate::compare::{self, moved};
use crate::error::{Error, Result};
use crate::precision::measure::{Costs, Errors, Family};
use crate::shadows::{self, Offsets, Times};
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::Path;

/// The version of the format. Data of another version is not read.
pub const VERSION: u32 = 2;

/// The results of all experiments.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Data {
    /// Of this format: [`VERSION`].
    pub version: u32,
    /// How it was measured.
    pub run: Run,
    /// The figures of the lab, in `f32`.
    pub figures: Vec<Figure>,
    /// Shadow strategies on scenes.
    pub shadows: Vec<shadows::Row>,
    /// What shadow rays cost.
    pub times: Vec<Times>,
    /// The constant offsets that serve each scene.
    pub offsets: Vec<Offsets>,
    /// Acne against the height of the plane.
    pub heights: Vec<Height>,
    /// `f32` against `f64` against the truth.
    pub compare: Vec<compare::Row>,
    /// The lab's scene, moved away from the origin.
    pub moved: Vec<moved::Row>,
    /// What proves the pixels of figures and scenes.
    pub proofs: Vec<proofs::Row>,
    /// Allowed and measured errors of the kernels.
    pub errors: Vec<Errors>,
    /// The same, family by family.
    pub families: Vec<Family>,
    /// What the kernels cost.
    pub costs: Vec<Costs>,
    /// What is known to fail.
    pub known_failures: Vec<Known>,
    /// Bytes that a plain `255 * x` gets wrong.
    pub quantise: Quantise,
    /// How fast pictures are computed.
    pub bench: Bench,
    /// The clauses of the specification.
    pub clauses: Vec<Clause>,
}

/// A figure of the lab: what happens at its pixels, and which pictures it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Figure {
    /// `1`, `2a` ... `3c`.
    pub name: String,
    /// What it shows.
    pub title: String,
    /// Columns and rows.
    pub size: [u32; 2],
    /// Pixels that show the sphere.
    pub sphere: usize,
    /// Pixels that show the plane.
    pub plane: usize,
    /// Pixels of the sphere that the light shines on.
    pub lit_sphere: usize,
    /// The same, of the plane.
    pub lit_plane: usize,
    /// Pixels of the sphere that are falsely black.
    pub acne_sphere: usize,
    /// The same, of the plane.
    pub acne_plane: usize,
    /// Pixels in shadow.
    pub shadowed: usize,
    /// Pixels of which a component passes 255: it wraps, or is clamped.
    pub too_bright: usize,
    /// The largest component, in units of a byte.
    pub largest_level: u64,
    /// The checksum (CRC-32) of its pixels.
    pub picture: u32,
    /// The same, of its annotated sheet.
    pub sheet: Option<u32>,
}

/// Families of vectors that a kernel is known to fail.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Known {
    /// The kernel.
    pub kernel: String,
    /// Its qualities.
    pub qualities: Vec<String>,
    /// The formats.
    pub floats: Vec<String>,
    /// The families.
    pub families: Vec<String>,
    /// Why they fail.
    pub reason: String,
}

/// Of the 256 values k/255: how many become another byte than k.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Quantise {
    /// By truncating the rounded product 255 x in `f32`.
    pub f32: usize,
    /// The same in `f64`.
    pub f64: usize,
    /// By the kit's film, in both formats together, where the byte is that of the exact product.
    pub kit: usize,
}

impl Data {
    /// As JSON.
    ///
    /// # Errors
    /// None: every number is finite.
    pub fn to_json(&self) -> Result<String> {
        let text = serde_json::to_string_pretty(self)
            .map_err(|error| Error::new(format!("cannot write the data as JSON: {error}")))?;
        Ok(text + "\n")
    }

    /// Reads the data of a file.
    ///
    /// # Errors
    /// If the file cannot be read, is cut short, or is of another version.
    pub fn read(path: &Path) -> Result<Self> {
        let text = fs::read_to_string(path).map_err(|error| {
            let path = path.display();
            let advice = "measure it with: cargo xtask report";
            Error::new(format!("cannot read {path}: {error}; {advice}"))
        })?;
        Self::parse(&text, &path.display().to_string())
    }

    /// Reads the data of a text that has this name.
    ///
    /// # Errors
    /// If it is cut short, or of another version.
    pub fn parse(text: &str, name: &str) -> Result<Self> {
        #[derive(Deserialize)]
        struct Versioned {
            version: u32,
        }
        let advice = "measure anew with: cargo xtask report";
        let broken = |error: serde_json::Error| {
            let what = if error.is_eof() {
                "is cut short"
            } else {
                "is no data of a report"
            };
            Error::new(format!("{name} {what}: {error}; {advice}"))
        };
        let Versioned { version } = serde_json::from_str(text).map_err(broken)?;
        if version != VERSION {
            return Err(Error::new(format!(
                "{name} has version {version}, and this report is made from version {VERSION}; {advice}"
            )));
        }
        serde_json::from_str(text).map_err(broken)
    }
}
