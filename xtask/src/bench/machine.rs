//! The machine that is measured.

use super::result::Machine;
use ombrage::Level;
use std::env::consts::{ARCH, OS};
use std::fs;
use std::num::NonZero;
use std::thread;

/// Looks at it, and at how busy it is.
pub fn look() -> Machine {
    Machine {
        processor: processor().unwrap_or_else(|| ARCH.into()),
        architecture: ARCH.into(),
        system: OS.into(),
        cores: thread::available_parallelism().map_or(1, NonZero::get),
        levels: Level::available()
            .map(|level| level.name().into())
            .collect(),
        load: load(),
        optimised: !cfg!(debug_assertions),
    }
}

/// The processor's name, as Linux tells it.
fn processor() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().into())
}

/// The load over the last minute, as Linux tells it.
fn load() -> Option<f64> {
    let text = fs::read_to_string("/proc/loadavg").ok()?;
    text.split_whitespace().next()?.parse().ok()
}
