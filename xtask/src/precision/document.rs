//! The text of docs/precision.md.

use super::cost::{KERNELS, costs as measure};
use ombrage::Quality;
use ombrage::conformance::{
    Allowed, Judged, KNOWN_FAILURES, Kernel, Measured, Trial, known_failures, precision, vectors,
};

/// The line at which the costs begin, which differ from one machine and run to the next.
pub const COSTS: &str = "## Speed against error\n";

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

/// Why the default quality is the default; the numbers are those of the table.
fn default_quality(beyond: [usize; 3], cases: usize) -> String {
    let [textbook, stable, wide] = beyond;
    format!(
        "\
## The default quality

The default is `{}`. Of the {cases} cases of rays and lights, {textbook} are beyond what is allowed for
`textbook`, {stable} for `stable` and {wide} for `wide`. Those of `stable` are all of one kind: coordinates
whose products leave the range of the format, which is none that scenes have. Elsewhere it keeps the bound
of its form, and `textbook` keeps none.

The costs below: a call of `stable` takes up to about twice the time of `textbook`, and it can be computed
in packets. `wide` takes 4 to 12 times as long in `f32`, 50 times and more in `f64`, and goes lane by lane:
the quality to choose where no decision may be wrong, or coordinates leave the range. Shadows of the kit's
own chain need no better quality than the default, since they rest on sides and not on t.

",
        Quality::default().name()
    )
}

/// Everything but the costs.
///
/// # Errors
/// None: the vectors are valid.
pub fn errors() -> Result<String, String> {
    let mut text = HEAD.to_owned();
    let (mut beyond, mut all_cases) = ([0; 3], 0);
    text += "## Errors\n\n";
    text += "| kernel | quality | float | allowed | measured | cases | wrong decisions | wrong roots | \
        families known to fail | why no less |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for kernel in Kernel::ALL {
        let cases = vectors(kernel)?;
        for (quality, beyond) in Quality::ALL.into_iter().zip(&mut beyond) {
            if !kernel.has_qualities() && quality != Quality::default() {
                continue;
            }
            for float in ["f32", "f64"] {
                let judged = Trial::of_kit(&cases, quality, float).judged;
                let known = known_failures(kernel, quality, float).count();
                let all = Measured::of(&judged);
                if kernel.has_qualities() {
                    *beyond += all.failing;
                    all_cases += all.cases;
                }
                let outside = outside_known(&judged, kernel, quality, float);
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
                    known,
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
    text += &default_quality(beyond, all_cases / Quality::ALL.len());
    Ok(text)
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

/// What each quality costs on this machine, beside its error.
///
/// # Errors
/// None: the vectors are valid.
pub fn costs() -> Result<String, String> {
    let mut text = "
Scalar code on one core, all qualities in turns in one process: the median of 301 measurements of 512
calls, and the median ratio to `textbook` of measurements in a row. They differ between machines and
runs, so `--check` does not compare them. The errors are those of the first table; wrong: decisions and
roots; beyond: cases whose error is beyond what is allowed, known failures included.

| kernel | float | quality | ns | ratio | error | wrong | beyond | cases |
|---|---|---|---|---|---|---|---|---|
"
    .to_owned();
    for kernel in Kernel::ALL
        .into_iter()
        .filter(|kernel| KERNELS.contains(&kernel.name()))
    {
        let cases = vectors(kernel)?;
        let costs = [measure::<f32>(kernel.name()), measure::<f64>(kernel.name())];
        for (float, costs) in ["f32", "f64"].into_iter().zip(costs) {
            for (quality, cost) in Quality::ALL.into_iter().zip(costs) {
                let judged = Trial::of_kit(&cases, quality, float).judged;
                let all = Measured::of(&judged);
                let allowed = precision(kernel, quality, float).allowed;
                text += &format!(
                    "| {} | {float} | {} | {:.1} | {:.2} | {} | {} | {} | {} |\n",
                    kernel.name(),
                    quality.name(),
                    cost.ns,
                    cost.ratio,
                    measured(&outside_known(&judged, kernel, quality, float), allowed),
                    all.decisions + all.roots,
                    all.failing,
                    all.cases,
                );
            }
        }
    }
    Ok(text)
}

/// The largest errors of the cases outside the known failures.
fn outside_known(judged: &[Judged], kernel: Kernel, quality: Quality, float: &str) -> Measured {
    let known =
        |family: &str| known_failures(kernel, quality, float).any(|(failing, _)| failing == family);
    let regular = |judged: &&Judged| !known(judged.case.family());
    Measured::of(judged.iter().filter(regular))
}
