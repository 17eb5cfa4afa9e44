//! The command: which mutants, how long, and what is printed.

use clap::Parser;
use mutants::compile::{Out, settle};
use mutants::error::{Error, Result};
use mutants::judge::{Effort, try_all};
use mutants::mutant::{self, Mutant};
use mutants::outcomes::{Outcomes, Verdict};
use mutants::project::Project;
use mutants::report::Report;
use mutants::tree::{Tree, has_room};
use mutants::{programs, reach};
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::num::NonZero;
use std::process::ExitCode;

/// Say which changes of the code no test notices
///
/// The changes are those that cargo-mutants names, without those that .cargo/mutants.toml excludes. All
/// changes of the named files are put into one copy of the project, each behind a switch; then each is
/// tried with the tests that reach it, quick ones first. It is noticed where a test fails, or takes 8
/// times as long as it should and 5 s more. Everything is in target/mutants, and a run that was ended
/// goes on where it was.
#[derive(Parser)]
#[command(
    name = "mutants",
    after_help = "\
Examples, after cargo run --release --manifest-path tests/mutants/Cargo.toml --
  src/film.rs                           one file
  src/conformance/diagnosis             a file, and the folder of the same name
  xtask/src/table.rs xtask/src/lines.rs files of the commands
  --package ombrage src/film.rs         quickly, with the tests of the library alone
  --seconds 60 --budget 600 src/film.rs what survived, once more, with slower tests
  --list src                            what is known of all of src; nothing is run
  --anew src/film.rs                    as if nothing were known

Exit status: 0 every change that could be tried is noticed; 1 some are not; 2 bad usage, or something
failed.

Building takes minutes. Switches make kernels slow, and the tests that run them: try what survives again,
in few files. It needs cargo-mutants (cargo install cargo-mutants) and Unix."
)]
struct Cli {
    /// Files or folders with mutants: how their paths begin, from the project's root
    #[arg(value_name = "PATH", default_value = "src")]
    paths: Vec<String>,

    /// Only the tests of this package: those of ombrage build sooner than all
    #[arg(long, value_name = "NAME")]
    package: Option<String>,

    /// The slowest test that is tried, by the seconds that it takes alone
    #[arg(long, value_name = "N", default_value = "5", value_parser = seconds)]
    seconds: f64,

    /// The seconds for one mutant
    #[arg(long, value_name = "N", default_value = "60", value_parser = seconds)]
    budget: f64,

    /// How many tests run at a time
    #[arg(long, value_name = "N", default_value = "2")]
    jobs: NonZero<u16>,

    /// Only print what earlier runs have found
    #[arg(long)]
    list: bool,

    /// Forget what earlier runs have found of these paths
    #[arg(long, conflicts_with = "list")]
    anew: bool,
}

fn seconds(text: &str) -> std::result::Result<f64, String> {
    let number = text.parse().ok();
    number
        .filter(|seconds: &f64| (0.001..=1e6).contains(seconds))
        .ok_or_else(|| "write a number of seconds from 0.001 to 1000000".to_owned())
}

fn main() -> ExitCode {
    run().unwrap_or_else(|error| {
        eprintln!("error: {error}");
        ExitCode::from(2)
    })
}

fn run() -> Result<ExitCode> {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => return Err(Error::from(error)),
        Err(help) => {
            print(&help.render().to_string())?;
            return Ok(ExitCode::SUCCESS);
        }
    };
    let project = Project::read()?;
    let mutants = mutant::list(&project, &cli.paths)?;
    let mut outcomes = Outcomes::read(&project, &mutants)?;
    if !cli.list {
        has_room(mutants.len())?;
        let lock = lock(&project)?;
        if cli.anew {
            outcomes.forget(&cli.paths)?;
        }
        test(&cli, &project, &mutants, &outcomes)?;
        outcomes.reread();
        drop(lock);
    }
    let report = Report::new(&mutants, &outcomes);
    print(&report.text())?;
    Ok(match report.is_clean() {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    })
}

/// Tries all mutants that no test has noticed yet.
fn test(cli: &Cli, project: &Project, mutants: &[Mutant], outcomes: &Outcomes) -> Result<()> {
    let numbers = 0..mutants.len();
    let mut open: Vec<usize> = numbers
        .filter(|&number| !outcomes.is_final(number))
        .collect();
    if open.is_empty() {
        return Ok(());
    }
    let tree = Tree::of(project);
    let known = known(mutants, outcomes);
    let mut out = known.clone();
    let files = settle(project, &tree, mutants, &mut out)?;
    let records = outcomes.records()?;
    for &number in out.unviable.difference(&known.unviable) {
        outcomes.add(&records, number, Verdict::Unviable)?;
    }
    for &number in out.unswitched.difference(&known.unswitched) {
        outcomes.add(&records, number, Verdict::NotSwitched)?;
    }
    open.retain(|&number| !out.has(number));
    let tests = programs::build(&tree, mutants, cli.package.as_deref())?;
    let effort = Effort {
        seconds: cli.seconds,
        budget: cli.budget,
        jobs: usize::from(cli.jobs.get()),
    };
    let digest = tree.digest(&files);
    let bounds = (effort.seconds, effort.jobs);
    let judges = reach::record(project, tree.root(), &digest, tests, bounds)?;
    try_all(tree.root(), &open, &judges, outcomes, effort)
}

/// The mutants that are known not to compile.
fn known(mutants: &[Mutant], outcomes: &Outcomes) -> Out {
    let mut out = Out::default();
    for number in 0..mutants.len() {
        match outcomes.of(number) {
            Some(Verdict::Unviable) => drop(out.unviable.insert(number)),
            Some(Verdict::NotSwitched) => drop(out.unswitched.insert(number)),
            _ => {}
        }
    }
    out
}

/// Makes sure that no other run writes to the same copy, as long as the file is open.
fn lock(project: &Project) -> Result<File> {
    let room = project.room();
    fs::create_dir_all(&room).map_err(|error| Error::at(&room, &error))?;
    let path = room.join("lock");
    let file = File::create(&path).map_err(|error| Error::at(&path, &error))?;
    file.try_lock()
        .map_err(|_| Error::new("another run is at work in target/mutants: wait until it ends"))?;
    Ok(file)
}

/// Prints text as it is. A reader who has left, such as `head`, is no error.
fn print(text: &str) -> Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Error::new(format!(
            "cannot write to standard output: {error}; send it to another file"
        ))),
        _ => Ok(()),
    }
}
