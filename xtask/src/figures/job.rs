//! One figure: drawn, studied, and brought to its files.

use super::annotate::{annotate, is_annotated};
use super::study::{Study, Surveys};
use super::view::View;
use crate::error::Result;
use crate::picture_file;
use crate::proof::Proof;
use crate::whole_file::WholeFile;
use indicatif::ProgressBar;
use ombrage::{Counts, Engine, Figure, Film, Picture, Scalar, Size};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What the table says of a figure.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The figure's.
    pub name: &'static str,
    float: &'static str,
    width: u32,
    height: u32,
    file: PathBuf,
    /// How long it took to draw, without what follows.
    ms: f64,
    ns_per_pixel: f64,
    sphere: usize,
    plane: usize,
    /// Another object blocks the light.
    shadowed: usize,
    wrapped: usize,
    acne_plane: usize,
    acne_sphere: usize,
    /// What proved the pixels, where the picture is proven.
    #[serde(flatten)]
    pub proof: Option<Proof>,
}

/// A picture that is due in a file: what was done about it.
pub enum Outcome {
    /// It is written, and waits to be put in its place.
    Written(WholeFile),
    /// The file holds it already.
    Fresh,
    /// The file lacks it; why.
    Stale(String),
}

/// How many steps of progress a figure takes.
pub const STEPS: u64 = 4;

/// How to draw.
#[derive(Clone, Copy)]
pub struct Drawing {
    /// What with.
    pub engine: Engine,
    /// Whether as exact mathematics has it.
    pub proven: bool,
}

/// What to do with every picture.
#[derive(Clone, Copy)]
pub enum Task<'a> {
    /// Write it to this directory.
    Write(&'a Path),
    /// Compare it with the file in this directory.
    Check(&'a Path),
}

/// Draws a figure, counts what happens at its pixels, and does the task for it and its sheet.
///
/// # Errors
/// If a file cannot be written.
pub fn work<S: Scalar>(
    figure: &'static Figure,
    size: Size,
    Drawing { engine, proven }: Drawing,
    task: Task,
    surveys: &Surveys,
    bar: &ProgressBar,
) -> Result<(Row, Vec<Outcome>)> {
    bar.set_message(format!("figure {}", figure.name));
    let start = Instant::now();
    let proven_picture = if proven {
        figure.prove_with(size, engine)?
    } else {
        None
    };
    let proof = proven_picture.as_ref().map(Proof::of);
    let picture = match proven_picture {
        None => figure.draw_with::<S>(size, engine)?,
        Some(proven) => proven.into_picture(),
    };
    let seconds = start.elapsed().as_secs_f64();
    bar.inc(1);

    let name = format!("fig{}.png", figure.name);
    let (file, plain) = task.treat(Path::new(&name), &picture)?;
    let mut outcomes = vec![plain];
    bar.inc(1);

    let (counts, sheet) = study::<S>(figure, picture, engine, surveys)?;
    bar.inc(1);

    if let Some(sheet) = sheet.filter(|_| !proven) {
        outcomes.push(task.treat(&Path::new("annotated").join(&name), &sheet)?.1);
    }
    bar.inc(1);
    let row = Row {
        name: figure.name,
        float: S::NAME,
        width: size.width(),
        height: size.height(),
        file,
        ms: seconds * 1e3,
        ns_per_pixel: seconds * 1e9 / size.pixels() as f64,
        sphere: counts.sphere,
        plane: counts.plane,
        shadowed: counts.shadowed,
        wrapped: match figure.film {
            Film::Wrap => counts.wrapped,
            Film::Clamp => 0,
        },
        acne_plane: counts.acne_plane,
        acne_sphere: counts.acne_sphere,
        proof,
    };
    Ok((row, outcomes))
}

/// Counts what happens at the pixels of a figure, and draws its sheet if it has one.
///
/// # Errors
/// If there is no memory for it.
pub fn study<S: Scalar>(
    figure: &'static Figure,
    picture: Picture,
    engine: Engine,
    surveys: &Surveys,
) -> Result<(Counts, Option<Picture>)> {
    let size = picture.size();
    let view = View::of(size);
    let shown = view.thin_out(picture);
    let undivided = Figure {
        detail: None,
        ..*figure
    };
    let whole = match figure.detail {
        None => None,
        Some(_) => Some(view.thin_out(undivided.draw_with::<S>(size, engine)?)),
    };
    let findings = surveys.of::<S>(figure, size, &view)?;
    if !is_annotated(figure) {
        return Ok((findings.counts, None));
    }
    let study = Study {
        figure,
        size,
        float: S::NAME,
        view,
        shown,
        whole,
        findings,
    };
    Ok((findings.counts, Some(annotate(&study)?)))
}

impl Task<'_> {
    /// Does the task for the picture that is due in this file; says where the file is.
    fn treat(self, name: &Path, picture: &Picture) -> Result<(PathBuf, Outcome)> {
        match self {
            Task::Write(directory) => {
                let path = directory.join(name);
                let mut file = WholeFile::create(&path)?;
                file.write(|out| picture_file::write(picture, out))?;
                Ok((path, Outcome::Written(file)))
            }
            Task::Check(directory) => {
                let path = directory.join(name);
                let outcome = if !path.exists() {
                    Outcome::Stale(format!("{} is missing", path.display()))
                } else {
                    match picture_file::read(&path) {
                        Ok(found) if found == *picture => Outcome::Fresh,
                        Ok(_) => Outcome::Stale(format!("{} is stale", path.display())),
                        Err(error) => Outcome::Stale(error.to_string()),
                    }
                };
                Ok((path, outcome))
            }
        }
    }
}

impl Row {
    /// The heads of the table's columns.
    pub const HEADS: [&str; 11] = [
        "figure",
        "size",
        "float",
        "ms",
        "ns/pixel",
        "sphere",
        "plane",
        "shadowed",
        "wrapped",
        "acne plane",
        "acne sphere",
    ];

    /// The cells of the table's row where the picture is proven.
    pub fn proven_cells(&self) -> Vec<String> {
        let mut cells = vec![
            self.name.to_owned(),
            format!("{}x{}", self.width, self.height),
            format!("{:.2}", self.ms),
            format!("{:.1}", self.ns_per_pixel),
        ];
        cells.extend(self.proof.iter().flat_map(Proof::cells));
        cells
    }

    /// The cells of the table's row.
    pub fn cells(&self) -> Vec<String> {
        let counts = [
            self.sphere,
            self.plane,
            self.shadowed,
            self.wrapped,
            self.acne_plane,
            self.acne_sphere,
        ];
        let mut cells = vec![
            self.name.to_owned(),
            format!("{}x{}", self.width, self.height),
            self.float.to_owned(),
            format!("{:.2}", self.ms),
            format!("{:.1}", self.ns_per_pixel),
        ];
        cells.extend(counts.map(|count| crate::table::grouped(count as u64)));
        cells
    }
}
