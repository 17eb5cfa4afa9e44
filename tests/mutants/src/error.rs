//! Why the tool cannot do what it was asked.

use std::path::Path;
use std::{fmt, io};

/// One line that says what to do. It ends the tool with exit status 2.
#[derive(Debug)]
pub struct Error(String);

/// What the parts of the tool return.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// An error with this message; line breaks become spaces.
    pub fn new(message: impl Into<String>) -> Self {
        let message: String = message.into();
        let lines: Vec<&str> = message.lines().map(str::trim).collect();
        Self(lines.join(" "))
    }

    /// Something that cannot be done with a file or directory of the tool.
    pub fn at(path: &Path, error: &io::Error) -> Self {
        let path = path.display();
        Self::new(format!(
            "cannot read or write {path}: {error}; remove it, or make room"
        ))
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl From<clap::Error> for Error {
    /// Keeps what is wrong and the hint, and drops the usage, which `--help` shows.
    fn from(error: clap::Error) -> Self {
        let text = error.render().to_string();
        let lines: Vec<&str> = text
            .lines()
            .map(str::trim)
            .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"))
            .filter(|line| !line.is_empty())
            .collect();
        let line = lines.join("; ").replace(":; ", ": ");
        Self::new(format!(
            "{}; see --help",
            line.trim_start_matches("error: ")
        ))
    }
}
