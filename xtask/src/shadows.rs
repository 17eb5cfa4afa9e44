//! `cargo xtask shadows`: every shadow strategy on every scene, judged by the truth.

mod count;
mod heat_map;
mod least_offset;
mod report;
mod strategy;
mod time;
mod trial;

pub use count::Wrong;
pub use least_offset::Offsets;
pub use report::{Row, Total, totals};
pub use strategy::Strategy;
pub(crate) use strategy::{Hits, by_sidedness};
pub use time::Times;

use crate::arguments::parse_png;
use crate::case::{self, Case};
use crate::error::{Error, Result};
use crate::whole_file::WholeFile;
use crate::{output, parallel, picture_file, progress};
use indicatif::ProgressBar;
use ombrage::{Quality, Scalar};
use serde::Serialize;
use std::path::PathBuf;
use std::process::ExitCode;
use trial::Trial;

/// Measure every shadow strategy on every scene: what it gets wrong, and what it costs
///
/// Each strategy is judged pixel by pixel by the truth, which is computed in double-double by
/// another method. Sidedness, the kit's default, is the ray-relative chain; all others are the
/// lab's chain. A scene is first rounded to the format that is judged.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask shadows                      all of tests/scenes: one line a strategy
  cargo xtask shadows planet stack5        these scenes in detail
  cargo xtask shadows mine.toml            a scene file of your own
  cargo xtask shadows --out map.png        and a heat map, strategies by scenes
  cargo xtask shadows --least-offset       is there a constant offset that serves?

Exit status: 0 measured; 2 bad input.

acne: falsely black, the surface shadows itself; false: falsely black, another object seems to
block; leak: falsely lit; turned: falsely black, the surface seems to face away (on camera_on_sphere
the lab's chain sees the surface that the camera is on); scenes: how many have acne, a false shadow
or a leak; edge px: how far the shadow's edge moves at most, in pixels; ns: nanoseconds a shadow ray
from a known hit, on one thread, one ray at a time; for sidedness, of a picture's time with shadows
less that without, which on a busy machine may be below 0.")]
pub struct Args {
    /// Scenes of tests/scenes, or scene files [default: all of tests/scenes]
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,

    /// Print a line for every scene, strategy and format; naming scenes does too
    #[arg(long = "scenes")]
    each: bool,

    /// Search the constant offsets that serve each scene, and print only these
    #[arg(long)]
    least_offset: bool,

    /// Do not take the time
    #[arg(long)]
    no_time: bool,

    /// How well the lab's chain computes: textbook, stable, wide
    #[arg(long, value_name = "QUALITY", default_value = "textbook", value_parser = parse_quality)]
    quality: Quality,

    /// Make the pictures at most this many pixels wide
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..))]
    width: Option<u32>,

    /// Write the heat map to this PNG file
    #[arg(long, value_name = "FILE.png", value_parser = parse_png, conflicts_with = "least_offset")]
    out: Option<PathBuf>,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// The scenes whose time is taken where none is named: two objects, and many.
pub const TIMED: [&str; 2] = ["base", "many125"];

/// Rounds of timing.
const ROUNDS: usize = 25;

#[derive(Serialize)]
struct Report<'a> {
    totals: Vec<Total>,
    scenes: &'a [Row],
    times: &'a [Times],
}

/// Runs the command.
///
/// # Errors
/// If a scene cannot be read, or the heat map cannot be written.
pub fn run(args: &Args) -> Result<ExitCode> {
    let mut cases = case::load(&args.scenes)?;
    if let Some(width) = args.width {
        cases = cases
            .iter()
            .map(|case| case.at_most(width))
            .collect::<Result<_>>()?;
    }
    let quality = args.quality;
    let bar = progress::bar(2 * cases.len() as u64, true);
    if args.least_offset {
        let offsets = offsets(&cases, quality, &bar)?;
        bar.finish_and_clear();
        let text = if args.json {
            json(&offsets)?
        } else {
            least_offset::table(&offsets)
        };
        output::print(&text)?;
        return Ok(ExitCode::SUCCESS);
    }
    let rows = judge(&cases, quality, &bar)?;
    let is_timed = |case: &&Case| !args.scenes.is_empty() || TIMED.contains(&case.name.as_str());
    let timed = cases.iter().filter(is_timed).filter(|_| !args.no_time);
    let times = times(timed, quality, &bar)?;
    bar.finish_and_clear();
    if let Some(out) = &args.out {
        let picture = heat_map::draw(&rows)?;
        let mut file = WholeFile::create(out)?;
        file.write(|out| picture_file::write(&picture, out))?;
        file.keep()?;
    }
    let text = if args.json {
        json(&Report {
            totals: totals(&rows),
            scenes: &rows,
            times: &times,
        })?
    } else {
        let mut text = String::new();
        if args.each || !args.scenes.is_empty() {
            text += &report::scenes_table(&rows, &times);
            text += "\n";
        }
        text + &report::totals_table(&rows, &times) + &report::costs(&times)
    };
    output::print(&text)?;
    Ok(ExitCode::SUCCESS)
}

