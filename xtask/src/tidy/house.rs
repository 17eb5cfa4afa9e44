//! The texts of the project.

use crate::error::{Error, Result};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Where texts are.
const ROOMS: [&str; 8] = [
    "src",
    "tests",
    "xtask",
    "docs",
    ".ci",
    ".cargo",
    "README.md",
    "Cargo.toml",
];

/// What else the workspace begins with.
const BESIDE: [&str; 7] = [
    ".git",
    ".gitignore",
    "Cargo.lock",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "snapshots",
    "target",
];

/// What texts end in; those in .ci have no ending.
const ENDINGS: [&str; 6] = ["rs", "md", "toml", "css", "js", ""];

/// A text and its path from the workspace, with slashes.
pub struct Text {
    /// The path.
    pub path: String,
    /// All of it.
    pub text: String,
}

/// The texts of the project, sorted by path.
pub struct House {
    root: PathBuf,
    files: Vec<Text>,
    strangers: Vec<String>,
}

impl House {
    /// Reads the workspace at `root`.
    ///
    /// # Errors
    /// If a file cannot be read, or is not UTF-8.
    pub fn read(root: &Path) -> Result<Self> {
        let mut house = Self {
            root: root.to_path_buf(),
            files: vec![],
            strangers: vec![],
        };
        for entry in fs::read_dir(root.join(".")).map_err(|error| unreadable(root, &error))? {
            let name = entry.map_err(|error| unreadable(root, &error))?.file_name();
            let name = name.to_string_lossy();
            if !ROOMS.contains(&&*name) && !BESIDE.contains(&&*name) {
                house.strangers.push(name.into_owned());
            }
        }
        for room in ROOMS {
            house.enter(room)?;
        }
        house.files.sort_by(|a, b| a.path.cmp(&b.path));
        Ok(house)
    }

    /// A house of these paths and texts, for tests.
    #[cfg(test)]
    pub fn of(files: &[(&str, &str)]) -> Self {
        let text = |(path, text): &(&str, &str)| Text {
            path: (*path).into(),
            text: (*text).into(),
        };
        Self {
            root: PathBuf::new(),
            files: files.iter().map(text).collect(),
            strangers: vec![],
        }
    }

    /// Its texts.
    pub fn files(&self) -> &[Text] {
        &self.files
    }

    /// What lies in the root and has no place there.
    pub fn strangers(&self) -> &[String] {
        &self.strangers
    }

    /// Those whose name has this ending.
    pub fn ending<'a>(&'a self, ending: &'a str) -> impl Iterator<Item = &'a Text> {
        self.files
            .iter()
            .filter(move |file| file.path.ends_with(ending))
    }

    /// Whether there is such a file or directory.
    pub fn has(&self, path: &str) -> bool {
        self.files.iter().any(|file| file.path == path) || self.root.join(path).exists()
    }

    fn enter(&mut self, path: &str) -> Result<()> {
        let place = self.root.join(path);
        let failed = |error: io::Error| unreadable(&place, &error);
        if place.is_dir() {
            // What git ignores here is not the project's.
            let ignored = fs::read_to_string(place.join(".gitignore")).unwrap_or_default();
            for entry in fs::read_dir(&place).map_err(failed)? {
                let name = entry.map_err(failed)?.file_name();
                let name = name.to_string_lossy();
                if ignored.lines().all(|line| line != format!("/{name}")) {
                    self.enter(&format!("{path}/{name}"))?;
                }
            }
        } else {
            let ending = Path::new(path)
                .extension()
                .unwrap_or_default()
                .to_string_lossy();
            if ENDINGS.contains(&ending.as_ref()) {
                let text = fs::read_to_string(&place).map_err(failed)?;
                self.files.push(Text {
                    path: path.to_owned(),
                    text,
                });
            }
        }
        Ok(())
    }
}

fn unreadable(place: &Path, error: &io::Error) -> Error {
    let place = place.display();
    Error::new(format!("cannot read {place}: {error}; make it readable"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_place_in_the_root_is_a_stranger() {
        let place = tempfile::TempDir::new().expect("a directory");
        for room in ROOMS {
            fs::create_dir(place.path().join(room)).expect("a room");
        }
        let strangers = || House::read(place.path()).expect("a house").strangers;
        assert_eq!(strangers(), [""; 0]);
        fs::write(place.path().join("Cargo.lock"), "").expect("a file");
        fs::write(place.path().join("left.whl"), [0xff]).expect("a file");
        assert_eq!(strangers(), ["left.whl"]);
    }
}
