//! The commands of the kit: `cargo xtask`.

use clap::{CommandFactory, Parser, Subcommand};
use std::process::ExitCode;
use xtask::error::{Error, Result};
use xtask::{
    bench, check, compare, conform, digests, explain, figures, kernels, output, precision, render,
    report, shadows, tidy, vectors,
};

/// The commands of the kit. Exit status: 0 all is well, 1 something was found, 2 bad input.
#[derive(Parser)]
#[command(
    name = "cargo xtask",
    bin_name = "cargo xtask",
    disable_help_subcommand = true
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    Figures(figures::Args),
    Render(render::Args),
    Explain(explain::Args),
    Check(check::Args),
    Conform(conform::Args),
    Shadows(shadows::Args),
    Compare(compare::Args),
    Precision(precision::Args),
    Bench(bench::Args),
    Kernels(kernels::Args),
    Vectors(vectors::Args),
    Digests(digests::Args),
    Tidy(tidy::Args),
    Report(report::Args),
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
            output::print(&help.render().to_string())?;
            return Ok(ExitCode::SUCCESS);
        }
    };
    match cli.command {
        Some(Command::Figures(args)) => figures::run(&args),
        Some(Command::Shadows(args)) => shadows::run(&args),
        Some(Command::Compare(args)) => compare::run(&args),
        Some(Command::Kernels(args)) => kernels::run(&args),
        Some(Command::Conform(args)) => conform::run(&args),
        Some(Command::Explain(args)) => explain::run(&args),
        Some(Command::Precision(args)) => precision::run(&args),
        Some(Command::Vectors(args)) => vectors::run(&args),
        Some(Command::Digests(args)) => digests::run(&args),
        Some(Command::Tidy(args)) => tidy::run(&args, &Cli::command()),
        Some(Command::Render(args)) => render::run(&args),
        Some(Command::Report(args)) => report::run(&args),
        Some(Command::Bench(args)) => bench::run(&args),
        Some(Command::Check(args)) => check::run(&args),
        None => {
            output::print(&Cli::command().render_long_help().to_string())?;
            Ok(ExitCode::SUCCESS)
        }
    }
}
