//! Which clauses a picture shows to hold.

use super::Code;
use super::evidence::{Evidence, distance};
use super::recipe::{Cosine, Recipe, Transfer};
use crate::error::Invalid;
use crate::film::Film;

/// The clauses, and the faults that each forbids. A clause is shown where such a fault would be
/// visible and is not there.
const FORBIDDEN: [(&str, &[Code]); 19] = [
    ("1.1", &[Code::PlaneMissing]),
    ("1.2", &[Code::NormalFlipped]),
    ("1.3", &[Code::PlaneMissing]),
    ("2.1", &[Code::WrongPower]),
    ("2.2", &[Code::NoFalloff, Code::Mirrored]),
    ("2.3", &[Code::NoFalloff, Code::LinearFalloff]),
    ("3.1", &[Code::ExtraPi, Code::CosineUnclamped]),
    ("3.2", &[Code::Clamped]),
    ("3.3", &[Code::Wrapped]),
    ("4.1", &[Code::NoShadow, Code::ShadowShifted]),
    ("4.2", &[]),
    ("4.3", &[Code::OffsetTooLarge, Code::Acne]),
    ("E.1", &[Code::UpsideDown]),
    ("E.2", &[Code::WrongFov, Code::Mirrored]),
    ("E.3", &[Code::WrongFov]),
    ("E.4", &[Code::OtherFigure]),
    ("E.5", &[]),
    ("E.6", &[Code::Gamma]),
    ("E.7", &[Code::WrongColour, Code::WrongBackground]),
];

/// What a picture says of the clauses and of the faults.
#[derive(Clone, Debug, Default)]
pub(super) struct Said {
    /// Clauses that it shows to hold.
    pub shown: Vec<&'static str>,
    /// Clauses of which it says nothing.
    pub not_shown: Vec<&'static str>,
    /// Faults that it would not show.
    pub invisible: Vec<Code>,
}

/// What a picture of this recipe says. Clause 5.1 asks for a function, 5.2 for the same picture
/// again and E.8 for an order of operations: no picture shows them.
pub(super) fn said(
    evidence: &Evidence,
    recipe: &Recipe,
    expected: &Recipe,
    shows_t_max: bool,
) -> Result<Said, Invalid> {
    let faults = recipe.faults(expected);
    let mut said = Said::default();
    for code in Code::ALL
        .into_iter()
        .filter(|code| *code != Code::OtherScene)
    {
        // One picture cannot tell the two apart.
        let found = if code == Code::Saturated {
            Code::Clamped
        } else {
            code
        };
        if !faults.contains(&found) && !is_visible(evidence, recipe, expected, code)? {
            said.invisible.push(code);
        }
    }
    let casts = recipe.viewpoint.shadow.is_some();
    let acne = expected.acne.contains(&true) && recipe.acne.contains(&true);
    for (clause, forbidden) in FORBIDDEN {
        let broken = faults
            .iter()
            .any(|fault| fault.clause() == clause || forbidden.contains(fault));
        let visible = match clause {
            "4.2" => acne,
            "4.3" => casts && !acne,
            "E.4" => recipe.light_at_eye,
            "E.5" => shows_t_max,
            _ => true,
        } && (forbidden.is_empty()
            || forbidden.iter().any(|code| !said.invisible.contains(code)));
        match (broken, visible) {
            (true, _) => {}
            (_, true) => said.shown.push(clause),
            (_, false) => said.not_shown.push(clause),
        }
    }
    said.not_shown.extend(["5.1", "5.2", "E.8"]);
    said.not_shown.sort_unstable();
    Ok(said)
}

/// Pixels in which a fault must show to be called visible.
const FEWEST: usize = 8;

fn is_visible(
    evidence: &Evidence,
    recipe: &Recipe,
    expected: &Recipe,
    code: Code,
) -> Result<bool, Invalid> {
    if code == Code::Acne {
        return Ok(recipe.viewpoint.shadow.is_some() && !expected.acne.contains(&true));
    }
    let Some(faulty) = with(recipe, code) else {
        return Ok(code == Code::OtherFigure);
    };
    let (right, faulty) = (evidence.drawn(recipe)?, evidence.drawn(&faulty)?);
    let differing = right
        .iter()
        .zip(&faulty)
        .filter(|(a, b)| distance(a.rgb, b.rgb) > 2);
    Ok(differing.count() >= FEWEST)
}

/// A recipe with one fault that it has not, of a size that shows wherever it can; `None` for a fault
/// that no knob makes.
pub(super) fn with(recipe: &Recipe, code: Code) -> Option<Recipe> {
    let mut r = *recipe;
    let view = &mut r.viewpoint;
    match code {
        Code::Wrapped => r.film = Film::Wrap,
        Code::Clamped | Code::Saturated => r.film = Film::Clamp,
        Code::NoShadow => drop(view.shadow.take()?),
        Code::OffsetTooLarge => view.shadow.as_mut()?.offset = 0.5,
        Code::ShadowShifted => view.shadow.as_mut()?.shift = [0.5, 0.0],
        Code::CosineUnclamped => r.cosine = Cosine::Signed,
        Code::NoFalloff | Code::LinearFalloff if r.light_at_eye => return None,
        Code::NoFalloff => r.falloff = 0,
        Code::LinearFalloff => r.falloff = 1,
        Code::WrongPower | Code::ExtraPi if r.light_at_eye => return None,
        Code::WrongPower => r.power = 0.5,
        Code::ExtraPi => r.power = 1.0 / std::f64::consts::PI,
        Code::PlaneMissing => view.has_plane = false,
        Code::NormalFlipped => r.flipped = [true; 2],
        Code::Mirrored => view.mirrored = true,
        Code::UpsideDown => view.upside_down = true,
        Code::Gamma => r.transfer = Transfer::Srgb,
        Code::RedBlueSwapped => r.swapped = true,
        Code::WrongColour => r.colors = [[0.5; 3]; 2],
        Code::WrongBackground => r.background = [0.75; 3],
        Code::WrongFov => view.fov = 48.0,
        Code::Acne | Code::OtherFigure | Code::OtherScene => return None,
    }
    Some(r)
}
