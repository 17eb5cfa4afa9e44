//! Finding the mutants that compile: those that do not are taken out until the rest does.

use crate::blame::Blame;
use crate::error::{Error, Result};
use crate::mutant::{Mutant, PACKAGES};
use crate::project::Project;
use crate::rewrite::{Switched, rewrite};
use crate::tree::Tree;
use std::collections::{BTreeMap, BTreeSet};
use std::process::Stdio;

/// How often the compiler is asked: errors of one kind hide those of the next, and there are few kinds.
const MOST_ROUNDS: usize = 40;

/// Mutants that are not tried.
#[derive(Debug, Default, Clone)]
pub struct Out {
    /// They do not compile.
    pub unviable: BTreeSet<usize>,
    /// They may compile, but not behind a switch.
    pub unswitched: BTreeSet<usize>,
}

impl Out {
    /// Whether a mutant is out.
    pub fn has(&self, mutant: usize) -> bool {
        self.unviable.contains(&mutant) || self.unswitched.contains(&mutant)
    }
}

/// Writes the files with all switches that compile. `out` has what is known not to, and gets the rest.
///
/// # Errors
/// If the project does not compile whatever is taken out.
pub fn settle(
    project: &Project,
    tree: &Tree,
    mutants: &[Mutant],
    out: &mut Out,
) -> Result<BTreeMap<String, Switched>> {
    for _ in 0..MOST_ROUNDS {
        let files = switched(project, mutants, out)?;
        tree.write(&files)?;
        let blame = check(tree, &files)?;
        let Some(blame) = blame else {
            return Ok(files);
        };
        let Blame {
            unviable,
            unswitchable,
            others,
        } = blame;
        if unviable.is_empty() && unswitchable.is_empty() {
            let what = others.first().map_or("no reason given", String::as_str);
            return Err(Error::new(format!(
                "the copy of the project does not compile: {what}; does cargo check --workspace?"
            )));
        }
        eprintln!(
            "{} mutants do not compile, {} not behind a switch; without them:",
            unviable.len(),
            unswitchable.len()
        );
        out.unviable.extend(unviable);
        out.unswitched.extend(unswitchable);
    }
    Err(Error::new(format!(
        "the copy of the project still does not compile after {MOST_ROUNDS} rounds: name fewer files"
    )))
}

/// The files with switches for all mutants that are not out.
fn switched(
    project: &Project,
    mutants: &[Mutant],
    out: &mut Out,
) -> Result<BTreeMap<String, Switched>> {
    let mut numbers: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (number, mutant) in mutants.iter().enumerate() {
        if !out.has(number) {
            numbers.entry(&mutant.file).or_default().push(number);
        }
    }
    let mut files = BTreeMap::new();
    for (file, numbers) in numbers {
        // A program asks the switches of its library under another name.
        if file.ends_with("src/main.rs") {
            out.unswitched.extend(numbers);
            continue;
        }
        let made = rewrite(project.text(file)?, mutants, &numbers).map_err(|error| {
            Error::new(format!("cannot read {file}: {error}; does it compile?"))
        })?;
        out.unswitched.extend(&made.without);
        files.insert(file.to_owned(), made);
    }
    Ok(files)
}

/// Compiles the packages that have switches; what is wrong with the first that does not compile.
fn check(tree: &Tree, files: &BTreeMap<String, Switched>) -> Result<Option<Blame>> {
    for (package, folder) in PACKAGES {
        if !files.keys().any(|file| file.starts_with(folder)) {
            continue;
        }
        eprintln!("compiling {package} with switches");
        let what = [
            "check",
            "--quiet",
            "--lib",
            "--all-features",
            "--package",
            package,
        ];
        let mut cargo = tree.cargo(&what);
        cargo.arg("--message-format=json");
        cargo.stdin(Stdio::null()).stderr(Stdio::null());
        let output = cargo
            .output()
            .map_err(|error| Error::new(format!("cannot start cargo: {error}; install Rust")))?;
        if !output.status.success() {
            let printed = String::from_utf8_lossy(&output.stdout);
            return Ok(Some(Blame::of(&printed, files)));
        }
    }
    Ok(None)
}
