//! `cargo xtask vectors`: the test vectors of the kernels, each with its exact truth.

use crate::error::{Error, Result};
use crate::output;
use crate::whole_file::WholeFile;
use crate::workspace;
use ombrage_oracle::case::KINDS;
use ombrage_oracle::families::write_jsonl;
use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Write the test vectors: one file of JSON Lines for each kind of kernel, each case with its exact
/// truth
///
/// The files are the same on every machine. docs/protocol.md describes their format.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask vectors             write all seven files to tests/vectors
  cargo xtask vectors --check     are the committed files what the oracle writes?
  cargo xtask vectors --out v     write them to the directory v

Exit status: 0 done, or every file is fresh; 1 --check found stale or missing files; 2 bad input.")]
pub struct Args {
    /// Write to this directory [default: tests/vectors of the workspace]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Write nothing; name the files that are missing or stale
    #[arg(long)]
    check: bool,
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
        None => workspace::root()?.join("tests").join("vectors"),
    };
    let files = KINDS.map(|kind| (out.join(format!("{kind}.jsonl")), write_jsonl(kind)));
    if args.check {
        let stale: Vec<String> = files
            .iter()
            .filter(|(path, text)| fs::read(path).ok().as_deref() != Some(text.as_bytes()))
            .map(|(path, _)| format!("{} is missing or stale\n", path.display()))
            .collect();
        if stale.is_empty() {
            return Ok(ExitCode::SUCCESS);
        }
        output::print(&format!(
            "{}write them with: cargo xtask vectors\n",
            stale.concat()
        ))?;
        return Ok(ExitCode::from(1));
    }
    let mut written = vec![];
    for (path, text) in &files {
        let mut file = WholeFile::create(path)?;
        file.write(|file| file.write_all(text.as_bytes()))?;
        written.push(file);
    }
    for file in written {
        file.keep()?;
    }
    for (path, text) in &files {
        output::print(&format!(
            "{}  {} cases\n",
            path.display(),
            text.lines().count()
        ))?;
    }
    Ok(ExitCode::SUCCESS)
}
