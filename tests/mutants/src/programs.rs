//! The test programs of the copy, and the tests in them.

use crate::blame::Blame;
use crate::error::{Error, Result};
use crate::mutant::Mutant;
use crate::project::output;
use crate::tree::Tree;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Test programs that do not judge the library, with the reason.
const NO_JUDGES: [(&str, &str); 5] = [
    ("report_browser", "looks at a page in a browser, slowly"),
    ("killed", "kills commands at random moments"),
    ("bench", "measures time, which switches change"),
    ("digests", "computes everything, as faster tests do"),
    ("report", "draws a page of what other tests measure too"),
];

/// The package that the kernels are judged by: it has none of their code.
const TRUTH: &str = "oracle";

/// A test, and how it is run.
#[derive(Debug, Clone)]
pub struct Test {
    /// The name of its program.
    pub program: String,
    /// Its name in the program.
    pub name: String,
    /// The program.
    pub executable: PathBuf,
    /// The folder of its package, in which cargo runs it.
    pub folder: PathBuf,
}

impl Test {
    /// Its name among all tests.
    pub fn id(&self) -> String {
        format!("{} {}", self.program, self.name)
    }
}

/// What cargo prints about something that it built.
#[derive(Deserialize)]
struct Artifact {
    manifest_path: PathBuf,
    target: Target,
    profile: Profile,
    executable: Option<PathBuf>,
}

#[derive(Deserialize)]
struct Target {
    name: String,
}

#[derive(Deserialize)]
struct Profile {
    test: bool,
}

/// Builds the test programs of a package, or of all, and lists the tests that can judge these mutants.
///
/// # Errors
/// If they cannot be built, or one lists no tests.
pub fn build(tree: &Tree, mutants: &[Mutant], package: Option<&str>) -> Result<Vec<Test>> {
    eprintln!("building the tests with switches, which takes minutes");
    let mut cargo = tree.cargo(&["test", "--no-run", "--message-format=json"]);
    match package {
        Some(package) => cargo.args(["--all-features", "--package", package]),
        None => cargo.arg("--workspace"),
    };
    let built = cargo.stdin(Stdio::null()).stderr(Stdio::inherit()).output();
    let built = built.map_err(|error| no_build(&error.to_string()))?;
    let printed = String::from_utf8_lossy(&built.stdout);
    if !built.status.success() {
        // The errors are in the JSON; the warnings too, about the parentheses of switches.
        let errors = Blame::of(&printed, &BTreeMap::new()).others;
        return Err(no_build(errors.first().map_or("see above", String::as_str)));
    }
    let artifacts = printed
        .lines()
        .filter_map(|line| serde_json::from_str(line).ok());
    let mut tests = vec![];
    for artifact in artifacts.filter(|artifact| judges(artifact, mutants)) {
        tests.extend(tests_of(artifact)?);
    }
    Ok(tests)
}

fn no_build(why: &str) -> Error {
    Error::new(format!(
        "the tests do not build with switches: {why}; if they do without, \
         name fewer files, which take less memory"
    ))
}

/// Whether it is a test program that can notice one of the mutants.
fn judges(artifact: &Artifact, mutants: &[Mutant]) -> bool {
    let only_library = mutants.iter().all(|mutant| mutant.package == "ombrage");
    let name = artifact.target.name.as_str();
    let is_skipped = only_library && NO_JUDGES.iter().any(|(skipped, _)| *skipped == name);
    let package = artifact.manifest_path.parent().and_then(Path::file_name);
    artifact.profile.test && !is_skipped && package.is_none_or(|package| package != TRUTH)
}

fn tests_of(artifact: Artifact) -> Result<Vec<Test>> {
    let Some(executable) = artifact.executable else {
        return Ok(vec![]);
    };
    let folder = artifact.manifest_path.parent().unwrap_or(Path::new("."));
    let mut list = Command::new(&executable);
    list.args(["--list", "--format", "terse"])
        .current_dir(folder);
    let printed = output(&mut list, "can its test program be run by hand?")?;
    let printed = String::from_utf8_lossy(&printed);
    let names = printed
        .lines()
        .filter_map(|line| line.strip_suffix(": test"));
    let test = |name: &str| Test {
        program: artifact.target.name.clone(),
        name: name.to_owned(),
        executable: executable.clone(),
        folder: folder.to_path_buf(),
    };
    Ok(names.map(test).collect())
}
