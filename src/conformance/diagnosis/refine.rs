//! Numbers that a recipe needs and a picture does not say outright: found by trying.

use super::changes::{SAME_POWER, differs};
use super::evidence::Evidence;
use super::measure;
use super::recipe::{Recipe, ShadowRay};
use super::search::UNLIKELY;
use super::surface::Object;
use crate::error::Invalid;
use std::f64::consts::PI;

/// The recipe with its wrong numbers as near to the picture as trying brings them.
pub(super) fn refined(
    evidence: &Evidence,
    mut recipe: Recipe,
    expected: &Recipe,
) -> Result<Recipe, Invalid> {
    if recipe.viewpoint.fov != expected.viewpoint.fov {
        // What was measured in another field of view may mean nothing.
        let mut plain = recipe;
        (plain.power, plain.colors) = (expected.power, expected.colors);
        let (found, error) = in_its_field_of_view(evidence, recipe, expected)?;
        if plain != recipe {
            let (plain, its_error) = in_its_field_of_view(evidence, plain, expected)?;
            recipe = if its_error <= error { plain } else { found };
        } else {
            recipe = found;
        }
    }
    if recipe.power != expected.power && recipe.power != 1.0 / PI {
        search(evidence, &mut recipe, 0.04, 0.0005, |r, step| {
            r.power *= 1.0 + step;
        })?;
    }
    if recipe.viewpoint.shadow.is_some_and(|ray| ray.offset != 0.0) {
        search(evidence, &mut recipe, 0.5, 0.01, |r, step| {
            if let Some(ray) = &mut r.viewpoint.shadow {
                ray.offset *= 1.0 + step;
            }
        })?;
    }
    for object in [0, 1] {
        if evidence.loss.tolerance() > 0 && recipe.colors[object] != expected.colors[object] {
            refine_color(evidence, &mut recipe, object)?;
        }
    }
    let recipe = factored(recipe, expected);
    Ok(snapped(recipe, expected, evidence.loss.tolerance()))
}

/// The recipe with the field of view that fits best, and its error.
fn in_its_field_of_view(
    evidence: &Evidence,
    mut recipe: Recipe,
    expected: &Recipe,
) -> Result<(Recipe, f64), Invalid> {
    let turn = |r: &mut Recipe, step: f64| {
        r.viewpoint.fov = (r.viewpoint.fov + step).clamp(1.0, 170.0);
    };
    search(evidence, &mut recipe, 4.0, 0.05, turn)?;
    measured_again(evidence, &mut recipe, expected)?;
    // Each row that becomes background or plane makes a small step in the error: look beyond.
    let mut best = (recipe, evidence.error(&recipe)?);
    if best.1 > UNLIKELY {
        return Ok(best);
    }
    for step in -NEAR..=NEAR {
        let mut tried = recipe;
        turn(&mut tried, 0.05 * f64::from(step));
        let error = evidence.error(&tried)?;
        if error < best.1 {
            best = (tried, error);
        }
    }
    search(evidence, &mut best.0, 0.04, 0.002, turn)?;
    Ok((best.0, evidence.error(&best.0)?))
}

