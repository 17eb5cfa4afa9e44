//! Why a command cannot do what it was asked.

use ombrage::{Invalid, NoSuchLevel};
use std::fmt;

/// One line that names the value and says what to do instead. It ends a command with exit status 2.
#[derive(Debug)]
pub struct Error(String);

/// What commands and their parts return.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// An error with this message; line breaks become spaces.
    pub fn new(message: impl Into<String>) -> Self {
        let message: String = message.into();
        let lines: Vec<&str> = message.lines().map(str::trim).collect();
        Self(lines.join(" "))
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl From<Invalid> for Error {
    fn from(invalid: Invalid) -> Self {
        Self::new(invalid.to_string())
    }
}

impl From<NoSuchLevel> for Error {
    fn from(error: NoSuchLevel) -> Self {
        Self::new(error.to_string())
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
        Self::new(format!(
            "{}; see --help",
            lines
                .join("; ")
                .replace(":; ", ": ")
                .trim_start_matches("error: ")
        ))
    }
}
