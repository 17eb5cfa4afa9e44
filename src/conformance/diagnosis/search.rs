//! The search for the recipe of a picture.

use super::changes::changes;
use super::evidence::Evidence;
use super::recipe::{Recipe, Rounding, Sampling};
use super::refine::refined;
use crate::error::Invalid;

/// A recipe and how far it is from the picture, in levels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub recipe: Recipe,
    pub error: f64,
    /// How many knobs it has turned.
    pub knobs: usize,
}

/// Candidates that are pursued at each depth.
const BEAM: usize = 10;

/// Faults that a picture may have at once.
const DEPTH: usize = 3;

/// What one knob more must gain, in levels; else the simpler recipe is the better.
const PER_KNOB: f64 = 0.01;

impl Candidate {
    pub fn rank(&self) -> f64 {
        self.error + PER_KNOB * self.knobs as f64
    }
}

/// The recipes nearest to the picture, the nearest first, all with different faults.
pub(super) fn search(evidence: &Evidence, expected: &Recipe) -> Result<Vec<Candidate>, Invalid> {
    let rough = |recipe: Recipe| {
        Ok(Candidate {
            recipe,
            error: evidence.rough_error(&recipe)?,
            knobs: recipe.knobs(expected),
        })
    };
    let start = rough(*expected)?;
    let mut pool = vec![start];
    let mut front = vec![start];
    for _ in 0..DEPTH {
        let mut next = vec![];
        for candidate in &front {
            for recipe in changes(evidence, &candidate.recipe, expected)? {
                next.push(rough(recipe)?);
            }
        }
        let next = nearest(next, expected, BEAM);
        let gained = next.first().is_some_and(|best| {
            let before = pool
                .iter()
                .map(Candidate::rank)
                .fold(f64::INFINITY, f64::min);
            best.rank() < 0.98 * before
        });
        pool.extend(&next);
        front = next;
        if !gained {
            break;
        }
    }
    let pool = nearest(pool, expected, 3 * BEAM);
    let mut finer = vec![];
    for candidate in pool {
        finer.push(with_error(evidence, candidate.recipe, expected)?);
    }
    let mut best = nearest(finer, expected, BEAM);
    for candidate in best.iter_mut().take(PURSUED) {
        let recipe = in_its_conventions(evidence, candidate.recipe)?;
        let recipe = refined(evidence, recipe, expected)?;
        let recipe = in_its_conventions(evidence, recipe)?;
        *candidate = with_error(evidence, recipe, expected)?;
    }
    best.truncate(PURSUED);
    Ok(nearest(best, expected, PURSUED))
}

/// Candidates whose conventions and numbers are looked for.
const PURSUED: usize = 5;

fn with_error(
    evidence: &Evidence,
    recipe: Recipe,
    expected: &Recipe,
) -> Result<Candidate, Invalid> {
    Ok(Candidate {
        recipe,
        error: evidence.error(&recipe)?,
        knobs: recipe.knobs(expected),
    })
}

/// The nearest candidates, one for each set of faults.
fn nearest(mut candidates: Vec<Candidate>, expected: &Recipe, most: usize) -> Vec<Candidate> {
    candidates.sort_by(|a, b| a.rank().total_cmp(&b.rank()));
    let mut kept: Vec<Candidate> = vec![];
    let mut known = vec![];
    for candidate in candidates {
        let faults = candidate.recipe.faults(expected);
        if kept.len() < most && !known.contains(&faults) {
            known.push(faults);
            kept.push(candidate);
        }
    }
    kept
}

/// The recipe in the sampling, the rounding and the `t_max` that fit best.
pub(super) fn in_its_conventions(evidence: &Evidence, recipe: Recipe) -> Result<Recipe, Invalid> {
    let mut best = (recipe, evidence.error(&recipe)?);
    let mut consider = |tried: Recipe| {
        let error = evidence.error(&tried)?;
        if error < best.1 {
            best = (tried, error);
        }
        Ok::<Recipe, Invalid>(best.0)
    };
    let mut tried = recipe;
    tried.rounding = match recipe.rounding {
        Rounding::Truncate => Rounding::Nearest,
        Rounding::Nearest => Rounding::Truncate,
    };
    let rounded = consider(tried)?;
    let mut sampled = rounded;
    for sampling in Sampling::ALL {
        let mut tried = rounded;
        tried.viewpoint.sampling = sampling;
        sampled = consider(tried)?;
    }
    let mut tried = sampled;
    tried.viewpoint.t_max = if sampled.viewpoint.t_max.is_finite() {
        f64::INFINITY
    } else {
        1000.0
    };
    consider(tried)
}
