//! The text of docs/precision.md.

use super::cost::{KERNELS, costs as measure};
use ombrage::Quality;
use ombrage::conformance::{Allowed, KNOWN_FAILURES, Kernel, known_failures, precision};
use std::path::Path;
use xtask::survey::{Measured, survey, vectors};

/// The line at which the costs begin, which differ from one machine and run to the next.
pub const COSTS: &str = "## Costs\n";

const HEAD: &str = "\
# Precision

Written by `cargo xtask precision` from `src/conformance/precision.rs` and the test vectors in
`tests/vectors`. `tests/hard_cases` holds every kernel to it: an error beyond what is allowed fails, so
does an allowance that could be stricter, and so does a known failure that passes.

| kind | meaning |
|---|---|
| exact | a decision or a whole number, and right |
| n ulp | at most n units in the last place of the exact value; every decision is right |
| k u B | at most k times the a-priori bound of the case, `u * bound_u * \\|t\\|`; a decision whose margin is within three such bounds may fall either way |

Cases: all vectors of the kernel in that format. Decisions and roots: wrong hits, misses and
visibilities, and the other root of the sphere, in all cases, known failures included. Measured: the
largest error of the cases outside the known failures, in units in the last place where that is what is
allowed, else in u B. `shade`, `offset` and `quantise` do not depend on the quality. A hit whose exact t
is beyond the largest number of the format is no hit.

";

const DEFAULT: &str = "\
## The default quality

The default is `stable`. Outside the known failures its error is within a proven bound, where `textbook`
has none; it makes far fewer wrong decisions, and those only within its bound of tangency or an end of
the interval, or where squares leave the range of the format. It costs little more than `textbook`, and
its packets are as fast. `wide` is right on every vector, and is what to choose where a decision must not
be wrong or coordinates leave the range; it is computed ray by ray, so it costs a multiple, most of all in
`f64`. The table of costs, below, has the ratios. Shadows of the kit's own chain need no better quality,
since they rest on sides and not on t.

";

/// Everything but the costs.
///
/// # Errors
/// If the vectors cannot be read.
pub fn errors(directory: &Path) -> Result<String, String> {
    let mut text = HEAD.to_owned();
    text += "## Errors\n\n";
    text += "| kernel | quality | float | allowed | measured | cases | wrong decisions | wrong roots | \
        families known to fail | why no less |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for kernel in Kernel::ALL {
        let cases = vectors(directory, kernel)?;
        for quality in Quality::ALL {
            if !kernel.has_qualities() && quality != Quality::default() {
                continue;
            }
            for float in ["f32", "f64"] {
                let judged = survey(kernel, quality, float, &cases);
                let known: Vec<&str> = known_failures(kernel, quality, float)
                    .map(|(family, _)| family)
                    .collect();
                let all = Measured::of(&judged);
                let outside = Measured::of(judged.iter().filter(|judged| {
                    let family = judged.case["family"].as_str();
                    !family.is_some_and(|family| known.contains(&family))
                }));
                let precision = precision(kernel, quality, float);
                let quality = if kernel.has_qualities() {
                    quality.name()
                } else {
                    "all"
                };
                text += &format!(
                    "| {} | {quality} | {float} | {} | {} | {} | {} | {} | {} | {} |\n",
                    kernel.name(),
                    precision.allowed,
                    measured(&outside, precision.allowed),
                    all.cases,
                    all.decisions,
                    all.roots,
                    known.len(),
                    precision.reason,
                );
            }
        }
    }
    text += "\n## Known failures\n\n| kernel | qualities | floats | families | why |\n|---|---|---|---|---|\n";
    for known in KNOWN_FAILURES {
        let qualities: Vec<&str> = known.qualities.iter().map(|q| q.name()).collect();
        text += &format!(
            "| {} | {} | {} | {} | {} |\n",
            known.kernel.name(),
            qualities.join(", "),
            known.floats.join(", "),
            known.families.join(", "),
            known.reason
        );
    }
    text += "\n";
    text += DEFAULT;
    Ok(text)
}

fn measured(measured: &Measured, allowed: Allowed) -> String {
    match allowed {
        Allowed::Exact => format!("{} wrong", measured.decisions + measured.others),
        Allowed::CorrectlyRounded | Allowed::Ulp(_) => format!("{:.3} ulp", measured.ulps),
        Allowed::Bound(_) => format!("{:.3} u B", measured.bounds),
    }
}

/// What each quality costs on this machine.
pub fn costs() -> String {
    let mut text = "
Scalar code on one core, all qualities in turns in one process: the median of 301 measurements of 512
calls, and the median ratio to `textbook` of measurements in a row. They differ between machines and
runs, so `--check` does not compare them.

| kernel | quality | f32 ns | f32 ratio | f64 ns | f64 ratio |
|---|---|---|---|---|---|
"
    .to_owned();
    for kernel in KERNELS {
        let (single, double) = (measure::<f32>(kernel), measure::<f64>(kernel));
        for ((quality, single), double) in Quality::ALL.iter().zip(single).zip(double) {
            text += &format!(
                "| {kernel} | {} | {:.1} | {:.2} | {:.1} | {:.2} |\n",
                quality.name(),
                single.ns,
                single.ratio,
                double.ns,
                double.ratio
            );
        }
    }
    text
}
