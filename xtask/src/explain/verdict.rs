//! What every strategy says of a light.

use crate::case::Case;
use crate::error::Result;
use crate::truth;
use ombrage::conformance::{Drawing, Explanation, Trace};
use ombrage::{Chain, DoubleDouble, Lighting, Relative, Scalar, Shadow};

/// Whether a light reaches the hit point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The surface faces away from it.
    Away,
    /// Nothing stands between.
    Lit,
    /// The surface itself does: acne.
    Itself,
    /// Another object does, by its number, if it is told.
    By(Option<usize>),
}

/// A strategy's verdicts.
#[derive(Debug)]
pub struct Shadows {
    /// The strategy's name; `truth` for the truth.
    pub name: String,
    /// In `f32` and in `f64`.
    pub verdicts: [Verdict; 2],
}

/// The truth's verdict and those of all strategies, on the light of this number; nothing where
/// nothing is hit, or the light is at the eye.
///
/// # Errors
/// If the view is invalid.
pub fn all(
    case: &Case,
    explanation: &Explanation,
    drawing: &Drawing,
    light: usize,
) -> Result<Vec<Shadows>> {
    if explanation.truth.lights.len() <= light {
        return Ok(vec![]);
    }
    let surfaces = truth::surfaces(&case.scene);
    let truth = of::<DoubleDouble>(&explanation.truth, light, 0, &surfaces);
    let mut shadows = vec![Shadows {
        name: "truth".into(),
        verdicts: [truth; 2],
    }];
    for (number, strategy) in Shadow::ALL.into_iter().enumerate() {
        shadows.push(Shadows {
            name: strategy.name(),
            verdicts: [
                of::<f32>(&explanation.single, light, number, &surfaces),
                of::<f64>(&explanation.double, light, number, &surfaces),
            ],
        });
    }
    let alone = case.with_light(light)?;
    shadows.push(Shadows {
        name: "sidedness".into(),
        verdicts: [
            by_sides::<f32>(&alone, drawing)?,
            by_sides::<f64>(&alone, drawing)?,
        ],
    });
    Ok(shadows)
}

/// The verdict of a strategy by its number in [`Shadow::ALL`]. Objects that are equal are one
/// surface.
fn of<S: Scalar>(trace: &Trace<S>, light: usize, strategy: usize, surfaces: &[usize]) -> Verdict {
    let (Some(first), Some(from)) = (trace.first, trace.lights.get(light)) else {
        return Verdict::Away;
    };
    if !from.cosine.gt(S::from_f64(0.0)) {
        return Verdict::Away;
    }
    let own = surfaces[first.object];
    let blockers = &from.blockers[strategy];
    let other = blockers.iter().find(|&&by| surfaces[by] != own);
    match (other, blockers.is_empty()) {
        (Some(&by), _) => Verdict::By(Some(by)),
        (None, false) => Verdict::Itself,
        (None, true) => Verdict::Lit,
    }
}

/// The verdict of the ray-relative chain. A light that a surface parts from the camera is one that
/// the pixel faces away from.
fn by_sides<S: Scalar>(case: &Case, drawing: &Drawing) -> Result<Verdict> {
    let size = drawing.size;
    let chain = Relative::<S>::new(&case.scene, &case.view, size, Lighting::Shadowed)?;
    let [x, y] = drawing.pixel;
    let across = Relative::<S>::coordinate(x, size.width());
    let pixel = chain.follow(across, Relative::<S>::coordinate(y, size.height()));
    Ok(match (pixel.faces_light, pixel.blocked_by_another) {
        (false, _) => Verdict::Away,
        (true, true) => Verdict::By(None),
        (true, false) => Verdict::Lit,
    })
}
