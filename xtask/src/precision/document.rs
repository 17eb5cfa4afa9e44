//! The text of docs/precision.md.

use super::measure::{Costs, Errors};
use ombrage::Quality;
use ombrage::conformance::KNOWN_FAILURES;

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
pub fn errors(rows: &[Errors]) -> String {
    let mut text = HEAD.to_owned();
    text += "## Errors\n\n";
    text += "| kernel | quality | float | allowed | measured | cases | wrong decisions | wrong roots | \
        families known to fail | why no less |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for row in rows {
        text += &format!(
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
            row.kernel,
            row.quality,
            row.float,
            row.allowed,
            row.measured,
            row.cases,
            row.decisions,
            row.roots,
            row.known,
            row.reason,
        );
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
    let of = |quality: Quality| {
        let rows = rows.iter().filter(move |row| row.quality == quality.name());
        rows.fold((0, 0), |(beyond, cases), row| {
            (beyond + row.beyond, cases + row.cases)
        })
    };
    let [textbook, stable, wide] = Quality::ALL.map(of);
    text += &default_quality([textbook.0, stable.0, wide.0], textbook.1);
    text
}

/// What each quality costs on this machine, beside its error.
pub fn costs(costs: &[Costs], errors: &[Errors]) -> String {
    let mut text = "
Scalar code on one core, all qualities in turns in one process: the median of 301 measurements of 512
calls, and the median ratio to `textbook` of measurements in a row. They differ between machines and
runs, so `--check` does not compare them. The errors are those of the first table; wrong: decisions and
roots; beyond: cases whose error is beyond what is allowed, known failures included.

| kernel | float | quality | ns | ratio | error | wrong | beyond | cases |
|---|---|---|---|---|---|---|---|---|
"
    .to_owned();
    for cost in costs {
        let is_same = |row: &&Errors| {
            row.kernel == cost.kernel && row.quality == cost.quality && row.float == cost.float
        };
        let Some(error) = errors.iter().find(is_same) else {
            continue;
        };
        text += &format!(
            "| {} | {} | {} | {:.1} | {:.2} | {} | {} | {} | {} |\n",
            cost.kernel,
            cost.float,
            cost.quality,
            cost.ns,
            cost.ratio,
            error.measured,
            error.decisions + error.roots,
            error.beyond,
            error.cases,
        );
    }
    text
}
