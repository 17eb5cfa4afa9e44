//! The nearest of the recipes that were tried.

use super::evidence::Evidence;
use super::recipe::Recipe;
use crate::error::Invalid;

/// Errors below this leave nothing to explain, where nothing was lost.
pub(super) const NOTHING: f64 = 0.04;

/// Errors above this, in levels, are not made by another convention.
pub(super) const UNLIKELY: f64 = 8.0;

/// Errors above this, in levels, are not those of a recipe whose numbers are a little off.
pub(super) const HOPELESS: f64 = 24.0;

/// A recipe to which nothing that was tried is nearer, and its error, in levels.
pub(super) struct Best<'a> {
    pub evidence: &'a Evidence<'a>,
    pub recipe: Recipe,
    pub error: f64,
}

impl<'a> Best<'a> {
    /// The first recipe that is tried.
    pub fn of(evidence: &'a Evidence<'a>, recipe: Recipe) -> Result<Self, Invalid> {
        Ok(Self {
            evidence,
            recipe,
            error: evidence.error(&recipe)?,
        })
    }

    /// Tries another recipe, and says whether it is nearer.
    pub fn consider(&mut self, other: Recipe) -> Result<bool, Invalid> {
        let error = self.evidence.error(&other)?;
        let is_nearer = error < self.error;
        if is_nearer {
            (self.recipe, self.error) = (other, error);
        }
        Ok(is_nearer)
    }

    /// Moves numbers by smaller and smaller steps, as long as that brings the recipe nearer; each of
    /// `turns` moves one by a step.
    pub fn descend(
        &mut self,
        turns: &[impl Fn(&mut Recipe, f64)],
        (largest, smallest): (f64, f64),
    ) -> Result<(), Invalid> {
        let mut step = largest;
        while step > smallest {
            let mut moved = false;
            for turn in turns {
                for by in [step, -step] {
                    let mut tried = self.recipe;
                    turn(&mut tried, by);
                    if self.consider(tried)? {
                        moved = true;
                        break;
                    }
                }
            }
            if !moved {
                step /= 2.0;
            }
        }
        Ok(())
    }
}