/// What every strategy gets wrong on every scene, in `f32` and in `f64`; every finished scene and
/// format is a step of the bar.
///
/// # Errors
/// If a scene is invalid in a format.
pub fn judge(cases: &[Case], quality: Quality, bar: &ProgressBar) -> Result<Vec<Row>> {
    let rows = in_both(
        cases,
        bar,
        |case| judge_in::<f32>(case, quality),
        |case| judge_in::<f64>(case, quality),
    )?;
    Ok(rows.into_iter().flatten().collect())
}

/// The constant offsets that serve each scene, in `f32` and in `f64`; every finished scene and
/// format is a step of the bar.
///
/// # Errors
/// If a scene is invalid in a format.
pub fn offsets(cases: &[Case], quality: Quality, bar: &ProgressBar) -> Result<Vec<Offsets>> {
    in_both(
        cases,
        bar,
        |case| Offsets::of::<f32>(case, quality),
        |case| Offsets::of::<f64>(case, quality),
    )
}

/// The times of all strategies on each scene that has a light, in `f32` and in `f64`.
///
/// # Errors
/// If a scene is invalid in a format.
pub fn times<'a>(
    cases: impl Iterator<Item = &'a Case>,
    quality: Quality,
    bar: &ProgressBar,
) -> Result<Vec<Times>> {
    let mut times = vec![];
    for case in cases.filter(|case| !case.scene.lights().is_empty()) {
        bar.set_message(format!("timing {}", case.name));
        times.push(time::take::<f32>(case, quality, ROUNDS)?);
        times.push(time::take::<f64>(case, quality, ROUNDS)?);
    }
    Ok(times)
}

/// What every strategy gets wrong on a scene in a format.
fn judge_in<S: Scalar>(case: &Case, quality: Quality) -> Result<Vec<Row>> {
    let trials = Trial::<S>::each(case, quality)?;
    let row = |strategy: Strategy| {
        Ok(Row {
            scene: case.name.clone(),
            float: S::NAME.into(),
            strategy: strategy.name(),
            wrong: trial::wrong_in_all(&trials, strategy)?,
        })
    };
    Strategy::all().into_iter().map(row).collect()
}

/// Does the work in `f32`, then in `f64`, for every case.
fn in_both<A: Send>(
    cases: &[Case],
    bar: &ProgressBar,
    single: impl Fn(&Case) -> Result<A> + Sync,
    double: impl Fn(&Case) -> Result<A> + Sync,
) -> Result<Vec<A>> {
    let jobs: Vec<(&Case, bool)> = cases
        .iter()
        .flat_map(|case| [(case, false), (case, true)])
        .collect();
    parallel::map(&jobs, |&(case, is_double)| {
        bar.set_message(case.name.clone());
        let answer = if is_double {
            double(case)
        } else {
            single(case)
        };
        bar.inc(1);
        answer
    })
}

fn json(report: &impl Serialize) -> Result<String> {
    let text = serde_json::to_string_pretty(report)
        .map_err(|error| Error::new(format!("cannot write the table as JSON: {error}")))?;
    Ok(text + "\n")
}

fn parse_quality(text: &str) -> std::result::Result<Quality, String> {
    let names = || Quality::ALL.map(Quality::name).join(", ");
    Quality::named(text).ok_or_else(|| format!("write one of {}", names()))
}
