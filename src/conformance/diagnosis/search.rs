//! The search for the recipe of a picture.

use super::best::{Best, HOPELESS, NOTHING, UNLIKELY};
use super::changes::changes;
use super::evidence::Evidence;
use super::loss::{Loss, Lossless};
use super::recipe::{Recipe, Sampling};
use super::refine::refined;
use crate::error::Invalid;
use crate::picture::Picture;

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

/// Candidates that are compared more finely.
const POOL: usize = 30;

/// Faults that a picture may have at once.
const DEPTH: usize = 3;

/// What one knob more must gain: this part of the error. Else the simpler recipe is the better.
const PER_KNOB: f64 = 1.2;

/// Two recipes nearer than this, in levels, explain a picture equally well.
const EXACT: f64 = 0.001;

impl Candidate {
    /// The error, and a price for every knob.
    pub fn rank(&self) -> f64 {
        (self.error + EXACT) * PER_KNOB.powi(self.knobs as i32)
    }
}

/// Pixels on which the many hypotheses are compared, and the few.
const ROUGH: usize = 12_000;
const FINE: usize = 40_000;

/// The candidates of a picture, the part of it on which they are to be compared more finely, with
/// the loss that explains it best, and the number of that loss.
///
/// The many are compared before the loss: it changes no order that matters there.
pub(super) fn search<'a>(
    picture: &Picture,
    expected: &Recipe,
    losses: &[&'a dyn Loss],
) -> Result<(Vec<Candidate>, Evidence<'a>, usize), Invalid> {
    let rough = Evidence::sample(picture, ROUGH, &Lossless);
    let candidates = roughly(&rough, expected, losses.is_empty())?;
    let mut nearest: Option<(Evidence, usize, f64)> = None;
    for (number, loss) in losses.iter().enumerate() {
        let fine = Evidence::sample(picture, FINE, *loss);
        let mut error = f64::INFINITY;
        for candidate in candidates.iter().take(PURSUED) {
            error = error.min(fine.error(&candidate.recipe)?);
        }
        if nearest.as_ref().is_none_or(|(.., least)| error < *least) {
            nearest = Some((fine, number, error));
        }
    }
    Ok(match nearest {
        Some((fine, number, _)) => (candidates, fine, number),
        None => (candidates, Evidence::sample(picture, FINE, &Lossless), 0),
    })
}

/// The recipes nearest to the picture, of all with a few faults.
fn roughly(
    evidence: &Evidence,
    expected: &Recipe,
    lossless: bool,
) -> Result<Vec<Candidate>, Invalid> {
    let start = with_error(evidence, *expected, expected)?;
    let mut pool = vec![start];
    let mut front = vec![start];
    for depth in 0..DEPTH {
        let mut next = vec![];
        for candidate in &front {
            for recipe in changes(evidence, &candidate.recipe, expected)? {
                next.push(with_error(evidence, recipe, expected)?);
            }
        }
        let next = nearest(next, expected, BEAM);
        let before = pool
            .iter()
            .map(Candidate::rank)
            .fold(f64::INFINITY, f64::min);
        pool.extend(&next);
        front = next;
        let best = front.first().map_or(f64::INFINITY, Candidate::rank);
        let explained = lossless && before.min(best) < NOTHING;
        // Pairs are always tried: alone, one fault of two may gain nothing.
        if explained || depth > 0 && best >= before {
            break;
        }
    }
    Ok(nearest(pool, expected, POOL))
}

/// The nearest candidates in their conventions, with their numbers; the nearest first.
pub(super) fn finely(
    evidence: &Evidence,
    candidates: Vec<Candidate>,
    expected: &Recipe,
) -> Result<Vec<Candidate>, Invalid> {
    let mut finer = vec![];
    for candidate in candidates {
        finer.push(with_error(evidence, candidate.recipe, expected)?);
    }
    let mut best = nearest(finer, expected, BEAM);
    let hopeful = |candidate: &&mut Candidate| candidate.error <= HOPELESS;
    for candidate in best.iter_mut().take(PURSUED).filter(hopeful) {
        // Numbers first: where they are off, no convention is better than another.
        let guessed = refined(evidence, candidate.recipe, expected)?;
        let mut recipe = guessed;
        if evidence.error(&guessed)? <= UNLIKELY {
            recipe = in_its_conventions(evidence, guessed)?;
        }
        if recipe != guessed {
            recipe = refined(evidence, recipe, expected)?;
        }
        *candidate = with_error(evidence, recipe, expected)?;
    }
    Ok(nearest(best, expected, BEAM))
}

/// Candidates whose conventions and numbers are looked for.
const PURSUED: usize = 4;

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
pub(super) fn nearest(
    mut candidates: Vec<Candidate>,
    expected: &Recipe,
    most: usize,
) -> Vec<Candidate> {
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
    let mut best = Best::of(evidence, recipe)?;
    best.consider(recipe.with_other_rounding())?;
    let rounded = best.recipe;
    // Averages cost most; they come last, and are tried where no single ray explains the silhouettes.
    for sampling in Sampling::ALL {
        if best.error > NOTHING {
            let mut tried = rounded;
            tried.viewpoint.sampling = sampling;
            best.consider(tried)?;
        }
    }
    best.consider(best.recipe.with_other_t_max())?;
    Ok(best.recipe)
}
