//! `cargo xtask figures`: the six figures of the lab as PNG files, plain and annotated.

mod annotate;
mod job;
pub(crate) mod sheet;
mod study;
pub(crate) mod view;

use crate::arguments::{Format, Machine, parse_size};
use crate::error::{Error, Result};
use crate::output;
use crate::progress;
use crate::proof::Proof;
use crate::table::Table;
use crate::workspace;
use job::{Outcome, Row, Task};
use ombrage::{Counts, Engine, FIGURES, Figure, Picture, Size};
use serde::Serialize;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};
use std::thread;
use study::Surveys;

/// Draw the six figures of the lab: fig1.png to fig3c.png as computed, annotated/ with notes
///
/// The plain files hold exactly the pixels computed. Those in annotated/ say what to see: where
/// bytes wrap, which pixels are acne, what is enlarged, where the shadow lies.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask figures                       write all six to docs/figures, print a table
  cargo xtask figures --check               do the committed files show what the code draws?
  cargo xtask figures --only 3a,3c --out a  two of them, in the directory a
  cargo xtask figures --float f64 --size 1200x800 --out big
  cargo xtask figures --out a --json        the table for programs
  cargo xtask figures --proven --out exact  1, 2a, 2b and 3c, every byte that of exact mathematics

Exit status: 0 done, or every file is fresh; 1 --check found stale or missing files, or --proven
pixels that are undecided; 2 bad input.

The columns: hits are pixels that show the sphere or the plane; shadowed: another object blocks the
light; wrapped: a byte passed 255 and wrapped; acne: the surface falsely shadows itself.")]
pub struct Args {
    /// Draw only these figures, separated by commas: 1, 2a, 2b, 3a, 3b, 3c
    #[arg(long, value_name = "NAMES", value_parser = parse_names)]
    only: Option<Names>,

    /// Compute in this format
    #[arg(long, value_enum, default_value_t = Format::F32)]
    float: Format,

    /// Width and height in pixels, at most 2^28 pixels in all
    #[arg(long, value_name = "WxH", default_value = "600x400", value_parser = parse_size)]
    size: Size,

    /// Prove every byte to be that of exact mathematics; the table says in which precision (see
    /// docs/proven.md). 3a and 3b, which show errors of rounding, are left out
    #[arg(long, requires = "out", conflicts_with_all = ["float", "check"])]
    proven: bool,

    #[command(flatten)]
    machine: Machine,

    /// Write to this directory, and to annotated/ in it [default: docs/figures of the workspace]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Print the table as JSON
    #[arg(long, conflicts_with = "check")]
    json: bool,

    /// Write nothing; name the files that are missing or whose pixels differ
    #[arg(long)]
    check: bool,
}

/// The chosen figures, in the lab's order.
#[derive(Clone)]
struct Names(Vec<&'static Figure>);

#[derive(Serialize)]
struct Report {
    figures: Vec<Row>,
}

/// A figure as the lab has it, in `f32`, with its sheet and what happens at its pixels.
pub struct Drawn {
    /// The figure.
    pub figure: &'static Figure,
    /// Exactly the pixels computed.
    pub picture: Picture,
    /// The same with notes; `None` for Figure 1, which needs none.
    pub sheet: Option<Picture>,
    /// What happens at its pixels; those that pass 255 are counted as wrapped, whatever the film.
    pub counts: Counts,
}

/// Draws all figures.
///
/// # Errors
/// If there is no memory for them.
pub fn draw_all() -> Result<Vec<Drawn>> {
    let (engine, surveys) = (Engine::default(), Surveys::default());
    let draw = |figure: &'static Figure| {
        let picture = figure.draw_with::<f32>(Size::LAB, engine)?;
        let (counts, sheet) = job::study::<f32>(figure, picture.clone(), engine, &surveys)?;
        Ok(Drawn {
            figure,
            picture,
            sheet,
            counts,
        })
    };
    FIGURES.iter().map(draw).collect()
}

