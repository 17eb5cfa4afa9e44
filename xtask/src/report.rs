//! `cargo xtask report`: one page that shows speed against error.

mod chart;
pub mod clauses;
pub mod data;
mod headline;
pub mod height;
pub mod measure;
pub mod page;
mod plot;
pub mod proofs;
mod readme;
mod run;
mod stages;

use crate::error::{Error, Result};
use crate::figures;
use crate::output;
use crate::whole_file::WholeFile;
use crate::workspace;
use data::Data;
use page::Pictures;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Measure everything and write docs/report: the data, and one page that shows them
///
/// The page holds its pictures and plots; it needs no network and no script. It shows what acne is,
/// which cure works, what it costs, and how far f32 can be trusted.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask report                      measure (2 to 4 minutes); write data, page, README's figures
  cargo xtask report --quick --out quick  the same with small pictures, to see that it works
  cargo xtask report --from docs/report/data.json    write the page from these; measure nothing
  cargo xtask report --check              is the page what docs/report/data.json gives?

Exit status: 0 written, or all is fresh; 1 --check found something stale; 2 bad input.")]
pub struct Args {
    /// Fewer and smaller pictures, under 30 seconds; not for publication
    #[arg(long)]
    quick: bool,

    /// Measure nothing; write the page from these data, and copy them beside it
    #[arg(long, value_name = "DATA.json", conflicts_with = "quick")]
    from: Option<PathBuf>,

    /// Write to this directory, and leave the README alone [default: docs/report of the workspace]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Write nothing; say whether page, README and its pictures are what the data give
    #[arg(long, conflicts_with_all = ["quick", "from"])]
    check: bool,
}

/// Runs the command.
///
/// # Errors
/// If the data are of another version or cut short, or a file cannot be written; then no file is
/// changed.
pub fn run(args: &Args) -> Result<ExitCode> {
    let root = workspace::root()?;
    let out = args
        .out
        .clone()
        .unwrap_or_else(|| root.join("docs").join("report"));
    let places = [out.join("data.json"), out.join("index.html")];
    let pictures = Pictures::new(figures::draw_all()?);
    if args.check {
        return check(&root, &places, &pictures);
    }
    let given = args.from.as_deref().map(read).transpose()?;
    // Begun before the work, so that a place that cannot be written to is found out at once.
    let mut files = vec![
        WholeFile::create(&places[0])?,
        WholeFile::create(&places[1])?,
    ];
    let json = match given {
        Some(json) => json,
        None => measure::all(&root, args.quick, pictures.drawn())?.to_json()?,
    };
    let data = Data::parse(&json, "the data")?;
    let mut texts = vec![json, page::page(&data, &pictures)?];
    if args.out.is_none() {
        let readme = root.join("README.md");
        texts.push(readme::renewed(&readme, &data)?);
        files.push(WholeFile::create(&readme)?);
    }
    for (file, text) in files.iter_mut().zip(&texts) {
        file.write(|file| file.write_all(text.as_bytes()))?;
    }
    for file in files {
        file.keep()?;
    }
    let written = places
        .iter()
        .map(|place| format!("wrote {}\n", place.display()));
    output::print(&written.collect::<String>())?;
    Ok(ExitCode::SUCCESS)
}

/// The text of a file of data, which is whole and of this version.
fn read(path: &Path) -> Result<String> {
    Data::read(path)?;
    fs::read_to_string(path)
        .map_err(|error| Error::new(format!("cannot read {}: {error}", path.display())))
}

/// Names what is not as the data have it.
fn check(root: &Path, [data, page]: &[PathBuf; 2], pictures: &Pictures) -> Result<ExitCode> {
    let found = Data::read(data)?;
    let readme = root.join("README.md");
    let expected = [
        (page, page::page(&found, pictures)?),
        (&readme, readme::renewed(&readme, &found)?),
    ];
    let mut complaints = readme::stale_pictures(root, pictures)?;
    for (path, text) in expected {
        if fs::read_to_string(path).ok().as_deref() != Some(text.as_str()) {
            complaints.push(format!(
                "{} is missing or stale; renew it with: cargo xtask report --from {}",
                path.display(),
                data.display()
            ));
        }
    }
    if complaints.is_empty() {
        return Ok(ExitCode::SUCCESS);
    }
    output::print(&(complaints.join("\n") + "\n"))?;
    Ok(ExitCode::FAILURE)
}
