//! `cargo xtask precision`: docs/precision.md, the allowed and the measured errors of every kernel.

mod cost;
mod document;
pub mod measure;

use crate::error::{Error, Result};
use crate::output;
use crate::whole_file::WholeFile;
use crate::workspace;
use std::fs;
use std::io::Write;
use std::process::ExitCode;

/// Write docs/precision.md: for every kernel, quality and format the allowed error, why, and the
/// measured one
///
/// The errors are those of tests/vectors and the same on every machine. The costs, at the end, are
/// measured on this one and not compared by --check.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask precision             measure errors and costs, write docs/precision.md
  cargo xtask precision --check     does the committed file say what is measured?

Exit status: 0 done, or the file is fresh; 1 --check found it stale or missing; 2 bad input.")]
pub struct Args {
    /// Write nothing; say whether the file is stale
    #[arg(long)]
    check: bool,
}

/// The text of docs/precision.md up to the costs: the same on every machine.
///
/// # Errors
/// If a test vector cannot be judged.
pub fn errors() -> Result<String> {
    let rows = measure::errors().map_err(Error::new)?;
    Ok(document::errors(&rows))
}

/// Runs the command.
///
/// # Errors
/// If the file cannot be written.
pub fn run(args: &Args) -> Result<ExitCode> {
    let root = workspace::root()?;
    let rows = measure::errors().map_err(Error::new)?;
    let errors = document::errors(&rows);
    let path = root.join("docs").join("precision.md");
    if args.check {
        let text = fs::read_to_string(&path).unwrap_or_default();
        let committed = text.split(document::COSTS).next();
        if committed == Some(errors.as_str()) {
            return Ok(ExitCode::SUCCESS);
        }
        let name = path.display();
        output::print(&format!(
            "{name} is missing or stale\nwrite it with: cargo xtask precision\n"
        ))?;
        return Ok(ExitCode::from(1));
    }
    let costs = document::costs(&measure::costs(), &rows);
    let text = errors + document::COSTS + &costs;
    let mut file = WholeFile::create(&path)?;
    file.write(|file| file.write_all(text.as_bytes()))?;
    file.keep()?;
    output::print(&text)?;
    Ok(ExitCode::SUCCESS)
}