/// Runs the command.
///
/// # Errors
/// If a file cannot be written; then none is changed.
pub fn run(args: &Args) -> Result<ExitCode> {
    let out = match &args.out {
        Some(out) if out.as_os_str().is_empty() => {
            return Err(Error::new("--out is empty: give a directory"));
        }
        Some(out) => out.clone(),
        None => workspace::root()?.join("docs").join("figures"),
    };
    let engine = args.machine.engine(false)?;
    let task = if args.check {
        Task::Check(&out)
    } else {
        Task::Write(&out)
    };
    let mut figures: Vec<&'static Figure> = match &args.only {
        Some(Names(names)) => names.clone(),
        None => FIGURES.iter().collect(),
    };
    if args.proven {
        let shows_errors = |figure: &&&Figure| figure.lighting().is_none();
        if let Some(figure) = figures
            .iter()
            .find(shows_errors)
            .filter(|_| args.only.is_some())
        {
            let name = figure.name;
            let what =
                format!("--only {name} with --proven: it shows errors of rounding; leave it");
            return Err(Error::new(what));
        }
        figures.retain(|figure| figure.lighting().is_some());
    }
    let long = args.size.pixels() * figures.len() > 1 << 22;
    let bar = progress::bar(job::STEPS * figures.len() as u64, long);
    let surveys = Surveys::default();
    let drawing = job::Drawing {
        engine,
        proven: args.proven,
    };
    let done = all(&figures, args.size, |figure| match args.float {
        Format::F32 => job::work::<f32>(figure, args.size, drawing, task, &surveys, &bar),
        Format::F64 => job::work::<f64>(figure, args.size, drawing, task, &surveys, &bar),
    });
    bar.finish_and_clear();

    let (mut rows, mut stale) = (vec![], vec![]);
    let mut written = vec![];
    for result in done {
        let (row, outcomes) = result?;
        rows.push(row);
        for outcome in outcomes {
            match outcome {
                Outcome::Written(file) => written.push(file),
                Outcome::Fresh => {}
                Outcome::Stale(why) => stale.push(why),
            }
        }
    }
    for file in written {
        file.keep()?;
    }
    if !stale.is_empty() {
        let mut text = stale.join("\n");
        text += "\nto renew them: cargo xtask figures\n";
        output::print(&text)?;
        return Ok(ExitCode::FAILURE);
    }
    let proofs = rows
        .iter()
        .filter_map(|row| Some((row.name, row.proof.as_ref()?)));
    let undecided: String = proofs.map(|(name, proof)| proof.list(name)).collect();
    output::print(&report(rows, args)?)?;
    if undecided.is_empty() {
        return Ok(ExitCode::SUCCESS);
    }
    if !args.json {
        output::print(&format!("not proven:\n{undecided}"))?;
    }
    Ok(ExitCode::FAILURE)
}

fn report(rows: Vec<Row>, args: &Args) -> Result<String> {
    if args.json {
        let mut text = serde_json::to_string_pretty(&Report { figures: rows })
            .map_err(|error| Error::new(format!("cannot write the table as JSON: {error}")))?;
        text += "\n";
        return Ok(text);
    }
    let mut heads = Row::HEADS.to_vec();
    if args.proven {
        heads = ["figure", "size", "ms", "ns/pixel"].to_vec();
        heads.extend(Proof::HEADS);
    }
    let mut table = Table::new(&heads);
    for row in &rows {
        table.row(if args.proven {
            row.proven_cells()
        } else {
            row.cells()
        });
    }
    Ok(table.render())
}

/// Does `work` for every figure, on as many threads as there are cores, in the figures' order.
/// After a failure no other figure is begun.
///
/// Large pictures take turns, so that no more than 2^28 pixels are in memory at a time.
fn all<T: Send>(
    figures: &[&'static Figure],
    size: Size,
    work: impl Fn(&'static Figure) -> Result<T> + Sync,
) -> Vec<Result<T>> {
    let cores = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let in_memory = Size::MOST_PIXELS as usize / size.pixels();
    let queue = Mutex::new(figures.iter().enumerate());
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    let mut done: Vec<(usize, Result<T>)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..cores.min(in_memory).min(figures.len()))
            .map(|_| {
                scope.spawn(|| {
                    let mut results = vec![];
                    while let Some((number, figure)) = next() {
                        let result = work(figure);
                        let failed = result.is_err();
                        results.push((number, result));
                        if failed {
                            while next().is_some() {}
                        }
                    }
                    results
                })
            })
            .collect();
        workers
            .into_iter()
            .flat_map(|worker| {
                worker
                    .join()
                    .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            })
            .collect()
    });
    done.sort_by_key(|(number, _)| *number);
    done.into_iter().map(|(_, result)| result).collect()
}

fn parse_names(text: &str) -> std::result::Result<Names, String> {
    let names: Vec<&str> = text.split(',').map(str::trim).collect();
    if let Some(unknown) = names.iter().find(|name| Figure::named(name).is_none()) {
        let known: Vec<&str> = FIGURES.iter().map(|figure| figure.name).collect();
        return Err(format!(
            "'{unknown}' is no figure; write one or more of {}",
            known.join(",")
        ));
    }
    let chosen = FIGURES.iter().filter(|figure| names.contains(&figure.name));
    Ok(Names(chosen.collect()))
}
