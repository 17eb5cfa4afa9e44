//! Is there a constant offset that serves? The smallest without acne, the largest without a leak or
//! a false shadow.

use super::strategy::Strategy;
use super::trial::{Trial, wrong_in_all};
use crate::case::Case;
use crate::error::Result;
use crate::table::Table;
use ombrage::{Quality, Scalar, Shadow};
use serde::{Deserialize, Serialize};

/// The constant offsets that serve a scene, in scene units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Offsets {
    /// The scene.
    pub scene: String,
    /// The format.
    pub float: String,
    /// The smallest without acne; `None`: none up to 10^6.
    pub least: Option<f64>,
    /// The largest without a leak or a false shadow; `None`: not even 10^-18.
    pub most: Option<f64>,
}

/// The decades that are searched.
const DECADES: std::ops::RangeInclusive<i32> = -18..=6;

/// Steps a decade is divided into.
const STEPS: i32 = 32;

impl Offsets {
    /// Searches decade by decade from below, then halves the decade where the answer changes.
    ///
    /// # Errors
    /// If the case is invalid in this format.
    pub fn of<S: Scalar>(case: &Case, quality: Quality) -> Result<Self> {
        let trials = Trial::<S>::each(case, quality)?;
        let wrong = |step: i32| {
            let offset = Shadow::ConstantOffset(length(step));
            wrong_in_all(&trials, Strategy::Lab(offset))
        };
        let least = first(|step| Ok(wrong(step)?.acne == 0))?;
        let spoilt = first(|step| {
            let wrong = wrong(step)?;
            Ok(wrong.leak + wrong.false_shadow > 0)
        })?;
        let lowest = DECADES.start() * STEPS;
        let most = match spoilt {
            None => Some(length(DECADES.end() * STEPS)),
            Some(step) if step == lowest => None,
            Some(step) => Some(length(step - 1)),
        };
        Ok(Self {
            scene: case.name.clone(),
            float: S::NAME.into(),
            least: least.map(length),
            most,
        })
    }

    /// Whether an offset serves.
    pub fn serve(&self) -> bool {
        matches!((self.least, self.most), (Some(least), Some(most)) if least <= most)
    }
}

/// The length at a step.
fn length(step: i32) -> f64 {
    10f64.powf(f64::from(step) / f64::from(STEPS))
}

/// The first step at which `holds`, if that does not change more than once within a decade.
fn first(mut holds: impl FnMut(i32) -> Result<bool>) -> Result<Option<i32>> {
    for decade in DECADES {
        let mut high = decade * STEPS;
        if !holds(high)? {
            continue;
        }
        let mut low = high - STEPS;
        if decade == *DECADES.start() {
            return Ok(Some(high));
        }
        while high - low > 1 {
            let middle = i32::midpoint(low, high);
            if holds(middle)? {
                high = middle;
            } else {
                low = middle;
            }
        }
        return Ok(Some(high));
    }
    Ok(None)
}

/// The table of the offsets.
pub fn table(offsets: &[Offsets]) -> String {
    let mut table = Table::new(&[
        "scene",
        "float",
        "least without acne",
        "most without leak, false shadow",
        "serves",
    ]);
    for offset in offsets {
        let ends = [DECADES.start(), DECADES.end()].map(|decade| length(decade * STEPS));
        let show = |bound: Option<f64>| match bound {
            None => "none".to_owned(),
            Some(bound) if ends.contains(&bound) => "any".to_owned(),
            Some(bound) => format!("{bound:.2e}"),
        };
        let serves = if offset.serve() { "yes" } else { "no constant" };
        table.row(vec![
            offset.scene.clone(),
            offset.float.clone(),
            show(offset.least),
            show(offset.most),
            serves.to_owned(),
        ]);
    }
    table.render()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_step_that_holds_is_found() {
        for wanted in [-18 * STEPS, -100, 0, 77, 6 * STEPS] {
            let found = first(|step| Ok(step >= wanted)).expect("a search");
            assert_eq!(found, Some(wanted));
        }
        assert_eq!(first(|_| Ok(false)).expect("a search"), None);
    }
}
