//! `cargo xtask bench`: how fast every way to a picture is, against the lab's way and the machine.

mod counted;
mod frames;
mod hierarchy;
pub mod instructions;
mod lab_way;
mod limits;
mod lists;
mod machine;
mod operations;
pub mod result;
mod stage;
mod tables;
mod way;

pub use lists::Plan;
pub use result::Bench;

use crate::arguments::Format;
use crate::case::Case;
use crate::error::{Error, Result};
use crate::{output, progress};
use frames::{Chain, Frames};
use indicatif::ProgressBar;
use ombrage::{Level, Picture};
use result::{Hierarchy, Instructions, Row};
use serde::Serialize;
use stage::{Stage, truth};
use std::process::ExitCode;
use way::Contender;

/// Measure how fast every way to Figure 3(c) is, and how wrong its bytes are
///
/// All ways run in turns in one process, so that a machine that slows down slows all of them; a
/// time is the median, a ratio the median of the ratios of neighbouring times. What they are
/// measured against, lab-way, is the lab's program as its C++ engine is built: trait objects in a
/// map, nearest hits for shadow rays, one pixel at a time.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask bench                 everything, in about a minute
  cargo xtask bench --quick         a first look, in a few seconds
  cargo xtask bench --json          the same for machines, with all that the tables leave out
  cargo xtask bench --instructions  instructions a pixel, which no busy machine disturbs
  cargo xtask bench --frames 1000 --chain lab --level avx2     something for a profiler

Exit status: 0 measured, or there is no Valgrind to count with; 1 a picture is not what it must be,
or takes too many instructions; 2 bad input.

ns/pixel: median nanoseconds a pixel, from the scene to the bytes; x: times as fast as lab-way;
wrong: bytes that differ from the true picture, of which every byte is proven; limit: the share of
the machine's own limit that is reached. proven is the relative chain with a proof of every byte; a
line says how many times as long as the plain picture in f32 that takes.

Every picture is checked: each level, each number of threads and either question of the shadow rays
must give the scalar path's bytes, and lab-way those of the lab's chain but for one byte in 24,000
pixels, or in 32 where many spheres put an edge in most pixels. Close other programs first, since a
busy machine interrupts slow ways more often than fast ones: the load is printed with the machine.")]
pub struct Args {
    /// Take a first look: 600x400 only, few spheres, few rounds
    #[arg(long)]
    quick: bool,

    /// Print JSON
    #[arg(long)]
    json: bool,

    /// Count the instructions of Figure 3(c) at AVX2 with Valgrind, and hold them to their limits
    #[arg(long, conflicts_with = "quick")]
    instructions: bool,

    /// Only draw Figure 3(c) N times, for a profiler to look at
    #[arg(long, value_name = "N", conflicts_with_all = ["quick", "json", "instructions"])]
    frames: Option<u32>,

    /// Draw the frames with this chain
    #[arg(long, default_value = "relative", requires = "frames")]
    chain: Chain,

    /// Draw the frames in this format
    #[arg(long, default_value = "f32", requires = "frames")]
    float: Format,

    /// Draw the frames at this processor level: auto, scalar, sse2, sse4.2, avx2, avx512, neon
    #[arg(long, default_value = "auto", requires = "frames")]
    level: Level,
}

/// Runs the command.
///
/// # Errors
/// If the processor does not have the level, Valgrind fails, or standard output cannot be written
/// to.
pub fn run(args: &Args) -> Result<ExitCode> {
    if let Some(count) = args.frames {
        let (chain, format) = (args.chain, args.float);
        let frames = Frames {
            chain,
            format,
            count,
        };
        frames.draw(args.level)?;
        return Ok(ExitCode::SUCCESS);
    }
    if args.instructions {
        return count_instructions(args.json);
    }
    let plan = if args.quick {
        Plan::quick()
    } else {
        Plan::full()
    }?;
    let bar = progress::bar(0, true);
    let bench = measure(&plan, &bar)?;
    bar.finish_and_clear();
    let text = if args.json {
        json(&bench)?
    } else {
        tables::text(&bench)
    };
    output::print(&text)?;
    for complaint in &bench.wrong_pictures {
        eprintln!("{complaint}");
    }
    let is_well = bench.wrong_pictures.is_empty();
    Ok(ExitCode::from(u8::from(!is_well)))
}

fn json(what: &impl Serialize) -> Result<String> {
    let text = serde_json::to_string_pretty(what)
        .map_err(|error| Error::new(format!("cannot write the numbers as JSON: {error}")))?;
    Ok(text + "\n")
}

fn count_instructions(as_json: bool) -> Result<ExitCode> {
    let counted = match instructions::count()? {
        Ok(counted) => counted,
        Err(reason) => {
            eprintln!("no instructions counted: {reason}");
            vec![]
        }
    };
    let text = if as_json {
        json(&counted)?
    } else {
        tables::instructions(&counted)
    };
    output::print(&text)?;
    let is_too_many = |of: &Instructions| of.allowed.is_some_and(|allowed| of.per_pixel > allowed);
    Ok(ExitCode::from(u8::from(counted.iter().any(is_too_many))))
}

