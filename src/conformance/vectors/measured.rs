//! What a trial measured.

use super::{Judged, Verdict, Wrong};
use crate::conformance::Allowed;

/// The largest errors of the cases that do not fail, and how many decisions are wrong in all of
/// them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Measured {
    /// How many cases there are.
    pub cases: usize,
    /// Wrong hits, misses and visibilities.
    pub decisions: usize,
    /// Wrong roots.
    pub roots: usize,
    /// Answers wrong in another way: bytes, sides.
    pub others: usize,
    /// The largest error in units in the last place, of right decisions.
    pub ulps: f64,
    /// The largest error in a-priori bounds, of right decisions.
    pub bounds: f64,
    /// The cases that fail.
    pub failing: usize,
}

impl Measured {
    /// The sum over some cases.
    pub fn of<'a>(judged: impl IntoIterator<Item = &'a Judged<'a>>) -> Self {
        judged.into_iter().fold(Self::default(), |mut sum, judged| {
            let Verdict {
                wrong,
                ulps,
                bounds,
            } = judged.verdict;
            sum.cases += 1;
            sum.failing += usize::from(judged.fails);
            match wrong {
                None => {
                    sum.ulps = sum.ulps.max(ulps);
                    sum.bounds = sum.bounds.max(bounds.unwrap_or(0.0));
                }
                Some(Wrong::Decision) => sum.decisions += 1,
                Some(Wrong::Root) => sum.roots += 1,
                Some(_) => sum.others += 1,
            }
            sum
        })
    }

    /// The measured error in the unit of the allowed one, rounded up: what the allowed one could
    /// be.
    pub fn could_be(&self, allowed: Allowed) -> Option<Allowed> {
        let stricter = match allowed {
            Allowed::Exact | Allowed::CorrectlyRounded | Allowed::Bytes(_) => return None,
            Allowed::Ulp(n) => (n, self.ulps, Allowed::Ulp as fn(u32) -> Allowed),
            Allowed::Bound(k) => (k, self.bounds, Allowed::Bound as fn(u32) -> Allowed),
        };
        let (allowed, measured, kind) = stricter;
        let needed = measured.ceil().max(1.0) as u32;
        (needed < allowed).then(|| kind(needed))
    }
}
