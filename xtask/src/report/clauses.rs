//! The clauses of docs/spec.md, each with its item, its test and its figure.

use crate::error::{Error, Result};
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::Path;

/// A clause.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Clause {
    /// Its id: `1.1` ... `5.2`, `E.1` ... `E.8`.
    pub id: String,
    /// What it asks for.
    pub title: String,
    /// The items that implement it.
    pub item: String,
    /// The module of `tests/spec.rs` that holds it.
    pub test: String,
    /// The figures that show it.
    pub figure: String,
}

/// Reads the clauses.
///
/// # Errors
/// If the file cannot be read, or a clause has no item, test or figure.
pub fn read(path: &Path) -> Result<Vec<Clause>> {
    let text = fs::read_to_string(path)
        .map_err(|error| Error::new(format!("cannot read {}: {error}", path.display())))?;
    let clauses = text.split("\n### ").skip(1);
    let parse = |section: &str| {
        let (head, body) = section.split_once('\n').unwrap_or((section, ""));
        let (id, title) = head.split_once(' ').unwrap_or((head, ""));
        let field = |name: &str| {
            let lines = body.lines();
            let value = lines
                .filter_map(|line| line.strip_prefix("- ")?.strip_prefix(name))
                .next();
            let value = value.and_then(|value| value.strip_prefix(": "));
            value
                .map(|value| value.replace('`', ""))
                .ok_or_else(|| Error::new(format!("{}: clause {id} has no {name}", path.display())))
        };
        Ok(Clause {
            id: id.into(),
            title: title.into(),
            item: field("Item")?,
            test: field("Test")?,
            figure: field("Figure")?,
        })
    };
    clauses.map(parse).collect()
}
