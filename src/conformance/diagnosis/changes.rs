//! The hypotheses: every change of one knob.

use super::Code;
use super::evidence::Evidence;
use super::measure;
use super::recipe::{Cosine, Recipe, ShadowRay, Transfer};
use super::surface::Object;
use crate::error::Invalid;
use crate::film::Film;
use std::f64::consts::PI;

/// A component of a colour must differ by so much to be another: two steps of a byte.
const SAME_COLOR: f64 = 2.1 / 255.0;

/// A power must differ by this part to be another.
pub(super) const SAME_POWER: f64 = 0.012;

/// The recipes that differ from this one by one fault more.
pub(super) fn changes(
    evidence: &Evidence,
    recipe: &Recipe,
    expected: &Recipe,
) -> Result<Vec<Recipe>, Invalid> {
    let mut found = vec![];
    let mut add = |change: &dyn Fn(&mut Recipe)| {
        let mut changed = *recipe;
        change(&mut changed);
        found.push(changed);
    };
    let has = |code| recipe.has(code, expected);
    let view = &recipe.viewpoint;

    if recipe.film == expected.film {
        let other = match expected.film {
            Film::Clamp => Film::Wrap,
            Film::Wrap => Film::Clamp,
        };
        add(&|r| r.film = other);
    }
    if !has(Code::OtherFigure) {
        add(&|r| {
            r.light_at_eye = !expected.light_at_eye;
            r.viewpoint.shadow = None;
            r.acne = [false; 2];
        });
        if view.shadow.is_none() && expected.viewpoint.shadow.is_none() {
            add(&|r| {
                r.light_at_eye = false;
                r.viewpoint.shadow = Some(ShadowRay::default());
            });
        }
        if expected.acne.contains(&true) && view.shadow.is_some() {
            add(&|r| r.acne = [false; 2]);
        }
    }
    if view.shadow.is_some() {
        if !has(Code::OtherFigure) {
            add(&|r| {
                r.viewpoint.shadow = None;
                r.acne = [false; 2];
            });
        }
        if recipe.acne == [false; 2] && expected.acne == [false; 2] {
            for acne in [[true, true], [false, true], [true, false]] {
                add(&|r| r.acne = acne);
            }
        }
        if view.shadow == Some(ShadowRay::default()) {
            for offset in [0.1, 0.3, 1.0] {
                let ray = ShadowRay {
                    offset,
                    ..ShadowRay::default()
                };
                add(&|r| r.viewpoint.shadow = Some(ray));
            }
        }
    }
    if recipe.flipped == [false; 2] {
        for flipped in [[true, true], [false, true], [true, false]] {
            add(&|r| r.flipped = flipped);
        }
    }
    if !has(Code::CosineUnclamped) {
        add(&|r| r.cosine = Cosine::Signed);
        add(&|r| r.cosine = Cosine::Absolute);
    }
    if recipe.falloff == expected.falloff && !recipe.light_at_eye {
        add(&|r| r.falloff = 0);
        add(&|r| r.falloff = 1);
    }
    if view.has_plane {
        add(&|r| r.viewpoint.has_plane = false);
    }
    if !view.mirrored {
        add(&|r| r.viewpoint.mirrored = true);
    }
    if !view.upside_down {
        add(&|r| r.viewpoint.upside_down = true);
    }
    if !recipe.swapped {
        add(&|r| r.swapped = true);
    }
    if recipe.transfer == expected.transfer {
        for transfer in Transfer::WRONG {
            add(&|r| r.transfer = transfer);
        }
    }
    if !has(Code::WrongFov) {
        for fov in fields_of_view(evidence, view.fov) {
            add(&|r| r.viewpoint.fov = fov);
        }
    }
    let flawed_power = has(Code::WrongPower) || has(Code::ExtraPi);
    if !flawed_power {
        add(&|r| r.power = 1.0 / PI);
        if let Some(power) = measure::power(evidence, recipe)? {
            let is_other = |of: f64| (power / of - 1.0).abs() > SAME_POWER;
            if power > 1e-3 && is_other(1.0) && is_other(1.0 / PI) {
                add(&|r| r.power = power);
            }
        }
    }
    if !has(Code::WrongBackground)
        && let Some(background) = measure::background(evidence, recipe)?
        && differs(background, recipe.background)
    {
        add(&|r| r.background = background);
    }
    for object in [Object::Sphere, Object::Plane] {
        let Some(index) = object.index() else {
            continue;
        };
        if recipe.colors[index] == expected.colors[index]
            && let Some(color) = measure::color(evidence, recipe, object)?
            && differs(color, recipe.colors[index])
            && color.iter().any(|&component| component > 0.02)
        {
            add(&|r| r.colors[index] = cleaned(color, recipe.colors[index]));
        }
    }
    Ok(found)
}

/// Whether two colours are not the same, give or take noise.
pub(super) fn differs(a: [f64; 3], b: [f64; 3]) -> bool {
    (0..3).any(|c| (a[c] - b[c]).abs() > SAME_COLOR)
}

/// The measured colour, with the expected components where they are the same but for noise.
fn cleaned(measured: [f64; 3], expected: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|c| {
        if (measured[c] - expected[c]).abs() <= SAME_COLOR {
            expected[c]
        } else {
            measured[c]
        }
    })
}

/// Fields of view that are near enough to a wrong one to find it from there: also the one whose
/// horizontal angle is what the vertical one should be.
fn fields_of_view(evidence: &Evidence, right: f64) -> Vec<f64> {
    let half = (right / 2.0).to_radians().tan();
    let from_width = 2.0 * (half / evidence.size.aspect()).atan().to_degrees();
    vec![from_width, 30.0, 36.0, 48.0, 54.0, 66.0, 75.0, 90.0, 105.0]
}
