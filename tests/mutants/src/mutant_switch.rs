//! The switch in front of each mutant: this file becomes a module of the crates that are tested.
//!
//! One program has all mutants. A variable of the environment says which of them is on, so that child
//! processes have it too; another one names a file to which is written which of them are reached.

use std::env;
use std::fs::OpenOptions;
use std::io::Write;
use std::sync::atomic::{AtomicU8, Ordering::Relaxed};

/// The variable with the number of the mutant that is on.
pub const ON: &str = "MUTANT_ON";

/// The variable with the file that the numbers of reached mutants are added to, 4 bytes each, the lowest
/// byte first.
pub const REACHED: &str = "MUTANTS_REACHED";

/// How many mutants one program can have.
pub const MOST: usize = 1 << 14;

const UNASKED: u8 = 0;
const IS_OFF: u8 = 1;
const IS_ON: u8 = 2;

static STATES: [AtomicU8; MOST] = [const { AtomicU8::new(UNASKED) }; MOST];

/// Whether this mutant is on. A load and a comparison, because kernels ask it in their innermost loops.
#[inline(always)]
pub fn is_on(mutant: u32) -> bool {
    match STATES[mutant as usize].load(Relaxed) {
        IS_OFF => false,
        IS_ON => true,
        _ => first(mutant),
    }
}

/// The answer where it is asked for the first time: the mutant is reached.
#[cold]
#[inline(never)]
fn first(mutant: u32) -> bool {
    let is_on = env::var(ON).is_ok_and(|number| number.parse() == Ok(mutant));
    let state = if is_on { IS_ON } else { IS_OFF };
    if STATES[mutant as usize].swap(state, Relaxed) == UNASKED {
        record(mutant);
    }
    is_on
}

/// Adds a number to the file, if there is one. A test must not fail because it cannot be written: what is
/// not recorded counts as not reached, and is reported as not noticed.
fn record(mutant: u32) {
    if let Some(path) = env::var_os(REACHED)
        && let Ok(mut file) = OpenOptions::new().append(true).open(path)
    {
        drop(file.write_all(&mutant.to_le_bytes()));
    }
}
