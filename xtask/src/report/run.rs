//! How the report was measured.

use chrono::DateTime;
use serde::{Deserialize, Serialize};
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

/// The day, the command and the versions; the machine is in the data of the bench.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Run {
    /// The day and minute it began, in UTC.
    pub date: String,
    /// The command.
    pub command: String,
    /// How many seconds it took.
    pub seconds: u64,
    /// Whether it was a quick run: fewer scenes, smaller pictures.
    pub quick: bool,
    /// The version of the kit.
    pub version: String,
    /// The version of the compiler.
    pub compiler: String,
}

impl Run {
    /// A run that begins now.
    pub fn begin(quick: bool) -> Self {
        let command = if quick {
            "cargo xtask report --quick"
        } else {
            "cargo xtask report"
        };
        Self {
            date: now(),
            command: command.into(),
            seconds: 0,
            quick,
            version: env!("CARGO_PKG_VERSION").into(),
            compiler: compiler(),
        }
    }
}

fn now() -> String {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    let seconds = since.map_or(0, |since| since.as_secs() as i64);
    let date = DateTime::from_timestamp(seconds, 0).unwrap_or_default();
    date.format("%Y-%m-%d %H:%M").to_string()
}

fn compiler() -> String {
    let output = Command::new("rustc").arg("--version").output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    text.ok()
        .filter(|text| !text.is_empty())
        .unwrap_or_else(|| "unknown".into())
}
