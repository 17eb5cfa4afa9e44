//! What is measured of every kernel, quality and format.

use super::cost::{self, KERNELS};
use ombrage::Quality;
use ombrage::conformance::{
    Allowed, Judged, Kernel, Measured, Trial, known_failures, precision, vectors,
};
use serde::{Deserialize, Serialize};

/// The errors of a kernel in a quality and a format, on all of its test vectors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// The kernel, by its name in the protocol.
    pub kernel: String,
    /// The quality; `all` where the kernel has only one.
    pub quality: String,
    /// The format.
    pub float: String,
    /// The allowed error with its unit.
    pub allowed: String,
    /// The largest error outside the known failures, in the same unit.
    pub measured: String,
    /// How many vectors there are.
    pub cases: usize,
    /// Wrong hits, misses and visibilities in all of them.
    pub decisions: usize,
    /// Wrong roots in all of them.
    pub roots: usize,
    /// Cases beyond what is allowed, known failures included.
    pub beyond: usize,
    /// How many families are known to fail.
    pub known: usize,
    /// Why no less is allowed.
    pub reason: String,
}

/// What a kernel costs in a quality and a format.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Costs {
    /// The kernel, by its name in the protocol.
    pub kernel: String,
    /// The format.
    pub float: String,
    /// The quality.
    pub quality: String,
    /// Median nanoseconds a call.
    pub ns: f64,
    /// Median ratio to textbook, of measurements in a row.
    pub ratio: f64,
}

/// How far a kernel is off on a family of test vectors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Family {
    /// The kernel, by its name in the protocol.
    pub kernel: String,
    /// The format.
    pub float: String,
    /// The quality.
    pub quality: String,
    /// The family.
    pub family: String,
    /// How many vectors there are.
    pub cases: usize,
    /// How many of them have a wrong decision or root.
    pub wrong: usize,
    /// The largest error of the others, in units in the last place of the exact value; infinite
    /// errors count as the largest number.
    pub ulps: f64,
}

/// The errors of all kernels.
///
/// # Errors
/// None: the vectors are valid.
pub fn errors() -> Result<Vec<Errors>, String> {
    let mut rows = vec![];
    for kernel in Kernel::ALL {
        let cases = vectors(kernel)?;
        for quality in Quality::ALL {
            if !kernel.has_qualities() && quality != Quality::default() {
                continue;
            }
            for float in ["f32", "f64"] {
                let judged = Trial::of_kit(&cases, quality, float).judged;
                let all = Measured::of(&judged);
                let precision = precision(kernel, quality, float);
                let outside = outside_known(&judged, kernel, quality, float);
                let name = if kernel.has_qualities() {
                    quality.name()
                } else {
                    "all"
                };
                rows.push(Errors {
                    kernel: kernel.name().into(),
                    quality: name.into(),
                    float: float.into(),
                    allowed: precision.allowed.to_string(),
                    measured: measured(&outside, precision.allowed),
                    cases: all.cases,
                    decisions: all.decisions,
                    roots: all.roots,
                    beyond: all.failing,
                    known: known_failures(kernel, quality, float).count(),
                    reason: precision.reason.into(),
                });
            }
        }
    }
    Ok(rows)
}

/// The costs of the kernels that have qualities.
pub fn costs() -> Vec<Costs> {
    let mut rows = vec![];
    for kernel in KERNELS {
        let costs = [cost::costs::<f32>(kernel), cost::costs::<f64>(kernel)];
        for (float, costs) in ["f32", "f64"].into_iter().zip(costs) {
            for (quality, cost) in Quality::ALL.into_iter().zip(costs) {
                rows.push(Costs {
                    kernel: kernel.into(),
                    float: float.into(),
                    quality: quality.name().into(),
                    ns: cost.ns,
                    ratio: cost.ratio,
                });
            }
        }
    }
    rows
}

/// The errors of the kernels that have qualities, family by family.
///
/// # Errors
/// None: the vectors are valid.
pub fn families() -> Result<Vec<Family>, String> {
    let mut rows: Vec<Family> = vec![];
    for kernel in KERNELS.into_iter().filter_map(Kernel::named) {
        let cases = vectors(kernel)?;
        for float in ["f32", "f64"] {
            for quality in Quality::ALL {
                let start = rows.len();
                for judged in Trial::of_kit(&cases, quality, float).judged {
                    let family = judged.case.family();
                    let known = rows[start..].iter().position(|row| row.family == family);
                    let place = known.map_or(rows.len(), |known| start + known);
                    if place == rows.len() {
                        rows.push(Family {
                            kernel: kernel.name().into(),
                            float: float.into(),
                            quality: quality.name().into(),
                            family: family.into(),
                            cases: 0,
                            wrong: 0,
                            ulps: 0.0,
                        });
                    }
                    let row = &mut rows[place];
                    row.cases += 1;
                    row.wrong += usize::from(judged.verdict.wrong.is_some());
                    row.ulps = row.ulps.max(judged.verdict.ulps.min(f64::MAX));
                }
            }
        }
    }
    Ok(rows)
}

fn measured(measured: &Measured, allowed: Allowed) -> String {
    match allowed {
        Allowed::Exact | Allowed::Bytes(_) => {
            format!("{} wrong", measured.decisions + measured.others)
        }
        Allowed::CorrectlyRounded | Allowed::Ulp(_) => format!("{:.3} ulp", measured.ulps),
        Allowed::Bound(_) => format!("{:.3} u B", measured.bounds),
    }
}

/// The largest errors of the cases outside the known failures.
fn outside_known(judged: &[Judged], kernel: Kernel, quality: Quality, float: &str) -> Measured {
    let known =
        |family: &str| known_failures(kernel, quality, float).any(|(failing, _)| failing == family);
    let regular = |judged: &&Judged| !known(judged.case.family());
    Measured::of(judged.iter().filter(regular))
}
