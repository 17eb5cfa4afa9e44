//! All test vectors, answered by the kit and judged.

use crate::judge::{Verdict, Wrong, fails, judge};
use crate::protocol;
use ombrage::Quality;
use ombrage::conformance::{Allowed, Kernel, Kernels, precision};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A case with the kit's answer.
#[derive(Clone, Debug)]
pub struct Judged<'a> {
    /// The test vector.
    pub case: &'a Value,
    /// What the kit answered.
    pub out: Value,
    /// How far that is from the truth.
    pub verdict: Verdict,
    /// Whether that is further than allowed.
    pub fails: bool,
}

/// The test vectors of a kernel, from a directory.
///
/// # Errors
/// If the file cannot be read, or a line is not JSON.
pub fn vectors(directory: &Path, kernel: Kernel) -> Result<Vec<Value>, String> {
    let path = directory.join(format!("{}.jsonl", kernel.name()));
    let text = fs::read_to_string(&path).map_err(|error| {
        format!(
            "cannot read {}: {error}; write it with: cargo xtask vectors",
            path.display()
        )
    })?;
    let parse = |(number, line)| {
        serde_json::from_str(line)
            .map_err(|error| format!("{}, line {}: {error}", path.display(), number + 1))
    };
    text.lines().enumerate().map(parse).collect()
}

/// What the kit makes of all cases of one format.
pub fn survey<'a>(
    kernel: Kernel,
    quality: Quality,
    float: &str,
    cases: &'a [Value],
) -> Vec<Judged<'a>> {
    let kernels = Kernels {
        quality,
        shadow: None,
    };
    let allowed = precision(kernel, quality, float).allowed;
    cases
        .iter()
        .filter(|case| case["prec"] == float)
        .map(|case| {
            let out = match protocol::output(&kernels, case) {
                Ok(Ok(out)) => out,
                Ok(Err(why)) | Err(why) => Value::String(why),
            };
            let verdict = judge(case, &out);
            Judged {
                case,
                fails: fails(case, &verdict, allowed),
                out,
                verdict,
            }
        })
        .collect()
}

/// The families of which a case fails.
pub fn failing<'a>(judged: &'a [Judged]) -> BTreeSet<&'a str> {
    judged
        .iter()
        .filter(|judged| judged.fails)
        .filter_map(|judged| judged.case["family"].as_str())
        .collect()
}

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
            Allowed::Exact | Allowed::CorrectlyRounded => return None,
            Allowed::Ulp(n) => (n, self.ulps, Allowed::Ulp as fn(u32) -> Allowed),
            Allowed::Bound(k) => (k, self.bounds, Allowed::Bound as fn(u32) -> Allowed),
        };
        let (allowed, measured, kind) = stricter;
        let needed = measured.ceil().max(1.0) as u32;
        (needed < allowed).then(|| kind(needed))
    }
}