/// Measures wrong colours again, now that the right pixels are known.
fn measured_again(
    evidence: &Evidence,
    recipe: &mut Recipe,
    expected: &Recipe,
) -> Result<(), Invalid> {
    for object in [Object::Sphere, Object::Plane] {
        if let Some(index) = object.index()
            && recipe.colors[index] != expected.colors[index]
            && let Some(color) = measure::color(evidence, recipe, object)?
        {
            recipe.colors[index] = color;
        }
    }
    Ok(())
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
fn snapped(mut recipe: Recipe, expected: &Recipe, tolerance: u8) -> Recipe {
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

/// A colour that was measured through a loss. What the loss does to a measurement is measured on
/// the prediction, and taken off; then small components are tried as 0, and all of them moved.
fn refine_color(evidence: &Evidence, recipe: &mut Recipe, index: usize) -> Result<(), Invalid> {
    let object = [Object::Sphere, Object::Plane][index];
    let Some(seen) = measure::color(evidence, recipe, object)? else {
        return Ok(());
    };
    let mut tried = *recipe;
    let mut error = evidence.error(recipe)?;
    for _ in 0..CORRECTIONS {
        let predicted: Vec<_> = evidence.predicted(&tried)?.iter().map(|p| p.rgb).collect();
        let Some(mine) = measure::color_in(&predicted, evidence, &tried, object)? else {
            break;
        };
        for (component, (seen, mine)) in tried.colors[index].iter_mut().zip(seen.iter().zip(mine)) {
            *component = (*component + seen - mine).max(0.0);
        }
        let its_error = evidence.error(&tried)?;
        if its_error < error {
            (*recipe, error) = (tried, its_error);
        }
    }
    for tried in without_traces(*recipe, index) {
        let its_error = evidence.error(&tried)?;
        if its_error < error {
            (*recipe, error) = (tried, its_error);
        }
    }
    search(evidence, recipe, 0.01, 0.001, |r, step| {
        r.colors[index] = r.colors[index].map(|x| x * (1.0 + step));
    })?;
    for component in [0, 1, 2] {
        search(evidence, recipe, 0.01, 0.001, |r, step| {
            let color = &mut r.colors[index][component];
            *color = (*color + step).max(0.0);
        })?;
    }
    Ok(())
}

/// The recipes with some of a colour's small components at 0: one alone may gain nothing.
fn without_traces(recipe: Recipe, index: usize) -> Vec<Recipe> {
    let without = |which: usize| {
        let mut tried = recipe;
        for (component, x) in tried.colors[index].iter_mut().enumerate() {
            if which >> component & 1 == 1 && *x < SMALL {
                *x = 0.0;
            }
        }
        tried
    };
    (1..8)
        .map(without)
        .filter(|tried| *tried != recipe)
        .collect()
}

/// How often a measured colour is corrected.
const CORRECTIONS: usize = 5;

/// A component that may be 0, but for what bleeds into it.
const SMALL: f64 = 0.3;

/// Twentieths of a degree that are looked at to each side.
const NEAR: i32 = 12;

/// Fields of view differ by so many degrees.
const SAME_FOV: f64 = 0.1;

/// Moves one number by smaller and smaller steps, as long as that brings the recipe nearer.
fn search(
    evidence: &Evidence,
    recipe: &mut Recipe,
    mut step: f64,
    smallest: f64,
    turn: impl Fn(&mut Recipe, f64),
) -> Result<(), Invalid> {
    let mut error = evidence.error(recipe)?;
    while step > smallest {
        let mut moved = false;
        for by in [step, -step] {
            let mut tried = *recipe;
            turn(&mut tried, by);
            let its_error = evidence.error(&tried)?;
            if its_error < error {
                (*recipe, error, moved) = (tried, its_error, true);
                break;
            }
        }
        if !moved {
            step /= 2.0;
        }
    }
    Ok(())
}

/// Moves one number of a shadow ray by a step.
type Turn<'a> = &'a dyn Fn(&mut ShadowRay, f64);

/// The recipe with the shadow ray that fits best, of all that differ from the recipe's own by
/// `turns`, each a direction to go in.
fn walk(
    evidence: &Evidence,
    recipe: &Recipe,
    turns: &[Turn],
    (largest, smallest): (f64, f64),
) -> Result<(Recipe, f64), Invalid> {
    let mut best = *recipe;
    let mut error = evidence.error(recipe)?;
    let mut step = largest;
    while step > smallest {
        let mut moved = false;
        for turn in turns {
            for by in [step, -step] {
                let mut tried = best;
                if let Some(ray) = &mut tried.viewpoint.shadow {
                    turn(ray, by);
                }
                let its_error = evidence.error(&tried)?;
                if its_error < error {
                    (best, error, moved) = (tried, its_error, true);
                }
            }
        }
        if !moved {
            step /= 2.0;
        }
    }
    Ok((best, error))
}

/// The shadow rays that may explain where the shadow's edge is: an offset along the normal, a
/// shift of the origin, another place of the light; each with its error on this evidence.
pub(super) fn shadow_rays(
    evidence: &Evidence,
    recipe: &Recipe,
) -> Result<[(Recipe, f64); 3], Invalid> {
    let mut exact = *recipe;
    exact.viewpoint.shadow = Some(ShadowRay::default());
    let offset: Turn = &|ray, step| ray.offset = (ray.offset + step).max(0.0);
    let x: Turn = &|ray, step| ray.shift[0] += step;
    let z: Turn = &|ray, step| ray.shift[1] += step;
    let light_x: Turn = &|ray, step| ray.light[0] += step;
    let light_z: Turn = &|ray, step| ray.light[1] += step;
    Ok([
        walk(evidence, &exact, &[offset], (0.512, 0.0005))?,
        walk(evidence, &exact, &[x, z], (0.512, 0.002))?,
        walk(evidence, &exact, &[light_x, light_z], (2.048, 0.01))?,
    ])
}
