//! A case and one of its lights, with the truth: strategies go on trial.

use super::count::Wrong;
use super::strategy::{Hits, Strategy, by_sidedness};
use crate::case::Case;
use crate::error::Result;
use crate::truth::{self, TruePixel};
use ombrage::{Lighting, Quality, Scalar};

/// A case with one light, what is true of it, and what the lab's chain sees.
pub struct Trial<S: Scalar> {
    case: Case,
    truth: Vec<TruePixel>,
    hits: Hits<S>,
}

impl<S: Scalar> Trial<S> {
    /// One trial for each light of the case, which is first rounded to the format.
    ///
    /// # Errors
    /// If the case is invalid in this format.
    pub fn each(case: &Case, quality: Quality) -> Result<Vec<Self>> {
        let case = case.held_in::<S>()?;
        let lights = 0..case.scene.lights().len();
        lights
            .map(|light| Self::new(case.with_light(light)?, quality))
            .collect()
    }

    fn new(case: Case, quality: Quality) -> Result<Self> {
        let truth = truth::of(&case.scene, &case.view, case.size)?;
        let hits = Hits::new(&case, quality)?;
        Ok(Self { case, truth, hits })
    }

    /// What a strategy gets wrong.
    ///
    /// # Errors
    /// If the view is invalid in this format.
    pub fn wrong(&self, strategy: Strategy) -> Result<Wrong> {
        let size = self.case.size;
        Ok(match strategy {
            Strategy::Lab(shadow) => Wrong::of(&self.truth, self.hits.verdicts(Some(shadow)), size),
            Strategy::Sidedness => {
                let pixels = by_sidedness::<S>(&self.case, Lighting::Shadowed)?;
                Wrong::of(&self.truth, pixels.into_iter(), size)
            }
        })
    }
}

/// What a strategy gets wrong in all trials together.
///
/// # Errors
/// If a view is invalid in this format.
pub fn wrong_in_all<S: Scalar>(trials: &[Trial<S>], strategy: Strategy) -> Result<Wrong> {
    let mut sum = Wrong::default();
    for trial in trials {
        sum.add(&trial.wrong(strategy)?);
    }
    Ok(sum)
}
