//! Where the project is.

use crate::error::{Error, Result};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};

/// The workspace around the current directory, as a relative path: empty, `..`, `../..`.
///
/// # Errors
/// If no directory from here upward holds a `Cargo.toml` with a `[workspace]`.
pub fn root() -> Result<PathBuf> {
    let here = env::current_dir()
        .map_err(|error| Error::new(format!("cannot read the current directory: {error}")))?;
    let mut path = PathBuf::new();
    for directory in here.ancestors() {
        if is_workspace(directory) {
            return Ok(path);
        }
        path.push("..");
    }
    Err(Error::new(format!(
        "no workspace above {}: run this inside the project, or say where to write with --out",
        here.display()
    )))
}

fn is_workspace(directory: &Path) -> bool {
    fs::read_to_string(directory.join("Cargo.toml"))
        .is_ok_and(|text| text.lines().any(|line| line.trim() == "[workspace]"))
}
