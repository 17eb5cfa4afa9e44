//! Numbers that a recipe needs and a picture does not say outright: found by trying.

use super::best::Best;
use super::changes::{SAME_POWER, differs};
use super::color;
use super::evidence::Evidence;
use super::measure;
use super::recipe::Recipe;
use super::surface::Object;
use crate::error::Invalid;
use std::f64::consts::PI;

/// The recipe with its wrong numbers as near to the picture as trying brings them.
pub(super) fn refined(
    evidence: &Evidence,
    recipe: Recipe,
    expected: &Recipe,
) -> Result<Recipe, Invalid> {
    let mut best = if recipe.viewpoint.fov == expected.viewpoint.fov {
        Best::of(evidence, recipe)?
    } else {
        // What was measured in another field of view may mean nothing.
        let mut plain = recipe;
        (plain.power, plain.colors) = (expected.power, expected.colors);
        let mut best = in_its_field_of_view(evidence, plain, expected)?;
        if plain != recipe {
            best.consider(in_its_field_of_view(evidence, recipe, expected)?.recipe)?;
        }
        best
    };
    if best.recipe.power != expected.power {
        best.descend(&[turn_power], (0.04, 0.0005))?;
    }
    let shadow = best.recipe.viewpoint.shadow.unwrap_or_default();
    if shadow.offset != 0.0 {
        best.descend(&[turn_offset], (0.5, 0.01))?;
    }
    for object in [0, 1] {
        if best.recipe.colors[object] != expected.colors[object] {
            color::refine(&mut best, object)?;
        }
    }
    let recipe = factored(best.recipe, expected);
    Ok(snapped(recipe, expected, evidence.loss.tolerance()))
}

/// The recipe with the field of view that fits best.
fn in_its_field_of_view<'a>(
    evidence: &'a Evidence<'a>,
    recipe: Recipe,
    expected: &Recipe,
) -> Result<Best<'a>, Invalid> {
    let mut guess = Best::of(evidence, recipe)?;
    guess.descend(&[turn_fov], (4.0, 0.05))?;
    let measured = measured_again(evidence, guess.recipe, expected)?;
    let mut best = Best::of(evidence, measured)?;
    best.descend(&[turn_fov], (0.4, 0.002))?;
    Ok(best)
}

fn turn_fov(recipe: &mut Recipe, step: f64) {
    let fov = &mut recipe.viewpoint.fov;
    *fov = (*fov + step).clamp(1.0, 170.0);
}

fn turn_power(recipe: &mut Recipe, step: f64) {
    recipe.power *= 1.0 + step;
}

fn turn_offset(recipe: &mut Recipe, step: f64) {
    if let Some(ray) = &mut recipe.viewpoint.shadow {
        ray.offset *= 1.0 + step;
    }
}

/// Measures wrong colours again, now that the right pixels are known.
fn measured_again(
    evidence: &Evidence,
    mut recipe: Recipe,
    expected: &Recipe,
) -> Result<Recipe, Invalid> {
    for object in [Object::Sphere, Object::Plane] {
        if let Some(index) = object.index()
            && recipe.colors[index] != expected.colors[index]
            && let Some(color) = measure::color(evidence, &recipe, object)?
        {
            recipe.colors[index] = color;
        }
    }
    Ok(recipe)
}

/// Two wrong colours said more simply, where the expected ones explain them: red and blue are
/// exchanged, or the light has another power, which shows on an object of the expected hue.
fn factored(mut recipe: Recipe, expected: &Recipe) -> Recipe {
    if (0..2).any(|i| recipe.colors[i] == expected.colors[i]) {
        return recipe;
    }
    let exchanged = |[red, green, blue]: [f64; 3]| [blue, green, red];
    let is_exchanged =
        (0..2).any(|i| factor(recipe.colors[i], exchanged(expected.colors[i]), 0).is_some());
    if is_exchanged && recipe.swapped == expected.swapped {
        recipe.swapped = !recipe.swapped;
        recipe.colors = recipe.colors.map(exchanged);
    }
    let factors = [0, 1].map(|i| factor(recipe.colors[i], expected.colors[i], 0));
    if let (Some(power), true) = (factors[0].or(factors[1]), recipe.power == expected.power) {
        recipe.power *= power;
        recipe.colors = recipe.colors.map(|color| color.map(|x| x / power));
    }
    recipe
}

/// The factor between two colours of the same hue, give or take noise and what a loss of this
/// tolerance does to the hue.
pub(super) fn factor(color: [f64; 3], of: [f64; 3], tolerance: u8) -> Option<f64> {
    let brightest = (0..3).max_by(|&a, &b| of[a].total_cmp(&of[b]))?;
    let factor = color[brightest] / of[brightest];
    // Both are chosen by what was measured on pictures, not derived.
    let noise = 0.02 + 0.005 * f64::from(tolerance);
    let same = (0..3).all(|c| (color[c] - factor * of[c]).abs() <= noise * factor);
    (same && factor > 0.0 && factor.is_finite()).then_some(factor)
}

/// The recipe with the expected numbers where its own are the same but for noise.
pub(super) fn snapped(mut recipe: Recipe, expected: &Recipe, tolerance: u8) -> Recipe {
    let same = SAME_POWER * (1.0 + f64::from(tolerance) / 3.0);
    for power in [expected.power, expected.power / PI] {
        if (recipe.power / power - 1.0).abs() <= same {
            recipe.power = power;
        }
    }
    if (recipe.viewpoint.fov - expected.viewpoint.fov).abs() < SAME_FOV {
        recipe.viewpoint.fov = expected.viewpoint.fov;
    }
    for object in 0..2 {
        if !differs(recipe.colors[object], expected.colors[object]) {
            recipe.colors[object] = expected.colors[object];
        }
    }
    recipe
}

/// Fields of view differ by so many degrees.
const SAME_FOV: f64 = 0.1;
