//! `cargo xtask compare`: the same picture in `f32`, in `f64`, and in truth.

pub mod moved;
mod subject;
mod verdict;

pub use subject::Subject;
pub use verdict::Verdict;
pub(crate) use verdict::differing;

use crate::error::{Error, Result};
use crate::table::{Table, grouped};
use crate::{case, clock, output, progress};
use indicatif::ProgressBar;
use ombrage::FIGURES;
use serde::{Deserialize, Serialize};
use std::process::ExitCode;
use subject::Way;

/// Compare f32 with f64 with the truth, on every figure and scene
///
/// The truth is the proven picture for bytes (docs/proven.md), and double-double for the radiance;
/// flips are judged by a second method. The scene is taken as the file gives it, so what f32 loses
/// when it reads the scene counts too. Each picture is computed in two ways: lab, the lab's chain
/// with textbook kernels (a figure as it is defined, a scene with the offset by units in the last
/// place), and relative, the kit's default.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask compare                all figures, and all of tests/scenes
  cargo xtask compare 3c planet      a figure and a scene
  cargo xtask compare --moved        the lab's scene, moved away from the origin by 10^k

Exit status: 0 compared; 2 bad input.

largest, mean: the error of the radiance where nothing flips; bytes: how many differ from the truth;
silhouette: pixels that show another object, one of the two a sphere; horizon: another object, none
a sphere; shadow: pixels and lights that are falsely lit or falsely black; f64/f32: time of the
picture in f64 over that in f32, on one thread, one pixel at a time.")]
pub struct Args {
    /// Figures (1, 2a ... 3c), scenes of tests/scenes, or scene files [default: all]
    #[arg(value_name = "FIGURE|SCENE")]
    pictures: Vec<String>,

    /// Move the lab's scene by 10^k along each axis, k = 0 ... 8, and count the wrong bytes
    #[arg(long, conflicts_with = "pictures")]
    moved: bool,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Rounds of timing.
const ROUNDS: usize = 7;

/// A picture computed in one way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// `figure 3c`, or the name of a scene.
    pub picture: String,
    /// `lab` or `relative`.
    pub way: String,
    /// What is wrong with it in `f32`.
    pub f32: Verdict,
    /// The same in `f64`.
    pub f64: Verdict,
    /// The time it takes in `f64` over that in `f32`, one pixel at a time.
    pub time_f64_over_f32: f64,
}

/// Runs the command.
///
/// # Errors
/// If there is no such figure or scene, or a scene cannot be read.
pub fn run(args: &Args) -> Result<ExitCode> {
    let text = if args.moved {
        let rows = moved::measure()?;
        if args.json {
            json(&rows)?
        } else {
            moved::table(&rows)
        }
    } else {
        let subjects = subjects(&args.pictures)?;
        let bar = progress::bar(subjects.len() as u64, true);
        let rows = measure(&subjects, &bar)?;
        bar.finish_and_clear();
        if args.json {
            json(&rows)?
        } else {
            table(&rows)
        }
    };
    output::print(&text)?;
    Ok(ExitCode::SUCCESS)
}

/// The figures and scenes of these names; all of them where none is named.
///
/// # Errors
/// If there is no such scene, or it cannot be read.
pub fn subjects(names: &[String]) -> Result<Vec<Subject>> {
    let is_figure = |name: &&String| FIGURES.iter().any(|figure| figure.name == **name);
    let (figures, scenes): (Vec<_>, Vec<_>) = names.iter().partition(is_figure);
    let mut subjects = vec![];
    for figure in &FIGURES {
        if names.is_empty() || figures.iter().any(|name| figure.name == *name) {
            subjects.push(Subject::figure(figure)?);
        }
    }
    if names.is_empty() || !scenes.is_empty() {
        let scenes: Vec<String> = scenes.into_iter().cloned().collect();
        subjects.extend(case::load(&scenes)?.into_iter().map(Subject::scene));
    }
    Ok(subjects)
}

/// Both ways of every picture; each finished picture is a step of the bar.
///
/// # Errors
/// If a scene is invalid in a format.
pub fn measure(subjects: &[Subject], bar: &ProgressBar) -> Result<Vec<Row>> {
    let mut rows = vec![];
    for subject in subjects {
        bar.set_message(subject.name());
        rows.extend(judge(subject)?);
        bar.inc(1);
    }
    Ok(rows)
}

/// Both ways of a picture.
fn judge(subject: &Subject) -> Result<Vec<Row>> {
    let truth = subject.truth()?;
    let mut rows = vec![];
    for way in [Way::Lab, Way::Relative] {
        let single = subject.compute::<f32>(way)?;
        let double = subject.compute::<f64>(way)?;
        let mut tasks = [subject.draw::<f32>(way)?, subject.draw::<f64>(way)?];
        let seconds = clock::interleaved(ROUNDS, &mut tasks);
        rows.push(Row {
            picture: subject.name(),
            way: way.name().into(),
            f32: Verdict::of(&truth, &single),
            f64: Verdict::of(&truth, &double),
            time_f64_over_f32: seconds[1] / seconds[0],
        });
    }
    Ok(rows)
}

fn table(rows: &[Row]) -> String {
    let mut table = Table::new(&[
        "picture",
        "way",
        "float",
        "largest",
        "mean",
        "bytes",
        "silhouette",
        "horizon",
        "shadow",
        "f64/f32",
    ]);
    for row in rows {
        let floats = [("f32", &row.f32), ("f64", &row.f64)];
        for (float, verdict) in floats {
            let counts = [
                verdict.bytes,
                verdict.silhouette,
                verdict.horizon,
                verdict.shadow,
            ];
            let mut cells = vec![
                row.picture.clone(),
                row.way.clone(),
                float.to_owned(),
                format!("{:.1e}", verdict.largest),
                format!("{:.1e}", verdict.mean),
            ];
            cells.extend(counts.map(|count| grouped(count as u64)));
            let ratio = format!("{:.2}", row.time_f64_over_f32);
            cells.push(if float == "f64" { ratio } else { String::new() });
            table.row(cells);
        }
    }
    table.render()
}

fn json(report: &impl Serialize) -> Result<String> {
    let text = serde_json::to_string_pretty(report)
        .map_err(|error| Error::new(format!("cannot write the table as JSON: {error}")))?;
    Ok(text + "\n")
}
