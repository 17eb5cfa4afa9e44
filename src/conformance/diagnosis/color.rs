//! A colour that was measured in another convention or through a loss, and is found by trying.

use super::best::Best;
use super::measure;
use super::recipe::Recipe;
use super::surface::Object;
use crate::error::Invalid;

/// Brings an object's colour nearer. What a loss does to a measurement is measured on the prediction, and
/// taken off; then small components are tried as 0, and each is moved.
pub(super) fn refine(best: &mut Best, index: usize) -> Result<(), Invalid> {
    let evidence = best.evidence;
    let object = [Object::Sphere, Object::Plane][index];
    let Some(seen) = measure::color(evidence, &best.recipe, object)? else {
        return Ok(());
    };
    let mut tried = best.recipe;
    for _ in 0..CORRECTIONS {
        let predicted: Vec<_> = evidence.predicted(&tried)?.iter().map(|p| p.rgb).collect();
        let Some(mine) = measure::color_in(&predicted, evidence, &tried, object)? else {
            break;
        };
        for (component, (seen, mine)) in tried.colors[index].iter_mut().zip(seen.iter().zip(mine)) {
            *component = (*component + seen - mine).max(0.0);
        }
        best.consider(tried)?;
    }
    for tried in without_traces(best.recipe, index) {
        best.consider(tried)?;
    }
    for component in [0, 1, 2] {
        let turn = |r: &mut Recipe, step| turn_component(&mut r.colors[index][component], step);
        best.descend(&[turn], STEPS)?;
    }
    Ok(())
}

fn turn_component(component: &mut f64, step: f64) {
    *component = (*component + step).max(0.0);
}

/// The recipes with some of a colour's small components at 0: one alone may gain nothing.
pub(super) fn without_traces(recipe: Recipe, index: usize) -> Vec<Recipe> {
    let without = |which: usize| {
        let mut tried = recipe;
        for (component, x) in tried.colors[index].iter_mut().enumerate() {
            if which >> component & 1 == 1 && *x < SMALL {
                *x = 0.0;
            }
        }
        tried
    };
    (1..8).map(without).collect()
}

/// How often a measured colour is corrected.
const CORRECTIONS: usize = 5;

/// A component that may be 0, but for what bleeds into it.
const SMALL: f64 = 0.3;

/// How far components are moved at first and at last.
const STEPS: (f64, f64) = (0.01, 0.001);
