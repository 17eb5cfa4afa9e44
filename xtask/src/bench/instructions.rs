//! How many instructions a pixel takes: a measure that no busy machine disturbs.
//!
//! Valgrind runs this program twice, to draw Figure 3(c) a few times and a few times more; the
//! difference is what the pictures take. It knows no AVX-512, so the level is AVX2.

use super::frames::{Chain, Frames};
use super::result::Instructions;
use crate::arguments::Format;
use crate::error::{Error, Result};
use crate::parallel;
use ombrage::{Level, Size};
use std::env;
use std::process::Command;

/// How many pictures are drawn in the two runs.
const FRAMES: [u32; 2] = [1, 4];

/// What is counted, and how many instructions a pixel it may take: the default chain is held to a
/// number, the lab's is not.
const COUNTED: [(Chain, Format, Option<f64>); 4] = [
    (Chain::Relative, Format::F32, Some(31.0)),
    (Chain::Relative, Format::F64, Some(66.0)),
    (Chain::Lab, Format::F32, None),
    (Chain::Lab, Format::F64, None),
];

/// Counts, or says why nothing can be counted here.
///
/// # Errors
/// If Valgrind fails.
pub fn count() -> Result<std::result::Result<Vec<Instructions>, &'static str>> {
    if cfg!(debug_assertions) {
        return Ok(Err("this build has no optimisations"));
    }
    if !Level::Avx2.is_available() {
        return Ok(Err("this processor has no AVX2"));
    }
    if Command::new("valgrind").arg("--version").output().is_err() {
        return Ok(Err("there is no valgrind"));
    }
    let counted = parallel::map(&COUNTED, |&(chain, format, allowed)| {
        let run = |count| {
            in_valgrind(&Frames {
                chain,
                format,
                count,
            })
        };
        let instructions = run(FRAMES[1])?.saturating_sub(run(FRAMES[0])?);
        let pixels = Size::LAB.pixels() as u64 * u64::from(FRAMES[1] - FRAMES[0]);
        Ok(Instructions {
            chain: chain.name().into(),
            float: format.name().into(),
            level: Level::Avx2.name().into(),
            per_pixel: instructions as f64 / pixels as f64,
            allowed,
        })
    })?;
    Ok(Ok(counted))
}

/// The instructions of this program as it draws some pictures.
fn in_valgrind(frames: &Frames) -> Result<u64> {
    let failed = |why: String| Error::new(format!("cannot count instructions: {why}"));
    let program = env::current_exe().map_err(|error| failed(error.to_string()))?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(frames.arguments(Level::Avx2))
        .output()
        .map_err(|error| failed(format!("{error}; is valgrind in the path?")))?;
    let report = String::from_utf8_lossy(&output.stderr);
    let instructions = collected(&report).filter(|_| output.status.success());
    instructions.ok_or_else(|| {
        let last = report.lines().last().unwrap_or("nothing");
        failed(format!(
            "valgrind says {last:?}; run it yourself to see more"
        ))
    })
}

/// The number in the line `==1== Collected : 42`.
fn collected(report: &str) -> Option<u64> {
    let line = report.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(':').next()?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::collected;

    #[test]
    fn reads_what_valgrind_reports() {
        let report = "==7== Events    : Ir\n==7== Collected : 123456\n==7== \n";
        assert_eq!(collected(report), Some(123_456));
        assert_eq!(collected("==7== Collected : many"), None);
        assert_eq!(collected("Illegal instruction"), None);
    }
}
