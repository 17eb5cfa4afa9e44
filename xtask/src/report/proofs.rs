//! Which rung proves which pixel.

use crate::case::Case;
use crate::error::Result;
use crate::parallel;
use crate::proof::Proof;
use ombrage::{Engine, FIGURES, Film, Lighting, Proven, Rung, Size, render_proven};
use serde::{Deserialize, Serialize};

/// A proven picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// `figure 1` ... or the name of a scene.
    pub picture: String,
    /// Columns and rows.
    pub size: [u32; 2],
    /// Pixels by what proved them.
    #[serde(flatten)]
    pub proof: Proof,
    /// The pixels of a figure that single precision could not prove, in the picture's order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub higher: Vec<Higher>,
}

/// A pixel that a higher rung proved.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Higher {
    /// From 0 at the left.
    pub column: u32,
    /// From 0 at the top.
    pub row: u32,
    /// What proved it: `f64`, `double-double`, `exact`.
    pub rung: String,
}

/// Proves the figures that can be proven, and these scenes.
///
/// # Errors
/// None: they are valid.
pub fn measure(scenes: &[Case]) -> Result<Vec<Row>> {
    let mut rows = vec![];
    for figure in &FIGURES {
        if let Some(proven) = figure.prove_with(Size::LAB, Engine::default())? {
            let picture = format!("figure {}", figure.name);
            let higher = higher(&proven);
            rows.push(Row {
                higher,
                ..row(picture, &proven)
            });
        }
    }
    rows.extend(parallel::map(scenes, |case| {
        let Case {
            scene, view, size, ..
        } = case;
        let proven = render_proven(scene, view, *size, Lighting::Shadowed, Film::Clamp)?;
        Ok(row(case.name.clone(), &proven))
    })?);
    Ok(rows)
}

fn row(picture: String, proven: &Proven) -> Row {
    let size = proven.picture().size();
    Row {
        picture,
        size: [size.width(), size.height()],
        proof: Proof::of(proven),
        higher: vec![],
    }
}

fn higher(proven: &Proven) -> Vec<Higher> {
    let width = proven.picture().size().width() as usize;
    let rungs = proven.rungs();
    let higher = rungs
        .iter()
        .enumerate()
        .filter(|(_, rung)| **rung != Rung::F32);
    let place = |(place, rung): (usize, &Rung)| Higher {
        column: (place % width) as u32,
        row: (place / width) as u32,
        rung: rung.name().into(),
    };
    higher.map(place).collect()
}
