//! The text of a scene file, and the lines of places in it.

use super::at;
use crate::error::{Error, Result};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::DeTable;

/// The largest file that is read: 128 MiB, room for two million spheres.
const MOST_BYTES: u64 = 128 << 20;

/// Reads all bytes of a file.
///
/// # Errors
/// If it cannot be read or is too large.
pub fn read(path: &Path) -> Result<Vec<u8>> {
    let cannot = |error: io::Error| {
        let advice = "give a scene file, such as tests/scenes/base.toml";
        Error::new(format!("cannot read {}: {error}; {advice}", path.display()))
    };
    let file = File::open(path).map_err(cannot)?;
    let mut bytes = vec![];
    let length = file.take(MOST_BYTES + 1).read_to_end(&mut bytes);
    if length.map_err(cannot)? as u64 > MOST_BYTES {
        return Err(Error::new(format!(
            "{} has more than 128 MiB: write a smaller scene",
            path.display()
        )));
    }
    Ok(bytes)
}

/// The text of a file, and the path that messages about it name.
pub struct Source {
    path: PathBuf,
    text: String,
}

impl Source {
    /// Takes the bytes of a file.
    ///
    /// # Errors
    /// If they are not UTF-8.
    pub fn new(path: &Path, bytes: Vec<u8>) -> Result<Self> {
        let text = String::from_utf8(bytes).map_err(|error| {
            let place = error.utf8_error().valid_up_to();
            let what = "the text is not UTF-8: save the file as UTF-8";
            at(path, line_of(error.as_bytes(), place), what)
        })?;
        Ok(Self {
            path: path.to_path_buf(),
            text,
        })
    }

    /// The text as TOML.
    ///
    /// # Errors
    /// If it is not; a key that is there twice is such an error.
    pub fn parse(&self) -> Result<Spanned<DeTable<'_>>> {
        DeTable::parse(&self.text).map_err(|error| {
            let place = error.span().map_or(0, |span| span.start);
            let rest = self.text.get(place..).unwrap_or_default();
            let found: String = rest.chars().take_while(|&c| c != '\n').collect();
            let found: String = found.trim().chars().take(40).collect();
            let what = format!(
                "{} at {found:?}: write TOML, see docs/scenes.md",
                error.message()
            );
            self.error(place, &what)
        })
    }

    /// A message about the text at this byte.
    pub fn error(&self, place: usize, what: &str) -> Error {
        at(&self.path, line_of(self.text.as_bytes(), place), what)
    }
}

/// The number of the line with this byte, from 1.
fn line_of(text: &[u8], place: usize) -> usize {
    let before = &text[..place.min(text.len())];
    1 + before.iter().filter(|&&byte| byte == b'\n').count()
}
