//! `cargo xtask check`: what is wrong with somebody's picture of a figure.

mod annotate;
pub mod jpeg;
pub mod read;
mod report;

use crate::arguments::parse_png;
use crate::error::{Error, Result};
use crate::whole_file::WholeFile;
use crate::{output, parallel, picture_file, progress};
use jpeg::Jpeg;
use ombrage::conformance::diagnosis::{Diagnosis, Loss, Verdict, diagnose};
use ombrage::{FIGURES, Figure};
use read::Submission;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Say what is wrong with a picture of a figure, drawn by any program
///
/// The picture may have any size from 32x32 to 2^24 pixels (4096x4096); it is compared with the
/// figure at that size. First the conventions are found, which are no faults: where in a pixel its rays go, how numbers become
/// bytes, what JPEG took. Then the faults, each with a stable code, the pixels that show it, the
/// clause of docs/spec.md, and what to look for in the program. docs/check.md lists them all.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask check mine.png --figure 3c          what is wrong with it?
  cargo xtask check mine.jpg --figure 2a --json   the same for programs
  cargo xtask check mine.png --figure 3a --annotate marked.png
  cargo xtask check handed-in --figure 3c         a directory of pictures: a line each

Exit status: 0 conforms; 1 faults, or nothing explains a picture; 2 bad input.

error: how far the picture is from what was found, in levels (steps of a byte) a pixel; margin: 1
where every other explanation is far off, 0 where one is as good.")]
pub struct Args {
    /// A PNG, JPEG, PPM or BMP file, or a directory of them
    #[arg(value_name = "PICTURE")]
    picture: PathBuf,

    /// The figure it claims to be: 1, 2a, 2b, 3a, 3c
    #[arg(long, value_name = "FIGURE", value_parser = parse_figure)]
    figure: &'static Figure,

    /// Print JSON
    #[arg(long)]
    json: bool,

    /// Write the picture with its faults marked to this PNG file
    #[arg(long, value_name = "FILE.png", value_parser = parse_png)]
    annotate: Option<PathBuf>,
}

/// A picture that was judged, or why it could not be.
pub struct Judged {
    /// Its file.
    pub path: PathBuf,
    /// The picture and its diagnosis.
    pub outcome: Result<(Submission, Diagnosis)>,
}

/// Runs the command.
///
/// # Errors
/// If a picture cannot be read, or the annotated one not be written.
pub fn run(args: &Args) -> Result<ExitCode> {
    if args.picture.is_dir() {
        return directory(args);
    }
    let (submission, diagnosis) = judge(&args.picture, args.figure)?;
    if let Some(out) = &args.annotate {
        let sheet = annotate::annotate(&submission, &diagnosis)?;
        let mut file = WholeFile::create(out)?;
        file.write(|out| picture_file::write(&sheet, out))?;
        file.keep()?;
    }
    let text = if args.json {
        report::json(&report::Report::new(&args.picture, &submission, &diagnosis))?
    } else {
        report::text(&submission, &diagnosis)
    };
    output::print(&text)?;
    Ok(status(&diagnosis))
}

/// Reads a picture and finds out what is wrong with it.
///
/// # Errors
/// If it cannot be read.
pub fn judge(path: &Path, figure: &'static Figure) -> Result<(Submission, Diagnosis)> {
    let submission = read::read(path)?;
    let losses: Vec<_> = submission.loss.iter().flat_map(Jpeg::each).collect();
    let losses: Vec<&dyn Loss> = losses.iter().map(|loss| loss as &dyn Loss).collect();
    let diagnosis = diagnose(&submission.picture, figure, &losses)?;
    Ok((submission, diagnosis))
}

fn status(diagnosis: &Diagnosis) -> ExitCode {
    match diagnosis.verdict {
        Verdict::Conforms => ExitCode::SUCCESS,
        Verdict::Faults | Verdict::Unknown => ExitCode::from(1),
    }
}

/// The names that pictures' files end in.
const EXTENSIONS: [&str; 7] = ["png", "jpg", "jpeg", "bmp", "ppm", "pnm", "pgm"];

fn directory(args: &Args) -> Result<ExitCode> {
    if args.annotate.is_some() {
        return Err(Error::new(
            "--annotate marks one picture: give a file, not a directory",
        ));
    }
    let paths = pictures(&args.picture)?;
    let bar = progress::bar(paths.len() as u64, true);
    let judged = parallel::map(&paths, |path| {
        let outcome = judge(path, args.figure);
        bar.inc(1);
        Ok(Judged {
            path: path.clone(),
            outcome,
        })
    })?;
    bar.finish_and_clear();
    let text = if args.json {
        report::json(&report::all(&judged))?
    } else {
        report::table(&judged)
    };
    output::print(&text)?;
    let worst = judged.iter().map(|judged| match &judged.outcome {
        Err(_) => 2,
        Ok((_, diagnosis)) => u8::from(diagnosis.verdict != Verdict::Conforms),
    });
    Ok(ExitCode::from(worst.max().unwrap_or(0)))
}

/// The pictures of a directory, by name.
fn pictures(directory: &Path) -> Result<Vec<PathBuf>> {
    let name = directory.display();
    let failed = |error: std::io::Error| Error::new(format!("cannot read {name}: {error}"));
    let is_picture = |path: &PathBuf| {
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        extension.is_some_and(|extension| EXTENSIONS.contains(&extension.as_str()))
    };
    let mut paths = vec![];
    for entry in fs::read_dir(directory).map_err(failed)? {
        paths.push(entry.map_err(failed)?.path());
    }
    paths.retain(is_picture);
    paths.sort();
    if paths.is_empty() {
        let kinds = EXTENSIONS.join(", ");
        return Err(Error::new(format!(
            "{name} holds no pictures: none ends in {kinds}"
        )));
    }
    Ok(paths)
}

fn parse_figure(name: &str) -> std::result::Result<&'static Figure, String> {
    let whole = |figure: &&Figure| figure.detail.is_none();
    Figure::named(name).filter(whole).ok_or_else(|| {
        let names: Vec<&str> = FIGURES
            .iter()
            .filter(whole)
            .map(|figure| figure.name)
            .collect();
        format!("write one of {}", names.join(", "))
    })
}
