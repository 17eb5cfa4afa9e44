//! Runs all experiments.

use super::clauses;
use super::data::{Data, Figure, Known, Quantise, VERSION};
use super::height;
use super::proofs;
use super::run::Run;
use super::stages::Stages;
use crate::bench::{self, Plan};
use crate::case::{self, Case};
use crate::compare::{self, moved};
use crate::error::{Error, Result};
use crate::figures::Drawn;
use crate::precision::measure;
use crate::shadows;
use ombrage::conformance::KNOWN_FAILURES;
use ombrage::{FIGURES, Film, Picture, Quality, Scalar};
use std::path::Path;
use std::time::Instant;

/// How wide the pictures of a quick run are at most.
const QUICK_WIDTH: u32 = 120;

/// How many milliseconds each experiment takes on two cores: the bench, the strategies, the
/// constant offsets, the times of shadow rays, f32 against f64, and the rest.
const FULL: [u64; 6] = [75_000, 11_000, 12_000, 2000, 19_000, 2000];
/// The same of a quick run.
const QUICK: [u64; 6] = [8000, 1500, 2000, 500, 5000, 2000];

/// Measures everything.
///
/// # Errors
/// If the scenes, the vectors or the specification cannot be read.
pub fn all(root: &Path, quick: bool, drawn: &[Drawn]) -> Result<Data> {
    let start = Instant::now();
    let mut run = Run::begin(quick);
    let scenes = scenes(quick)?;
    let figures: Vec<String> = FIGURES.map(|figure| figure.name.into()).to_vec();
    let pictures = compare::subjects(if quick { &figures } else { &[] })?;
    let plan = if quick { Plan::quick() } else { Plan::full() }?;
    let quality = Quality::Textbook;

    let expected = if quick { QUICK } else { FULL };
    let stages = Stages::new(expected.iter().sum());
    let [
        of_bench,
        of_shadows,
        of_offsets,
        of_times,
        of_compare,
        of_rest,
    ] = expected;
    let bench = stages.run("bench:", of_bench, |bar| bench::measure(&plan, bar))?;
    let shadows = stages.run("strategies:", of_shadows, |bar| {
        bar.set_length(2 * scenes.len() as u64);
        shadows::judge(&scenes, quality, bar)
    })?;
    let offsets = stages.run("offsets:", of_offsets, |bar| {
        bar.set_length(2 * scenes.len() as u64);
        shadows::offsets(&scenes, quality, bar)
    })?;
    let is_timed = |case: &&Case| shadows::TIMED.contains(&case.name.as_str());
    let times = stages.run("shadow rays:", of_times, |bar| {
        shadows::times(scenes.iter().filter(is_timed), quality, bar)
    })?;
    let compare = stages.run("f32 and f64:", of_compare, |bar| {
        bar.set_length(pictures.len() as u64);
        compare::measure(&pictures, bar)
    })?;
    let (proofs, moved, heights, kernels) = stages.run("proofs and kernels", of_rest, |_| {
        let proofs = proofs::measure(&scenes)?;
        let moved = moved::measure()?;
        let heights = height::measure()?;
        let errors = measure::errors().map_err(Error::new)?;
        let families = measure::families().map_err(Error::new)?;
        Ok::<_, Error>((proofs, moved, heights, (errors, families, measure::costs())))
    })?;
    stages.finish();
    let (errors, families, costs) = kernels;
    run.seconds = start.elapsed().as_secs();
    Ok(Data {
        version: VERSION,
        run,
        figures: drawn.iter().map(figure).collect(),
        shadows,
        times,
        offsets,
        heights,
        compare,
        moved,
        proofs,
        errors,
        families,
        costs,
        known_failures: known_failures(),
        quantise: quantise(),
        bench,
        clauses: clauses::read(&root.join("docs").join("spec.md"))?,
    })
}

fn scenes(quick: bool) -> Result<Vec<Case>> {
    let cases = case::load(&[])?;
    if !quick {
        return Ok(cases);
    }
    cases.iter().map(|case| case.at_most(QUICK_WIDTH)).collect()
}

/// What is recorded of a figure.
pub fn figure(drawn: &Drawn) -> Figure {
    let (figure, counts, size) = (drawn.figure, drawn.counts, drawn.picture.size());
    Figure {
        name: figure.name.into(),
        title: figure.title.into(),
        size: [size.width(), size.height()],
        sphere: counts.sphere,
        plane: counts.plane,
        lit_sphere: counts.lit_sphere,
        lit_plane: counts.lit_plane,
        acne_sphere: counts.acne_sphere,
        acne_plane: counts.acne_plane,
        shadowed: counts.shadowed,
        too_bright: counts.wrapped,
        largest_level: counts.largest_level,
        picture: checksum(&drawn.picture),
        sheet: drawn.sheet.as_ref().map(checksum),
    }
}

fn checksum(picture: &Picture) -> u32 {
    crc32fast::hash(picture.bytes())
}

fn known_failures() -> Vec<Known> {
    let owned = |names: &[&str]| names.iter().map(ToString::to_string).collect();
    let known = KNOWN_FAILURES.iter().map(|known| Known {
        kernel: known.kernel.name().into(),
        qualities: known.qualities.iter().map(|q| q.name().into()).collect(),
        floats: owned(known.floats),
        families: owned(known.families),
        reason: known.reason.into(),
    });
    known.collect()
}

/// Develops the values k/255, which ought to become the bytes k where the quotient is not below.
pub fn quantise() -> Quantise {
    let plain = |x: f64| (x * 255.0) as u8;
    let plain_single = |x: f32| (x * 255.0) as u8;
    let kit = wrong_by_kit::<f32>() + wrong_by_kit::<f64>();
    let wrong = |differs: &dyn Fn(u8) -> bool| (0..=255u8).filter(|&k| differs(k)).count();
    Quantise {
        f32: wrong(&|k| {
            plain_single(f32::from(k) / 255.0) != exact(f64::from(f32::from(k) / 255.0))
        }),
        f64: wrong(&|k| plain(f64::from(k) / 255.0) != exact(f64::from(k) / 255.0)),
        kit,
    }
}

/// The byte of the exact product 255 x, by whole numbers: x = m 2^e, and 255 m has 61 bits.
fn exact(x: f64) -> u8 {
    let bits = x.to_bits();
    let exponent = (bits >> 52) as i32;
    if exponent == 0 {
        return 0;
    }
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    let product = u128::from(mantissa) * 255;
    let shift = 1075 - exponent;
    if shift >= 128 {
        0
    } else {
        (product >> shift) as u8
    }
}

fn wrong_by_kit<S: Scalar>() -> usize {
    let differs = |k: &u8| {
        let x = S::from_f64(f64::from(*k)) / S::from_f64(255.0);
        Film::Clamp.byte::<S>(x).to_f64() as u8 != exact(x.to_f64())
    };
    (0..=255u8).filter(differs).count()
}
