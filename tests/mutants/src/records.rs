//! Files of one JSON value a line, which a run adds to and the next one reads.

use crate::error::{Error, Result};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// A file that lines are added to, from any thread.
#[derive(Debug)]
pub struct Records {
    path: std::path::PathBuf,
    file: Mutex<File>,
}

impl Records {
    /// Opens a file, or makes it.
    ///
    /// # Errors
    /// If it cannot be opened.
    pub fn open(path: &Path) -> Result<Self> {
        let file = OpenOptions::new().append(true).create(true).open(path);
        let file = file.map_err(|error| Error::at(path, &error))?;
        Ok(Self {
            path: path.to_path_buf(),
            file: Mutex::new(file),
        })
    }

    /// Adds a line, whole or not at all as far as the system can.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn add(&self, value: &impl Serialize) -> Result<()> {
        let mut line = serde_json::to_string(value).unwrap_or_default();
        line.push('\n');
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.write_all(line.as_bytes())
            .map_err(|error| Error::at(&self.path, &error))
    }
}

/// The lines of a file that are such values; what a killed run has left half written is none.
pub fn read<T: DeserializeOwned>(path: &Path) -> Vec<T> {
    let text = fs::read_to_string(path).unwrap_or_default();
    text.lines()
        .filter_map(|line| serde_json::from_str(line).ok())
        .collect()
}
