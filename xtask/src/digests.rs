//! `cargo xtask digests`: docs/digests.md, what the kit computes, as digests to compare.

mod builds;
mod document;
mod subject;

use crate::error::{Error, Result};
use crate::whole_file::WholeFile;
use crate::{output, workspace};
use builds::{BUILDS, Build};
use std::fs;
use std::io::Write;
use std::process::ExitCode;

/// Write docs/digests.md: digests of figures, radiance, test vectors and errors, which are to be the
/// same everywhere
///
/// Every picture is computed at every level that the processor has, on one thread and on two; it is
/// an error in the kit where they differ. With --builds the kit is built in other ways - unoptimised,
/// for newer processors - and each build compares what it computes with docs/digests.md.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask digests                             write docs/digests.md
  cargo xtask digests --check                     does this machine compute what it says?
  cargo xtask digests --builds dev,release        do these builds?
  cargo xtask digests --builds all                do all of them? (about 15 minutes)

Exit status: 0 written, or all is the same; 1 something differs; 2 bad input.")]
pub struct Args {
    /// Write nothing; name what differs from docs/digests.md
    #[arg(long)]
    check: bool,

    /// Build in these ways, separated by commas, and run --check with each: all, or names of builds
    #[arg(long, value_name = "NAMES", value_parser = builds::parse, conflicts_with = "check")]
    builds: Option<Builds>,
}

/// The chosen builds.
#[derive(Clone)]
struct Builds(Vec<&'static Build>);

/// Runs the command.
///
/// # Errors
/// If scenes or vectors cannot be read, the file not be written, or cargo not be started.
pub fn run(args: &Args) -> Result<ExitCode> {
    let root = workspace::root()?;
    if let Some(Builds(builds)) = &args.builds {
        return builds::compare(&root, builds);
    }
    let (subjects, differences) = subject::all()?;
    if !differences.is_empty() {
        output::print(&(differences.join("\n") + "\n"))?;
        return Ok(ExitCode::FAILURE);
    }
    let path = root.join("docs").join("digests.md");
    let text = document::text(&subjects);
    if args.check {
        let committed = fs::read_to_string(&path).unwrap_or_default();
        let stale = document::differences(&committed, &text);
        if stale.is_empty() {
            return Ok(ExitCode::SUCCESS);
        }
        let advice = "if they are to change: cargo xtask digests";
        output::print(&format!("{stale}{advice}\n"))?;
        return Ok(ExitCode::FAILURE);
    }
    let mut file = WholeFile::create(&path)?;
    file.write(|file| file.write_all(text.as_bytes()))?;
    file.keep()?;
    output::print(&text)?;
    Ok(ExitCode::SUCCESS)
}

/// A digest of some bytes: the first 16 digits of their SHA-256.
fn digest(bytes: impl AsRef<[u8]>) -> String {
    use sha2::{Digest, Sha256};
    let hash = Sha256::digest(bytes);
    hash.iter()
        .take(8)
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// The name of a build that is none.
fn unknown(name: &str) -> String {
    let known: Vec<&str> = BUILDS.iter().map(|build| build.name).collect();
    format!(
        "'{name}' is no build; write all, or one or more of {}",
        known.join(",")
    )
}

/// An error of a part that says it as text.
fn failed(what: &str, why: &dyn std::fmt::Display) -> Error {
    Error::new(format!("cannot {what}: {why}"))
}
