//! Mutants: what cargo-mutants says can be changed in the code.

use crate::error::{Error, Result};
use crate::project::{Project, output};
use serde::Deserialize;
use std::process::Command;

/// The packages that can be tested, with the folder of their sources.
pub const PACKAGES: [(&str, &str); 2] = [("ombrage", "src/"), ("xtask", "xtask/src/")];

/// A change of one place in the code, as `cargo mutants --list --json` prints it.
#[derive(Debug, Clone, Deserialize)]
pub struct Mutant {
    /// The file, from the root of the project.
    pub file: String,
    /// Its package.
    pub package: String,
    /// The place and the change in words: the mutant's name for people, and in earlier outcomes.
    pub name: String,
    /// What kind of change it is.
    pub genre: Genre,
    /// What is replaced.
    pub span: Span,
    /// What it is replaced with; empty if it is deleted.
    pub replacement: String,
    /// The function around it.
    pub function: Option<Function>,
}

/// Kinds of changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum Genre {
    /// A function returns a value at once.
    FnValue,
    /// Another operator between two operands.
    BinaryOperator,
    /// An operator before an operand is deleted.
    UnaryOperator,
    /// An arm of a match is deleted.
    MatchArm,
    /// The guard of an arm is `true` or `false`.
    MatchArmGuard,
    /// A field of a struct is taken from the base.
    StructField,
    /// One that a newer cargo-mutants knows.
    #[serde(other)]
    Other,
}

/// From the start to before the end.
#[derive(Debug, Clone, Copy, Deserialize)]
pub struct Span {
    /// Where it starts.
    pub start: Place,
    /// Where it ends.
    pub end: Place,
}

/// A line and a column, in characters, both from 1.
#[derive(Debug, Clone, Copy, Deserialize)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
}

/// What is told of a function.
#[derive(Debug, Clone, Deserialize)]
pub struct Function {
    /// Its return type as written, with the arrow; empty if it has none.
    pub return_type: String,
}

impl Mutant {
    /// Whether it changes the value of a function that returns an `impl Trait`: a `return` of another
    /// type in front of the body does not compile, though the change alone would.
    pub fn returns_opaque(&self) -> bool {
        let function = self.function.as_ref();
        self.genre == Genre::FnValue && function.is_some_and(|f| f.return_type.contains("impl "))
    }
}

/// The mutants of files whose path begins with one of `paths`, without those that
/// `.cargo/mutants.toml` excludes.
///
/// # Errors
/// If cargo-mutants does not list them, or a path has none.
pub fn list(project: &Project, paths: &[String]) -> Result<Vec<Mutant>> {
    let mut command = Command::new("cargo");
    command.args(["mutants", "--list", "--json"]);
    command.args(["--config", ".cargo/mutants.toml"]);
    for (package, _) in PACKAGES {
        command.args(["--package", package]);
    }
    command.current_dir(project.root());
    let json = output(&mut command, "cargo install cargo-mutants")?;
    let all: Vec<Mutant> = serde_json::from_slice(&json).map_err(|error| {
        Error::new(format!(
            "cannot read what cargo mutants lists: {error}; use cargo-mutants 27"
        ))
    })?;
    for path in paths {
        if !all
            .iter()
            .any(|mutant| mutant.file.starts_with(path.as_str()))
        {
            let folders = PACKAGES.map(|(_, folder)| folder).join(" or ");
            return Err(Error::new(format!(
                "'{path}' has no mutant: name a file or folder in {folders}, from the project's root"
            )));
        }
    }
    let is_named = |mutant: &Mutant| {
        paths
            .iter()
            .any(|path| mutant.file.starts_with(path.as_str()))
    };
    Ok(all.into_iter().filter(is_named).collect())
}
