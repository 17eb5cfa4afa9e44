//! The project that is tested: its files, and the programs that are asked about it.

use crate::error::{Error, Result};
use std::collections::BTreeMap;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The project around this tool.
#[derive(Debug)]
pub struct Project {
    root: PathBuf,
    files: BTreeMap<String, Vec<u8>>,
}

impl Project {
    /// Reads all files that git tracks, and new ones that it does not ignore.
    ///
    /// # Errors
    /// If git cannot list them, or one cannot be read.
    pub fn read() -> Result<Self> {
        let place = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let root = place.canonicalize().map_err(|error| {
            Error::new(format!(
                "cannot find the project of this program: {error}; run it by cargo run"
            ))
        })?;
        let mut git = Command::new("git");
        git.args([
            "ls-files",
            "-z",
            "--cached",
            "--others",
            "--exclude-standard",
        ]);
        let names = output(git.current_dir(&root), "run this in a clone of the project")?;
        let mut files = BTreeMap::new();
        for name in String::from_utf8_lossy(&names).split_terminator('\0') {
            let path = root.join(name);
            // One that is deleted and not committed yet is still listed.
            if path.is_file() {
                let bytes = fs::read(&path).map_err(|error| {
                    Error::new(format!("cannot read {name}: {error}; make it readable"))
                })?;
                files.insert(name.to_owned(), bytes);
            }
        }
        Ok(Self { root, files })
    }

    /// Where it is.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Where everything is that the tool writes.
    pub fn room(&self) -> PathBuf {
        self.root.join("target").join("mutants")
    }

    /// Its files by their path from the root.
    pub fn files(&self) -> &BTreeMap<String, Vec<u8>> {
        &self.files
    }

    /// A source file as text.
    ///
    /// # Errors
    /// If there is none, or it is not UTF-8.
    pub fn text(&self, file: &str) -> Result<&str> {
        let bytes = self.files.get(file).map(Vec::as_slice);
        let text = bytes.and_then(|bytes| std::str::from_utf8(bytes).ok());
        text.ok_or_else(|| Error::new(format!("cannot read {file}: is it committed, and UTF-8?")))
    }
}

/// A short digest of what outcomes depend on.
pub fn digest(what: impl Hash) -> String {
    let mut hasher = DefaultHasher::new();
    what.hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}

/// The standard output of a program that ends well; `advice` is what to do if it does not.
///
/// # Errors
/// If it cannot be started, or fails.
pub fn output(command: &mut Command, advice: &str) -> Result<Vec<u8>> {
    let program = command.get_program().to_string_lossy().into_owned();
    let first = command.get_args().next().unwrap_or_default();
    let name = format!("{program} {}", first.to_string_lossy());
    let failed = |why: String| Error::new(format!("{name} fails: {why}; {advice}"));
    let output = command.stdin(Stdio::null()).output();
    let output = output.map_err(|error| failed(error.to_string()))?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(failed(said.trim().chars().take(500).collect()))
}
