//! `cargo xtask conform`: someone else's kernels, judged by the test vectors.

mod child;
mod interview;
mod notes;
mod report;

use crate::error::{Error, Result};
use crate::{output, progress};
use child::Child;
use indicatif::ProgressBar;
use interview::ask;
use ombrage::Quality;
use ombrage::conformance::{Case, Kernel, vectors};
use report::Report;
use std::collections::BTreeSet;
use std::env;
use std::ffi::OsString;
use std::process::ExitCode;
use std::time::Duration;

/// Judge the kernels of another program, in any language: ask it the test vectors over standard
/// input and output, and say what it gets wrong, by how much, and what it is known for
///
/// docs/conform.md tells how to hook up your kernels; docs/adapters has programs to copy. A kind
/// that the program does not do is unsupported, which is no fault. A program that crashes or hangs
/// is started anew, and asked the rest.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask conform -- python3 docs/adapters/ray.py
  cargo xtask conform --kind ray_sphere --prec f32 -- ./my-kernels --fast
  cargo xtask conform --pattern tangent -- ./my-kernels       families whose name has \"tangent\"
  cargo xtask conform --number ray_plane.generic.f32.0001 -- ./my-kernels
  cargo xtask conform -- cargo xtask kernels --quality wide   the kit's own kernels: no finding

Exit status: 0 it conforms, or does nothing of this; 1 something is wrong; 2 bad usage, or a program
that cannot run.")]
pub struct Args {
    /// Ask only about this kind: a name as in the protocol, such as `ray_sphere`
    #[arg(long, value_name = "KIND", value_parser = kernel)]
    kind: Option<Kernel>,

    /// Ask only in this format: f32 or f64
    #[arg(long, value_name = "PREC", value_parser = ["f32", "f64"])]
    prec: Option<String>,

    /// Ask only families with this in their name
    #[arg(long, value_name = "FAMILY")]
    pattern: Option<String>,

    /// Ask only the case of this id
    #[arg(long, value_name = "ID")]
    number: Option<String>,

    /// Seconds that the program has for one answer
    #[arg(long, value_name = "S", default_value = "10", value_parser = seconds)]
    timeout: Duration,

    /// Hold it to what the kit allows its own kernels of this quality: textbook, stable or wide
    /// [default: what any good kernel can keep]
    #[arg(long, value_name = "QUALITY", value_parser = quality)]
    quality: Option<Quality>,

    /// Print JSON
    #[arg(long)]
    json: bool,

    /// The program and its arguments
    #[arg(last = true, required = true, value_name = "PROGRAM ARGS")]
    program: Vec<OsString>,
}

fn kernel(name: &str) -> std::result::Result<Kernel, String> {
    let names = || Kernel::ALL.map(Kernel::name).join(", ");
    Kernel::named(name).ok_or_else(|| format!("choose one of {}", names()))
}

fn quality(name: &str) -> std::result::Result<Quality, String> {
    let names = || Quality::ALL.map(Quality::name).join(", ");
    Quality::named(name).ok_or_else(|| format!("choose one of {}", names()))
}

/// The longest time for an answer: a day.
const LONGEST: f64 = 86_400.0;

fn seconds(text: &str) -> std::result::Result<Duration, String> {
    let seconds = text.parse().ok().filter(|s| (0.001..=LONGEST).contains(s));
    let advice = "write seconds from 0.001 to 86400, such as 10 or 0.5";
    seconds
        .map(Duration::from_secs_f64)
        .ok_or_else(|| advice.to_owned())
}

/// Runs the command.
///
/// # Errors
/// If no case is chosen, or the program cannot run.
pub fn run(args: &Args) -> Result<ExitCode> {
    let cases = chosen(args)?;
    let bar = progress::bar(cases.len() as u64, true);
    let ask = |program: &[OsString]| {
        let start = |input| Child::start(program, input);
        ask(start, &cases, args.timeout, &bar)
    };
    let interview = ask(&args.program);
    bar.finish_and_clear();
    let interview = interview?;
    let own = own_program().and_then(|own| ask(&own).ok());
    let own = own.map(|own| own.times).unwrap_or_default();
    let report = Report::new(&cases, &interview, args.quality);
    let text = if args.json {
        report.json()?
    } else {
        report.text(&interview.times, &own)
    };
    output::print(&text)?;
    Ok(ExitCode::from(u8::from(report.has_faults())))
}

/// What is said of a program of which each process prints one of these outputs, and those that are
/// started after them print nothing: as text and as JSON.
///
/// # Errors
/// None that can be foreseen: no program is started.
pub fn judge(cases: &[Case], outputs: &[&[u8]], quality: Option<Quality>) -> Result<[String; 2]> {
    let mut outputs = outputs.iter().copied();
    let start = |_| Ok(outputs.next().unwrap_or_default());
    let interview = ask(start, cases, Duration::from_secs(1), &ProgressBar::hidden())?;
    let report = Report::new(cases, &interview, quality);
    let text = report.text(&interview.times, &interview.times);
    Ok([text, report.json()?])
}

/// The cases that the options choose, in the order of the vectors.
fn chosen(args: &Args) -> Result<Vec<Case>> {
    let kernels = Kernel::ALL.into_iter();
    let kernels = kernels.filter(|kernel| args.kind.is_none_or(|kind| kind == *kernel));
    let mut cases = vec![];
    for kernel in kernels {
        cases.extend(vectors(kernel).map_err(Error::new)?);
    }
    cases.retain(|case| args.prec.as_ref().is_none_or(|prec| prec == case.float()));
    let mut families: BTreeSet<String> = BTreeSet::new();
    if let Some(pattern) = &args.pattern {
        families.extend(cases.iter().map(|case| case.family().to_owned()));
        cases.retain(|case| case.family().contains(pattern));
    }
    if let (true, Some(pattern)) = (cases.is_empty(), &args.pattern) {
        let families: Vec<String> = families.into_iter().collect();
        return Err(Error::new(format!(
            "--pattern {pattern} is in no family's name: choose of {}",
            families.join(", ")
        )));
    }
    if let Some(number) = &args.number {
        cases.retain(|case| case.id() == number);
        if cases.is_empty() {
            return Err(Error::new(format!(
                "--number {number} is the id of none of these cases: write one such as \
                 ray_sphere.generic.f32.0001, and the kind and prec that it has"
            )));
        }
    }
    Ok(cases)
}

/// The kit's own kernels as a program: this one.
fn own_program() -> Option<Vec<OsString>> {
    let program = env::current_exe().ok()?;
    Some(vec![program.into(), "kernels".into()])
}