/// Measures everything in a plan; the bar learns how much there is to do, and how far it is.
///
/// # Errors
/// None: all scenes are valid, and all levels are the processor's own.
pub fn measure(plan: &Plan, bar: &ProgressBar) -> Result<Bench> {
    let pictures = plan.sizes.len() + plan.growing_sizes.len() + plan.spheres.len();
    bar.inc_length(2 * pictures as u64 + 1);
    let machine = machine::look();
    bar.set_message("the machine's limits");
    let (mut limits, mut operations) = (limits::measure::<f32>(), vec![]);
    let double = limits::measure::<f64>();
    if let Some(&size) = plan.sizes.first() {
        operations.extend(operations::count::<f32>(
            size,
            &operations::together_at(&limits),
        )?);
        operations.extend(operations::count::<f64>(
            size,
            &operations::together_at(&double),
        )?);
    }
    limits.extend(double);
    let stores: Vec<_> = plan.sizes.iter().map(|&size| limits::store(size)).collect();
    bar.inc(1);

    let mut bench = Bench {
        machine,
        rows: vec![],
        growth_with_pixels: vec![],
        growth_with_spheres: vec![],
        hierarchy: vec![],
        limits,
        stores,
        operations,
        wrong_pictures: vec![],
    };
    let mut race = Race {
        seconds: plan.seconds,
        bar,
        wrong_pictures: &mut bench.wrong_pictures,
    };
    for (place, &size) in plan.sizes.iter().enumerate() {
        let mut contenders = lists::levels();
        if place == 0 {
            contenders.extend(lists::variants());
        }
        let rows = race.run("3c", &lists::figure(size)?, &contenders)?;
        bench.rows.extend(rows);
    }
    for &size in &plan.growing_sizes {
        let rows = race.run("3c", &lists::figure(size)?, &lists::growth(false))?;
        bench.growth_with_pixels.extend(rows);
    }
    for &count in &plan.spheres {
        let rows = race.run("spheres", &lists::spheres(count)?, &lists::growth(true))?;
        bench.growth_with_spheres.extend(rows);
    }
    operations::judge(
        &mut bench.rows,
        &bench.limits,
        &bench.operations,
        &bench.stores,
    );
    bench.hierarchy = pays(&bench.growth_with_spheres);
    Ok(bench)
}

/// How contenders run against each other.
struct Race<'a> {
    seconds: f64,
    bar: &'a ProgressBar,
    wrong_pictures: &'a mut Vec<String>,
}

impl Race<'_> {
    /// Lets contenders run on a picture, in `f32` and in `f64`.
    fn run(
        &mut self,
        picture: &'static str,
        case: &Case,
        contenders: &[Contender],
    ) -> Result<Vec<Row>> {
        let (width, height) = (case.size.width(), case.size.height());
        let spheres = case.scene.spheres().len();
        self.bar
            .set_message(format!("{width}x{height}, spheres: {spheres}"));
        let truth = truth(case)?;
        let mut rows = self.run_in::<f32>(picture, case, &truth, contenders)?;
        rows.extend(self.run_in::<f64>(picture, case, &truth, contenders)?);
        Ok(rows)
    }

    fn run_in<F: hierarchy::InPackets>(
        &mut self,
        picture: &'static str,
        case: &Case,
        truth: &Picture,
        contenders: &[Contender],
    ) -> Result<Vec<Row>> {
        let stage = Stage::<F>::new(picture, case, truth)?;
        let rows = stage.run(contenders, self.seconds, self.wrong_pictures);
        self.bar.inc(1);
        rows
    }
}

/// From how many spheres on the tree is faster than the list, at every level it was measured at.
fn pays(rows: &[Row]) -> Vec<Hierarchy> {
    let mut levels = vec![Level::Scalar, Level::best()];
    levels.dedup();
    let mut found = vec![];
    for float in ["f32", "f64"] {
        for level in &levels {
            let times = |chain: &str| -> Vec<(usize, f64)> {
                let of = |row: &&Row| {
                    row.float == float
                        && row.level == level.name()
                        && row.chain == chain
                        && row.query.as_deref() == Some("any")
                };
                let rows = rows.iter().filter(of);
                rows.map(|row| (row.spheres, row.ns_per_pixel)).collect()
            };
            let (lists, trees) = (times("lab"), times("lab, hierarchy"));
            let pairs = lists.iter().zip(&trees).rev();
            let pays = pairs.take_while(|((_, list), (_, tree))| tree < list);
            found.push(Hierarchy {
                float: float.into(),
                level: level.name().into(),
                pays_from: pays.last().map(|((spheres, _), _)| *spheres),
            });
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombrage::Size;

    /// Rows of the tree and of the list, with these times, at 1, 4, 16 ... spheres.
    fn rows(times: &[(f64, f64)]) -> Vec<Row> {
        let row = |chain: &str, spheres: usize, ns_per_pixel: f64| Row {
            picture: "spheres".into(),
            spheres,
            width: Size::LAB.width(),
            height: Size::LAB.height(),
            float: "f32".into(),
            chain: chain.into(),
            shadow: "ulp-offset".into(),
            quality: Some("textbook".into()),
            query: Some("any".into()),
            level: "scalar".into(),
            threads: 1,
            ns_per_pixel,
            ratio_to_lab_way: 1.0,
            ratio_to_plain: None,
            wrong_bytes: 0,
            share_of_limit: None,
        };
        let pair = |(step, &(list, tree)): (u32, &(f64, f64))| {
            let spheres = 4usize.pow(step);
            [
                row("lab", spheres, list),
                row("lab, hierarchy", spheres, tree),
            ]
        };
        (0..).zip(times).flat_map(pair).collect()
    }

    fn pays_from(times: &[(f64, f64)]) -> Option<usize> {
        pays(&rows(times))[0].pays_from
    }

    #[test]
    fn a_hierarchy_pays_from_where_it_stays_faster() {
        assert_eq!(
            pays_from(&[(1.0, 2.0), (2.0, 2.5), (8.0, 3.0), (32.0, 4.0)]),
            Some(16)
        );
        assert_eq!(pays_from(&[(2.0, 1.0), (2.0, 2.5), (8.0, 3.0)]), Some(16));
        assert_eq!(pays_from(&[(2.0, 1.0), (8.0, 2.5)]), Some(1));
        assert_eq!(pays_from(&[(1.0, 2.0), (2.0, 3.0)]), None);
    }
}
