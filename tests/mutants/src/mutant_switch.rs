//! The switch in front of each mutant: this file becomes a module of the crates that are tested.
//!
//! One program has all mutants. A variable of the environment says which of them is on, so that child
//! processes have it too; another one names a file to which is written which of them are reached.

use std::env;
use std::fs::OpenOptions;
use std::io::Write;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};

/// The variable with the number of the mutant that is on.
pub const ON: &str = "MUTANT_ON";

/// The variable with the file that the numbers of reached mutants are added to, 4 bytes each, the lowest
/// byte first.
pub const REACHED: &str = "MUTANTS_REACHED";

/// How many mutants one program can have.
pub const MOST: usize = 1 << 14;

const UNREAD: u32 = u32::MAX;
const RECORDING: u32 = u32::MAX - 1;
const NONE: u32 = u32::MAX - 2;

static STATE: AtomicU32 = AtomicU32::new(UNREAD);
static SEEN: [AtomicBool; MOST] = [const { AtomicBool::new(false) }; MOST];

/// Whether this mutant is on. A load and a comparison, because kernels ask it in their innermost loops.
#[inline(always)]
pub fn is_on(mutant: u32) -> bool {
    let state = STATE.load(Relaxed);
    if state < RECORDING {
        state == mutant
    } else {
        first(mutant)
    }
}

/// The answer where the environment is not read yet, or reached mutants are recorded.
#[cold]
#[inline(never)]
fn first(mutant: u32) -> bool {
    if STATE.load(Relaxed) == UNREAD {
        let on = env::var(ON).ok().and_then(|number| number.parse().ok());
        let idle = if env::var_os(REACHED).is_some() {
            RECORDING
        } else {
            NONE
        };
        STATE.store(on.unwrap_or(idle), Relaxed);
        return is_on(mutant);
    }
    if let Some(seen) = SEEN.get(mutant as usize)
        && !seen.load(Relaxed)
        && !seen.swap(true, Relaxed)
    {
        record(mutant);
    }
    false
}

/// Adds a number to the file. A test must not fail because it cannot be written: what is not recorded
/// counts as not reached, and is reported as not noticed.
fn record(mutant: u32) {
    if let Some(path) = env::var_os(REACHED)
        && let Ok(mut file) = OpenOptions::new().append(true).open(path)
    {
        drop(file.write_all(&mutant.to_le_bytes()));
    }
}
