//! `cargo xtask tidy`: whether the house is in order, and how its long checks are run.

mod commands;
mod house;
mod rules;

use crate::error::Result;
use crate::{output, workspace};
use house::House;
use std::process::ExitCode;

/// Check that the house is in order: short files, links and commands of the documentation that
/// exist, no machine's paths; and print how the long checks are run
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask tidy             check; print the long checks
  cargo xtask tidy --quiet     print only what is found

Exit status: 0 all is in order; 1 something is not; 2 bad input.")]
pub struct Args {
    /// Print only what is found
    #[arg(long)]
    quiet: bool,
}

/// A check that takes longer than a change can wait for.
struct Long {
    what: &'static str,
    how: &'static str,
}

/// docs/testing.md says what they are for.
const LONG: [Long; 11] = [
    Long {
        what: "mutation testing of any files in one build (needs cargo-mutants)",
        how: "cargo run --release --manifest-path tests/mutants/Cargo.toml -- src/film.rs",
    },
    Long {
        what: "mutation testing of one file, a build for each change (needs cargo-mutants; hours)",
        how: "cargo mutants --config .cargo/mutants.toml -p ombrage --file src/film.rs",
    },
    Long {
        what: "fuzzing of all that strangers send (as long as you like)",
        how: "PROPTEST_CASES=1000000 cargo test --release -p xtask --test fuzz",
    },
    Long {
        what: "fuzzing that is led by coverage, of one of four targets (needs nightly and cargo-fuzz)",
        how: "tests/fuzz/run scene_file 3600",
    },
    Long {
        what: "every fault in every format and size, judged (20 minutes)",
        how: "OMBRAGE_MATRIX=full cargo test --release -p xtask --test check_matrix -- --nocapture",
    },
    Long {
        what: "commands killed at any moment, 100 times each (2 minutes)",
        how: "OMBRAGE_KILLS=100 cargo test --release -p xtask --test killed -- --nocapture",
    },
    Long {
        what: "proven pictures of as many random scenes as you like",
        how: "PROPTEST_CASES=1000 cargo test --release --test properties no_proof_contradicts -- --nocapture",
    },
    Long {
        what: "every pixel of the proven figures against the exact reference",
        how: "OMBRAGE_REFERENCE_PIXELS=all cargo test --release -p xtask --test proven figure -- --nocapture",
    },
    Long {
        what: "the same bits in every build (15 minutes)",
        how: "cargo xtask digests --builds all",
    },
    Long {
        what: "the oldest Rust (needs rustup; 5 minutes)",
        how: "cargo +1.89 check --workspace --all-targets --locked",
    },
    Long {
        what: "licences, sources and advisories of all dependencies (needs cargo-deny)",
        how: "cargo deny --all-features check --config .cargo/deny.toml",
    },
];

/// Runs the command. `program` is the command line, for the commands that documents show.
///
/// # Errors
/// If the house cannot be read.
pub fn run(args: &Args, program: &clap::Command) -> Result<ExitCode> {
    let house = House::read(&workspace::root()?)?;
    let mut findings = rules::findings(&house);
    findings.extend(commands::findings(&house, program));
    let mut text: String = findings.iter().map(|line| format!("{line}\n")).collect();
    if !args.quiet {
        let files = house.files().len();
        text += &format!(
            "{files} files read, {} things found\n\nThe long checks:\n",
            findings.len()
        );
        for Long { what, how } in &LONG {
            text += &format!("\n{what}\n  {how}\n");
        }
    }
    output::print(&text)?;
    Ok(if findings.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}
