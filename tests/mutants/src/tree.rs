//! The copy of the project that has the switches.

use crate::error::{Error, Result};
use crate::mutant::PACKAGES;
use crate::mutant_switch::MOST;
use crate::project::{Project, digest};
use crate::rewrite::Switched;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The module that switches are asked of.
const MODULE: &str = include_str!("mutant_switch.rs");

/// The last line of a crate that has it.
const DECLARED: &str = "pub mod mutant_switch;\n";

/// The copy: `target/mutants/tree`, with a target directory of its own in it.
pub struct Tree<'a> {
    project: &'a Project,
    root: PathBuf,
}

impl<'a> Tree<'a> {
    /// The copy of a project; nothing is written yet.
    pub fn of(project: &'a Project) -> Self {
        let root = project.room().join("tree");
        Self { project, root }
    }

    /// Where it is.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Makes it the project with these files in place of the project's. A file that is as it should be
    /// keeps its time, so that cargo builds no more than what changed.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, switched: &BTreeMap<String, Switched>) -> Result<()> {
        let texts = self.texts(switched);
        self.sweep(&self.root, "", &texts)?;
        for (name, bytes) in &texts {
            let path = self.root.join(name);
            if fs::read(&path).is_ok_and(|old| old == **bytes) {
                continue;
            }
            let failed = |error| Error::at(&path, &error);
            fs::create_dir_all(path.parent().unwrap_or(&self.root)).map_err(failed)?;
            fs::write(&path, bytes).map_err(failed)?;
            // Scripts can be run in the copy too.
            if let Ok(original) = fs::metadata(self.project.root().join(name)) {
                fs::set_permissions(&path, original.permissions()).map_err(failed)?;
            }
        }
        Ok(())
    }

    /// A digest of all that it has with these files.
    pub fn digest(&self, switched: &BTreeMap<String, Switched>) -> String {
        digest(self.texts(switched))
    }

    /// Cargo, in the copy.
    pub fn cargo(&self, arguments: &[&str]) -> Command {
        let mut cargo = Command::new("cargo");
        cargo.args(arguments).current_dir(&self.root);
        cargo.env("CARGO_TARGET_DIR", self.root.join("target"));
        // Switches break lints, and some lints are errors; flags from elsewhere would come before these.
        // For this processor alone, which has the same bits, a drawing loop has fewer copies.
        cargo.env("RUSTFLAGS", "--cap-lints=warn -Ctarget-cpu=native");
        cargo.env_remove("CARGO_ENCODED_RUSTFLAGS");
        // Nobody debugs these programs, and they are rebuilt as a whole: half of the size and time.
        cargo.env("CARGO_PROFILE_DEV_DEBUG", "none");
        cargo.env("CARGO_INCREMENTAL", "0");
        cargo
    }

    fn texts<'b>(
        &'b self,
        switched: &'b BTreeMap<String, Switched>,
    ) -> BTreeMap<String, Cow<'b, [u8]>> {
        let files = self.project.files().iter();
        let mut texts: BTreeMap<String, Cow<'b, [u8]>> = files
            .map(|(name, bytes)| match switched.get(name) {
                Some(switched) => (name.clone(), Cow::Borrowed(switched.text.as_bytes())),
                None => (name.clone(), Cow::Borrowed(bytes.as_slice())),
            })
            .collect();
        for (_, folder) in PACKAGES {
            let root = format!("{folder}lib.rs");
            let has_switches = switched.keys().any(|name| name.starts_with(folder));
            if let (true, Some(text)) = (has_switches, texts.get_mut(&root)) {
                let text = text.to_mut();
                if !text.ends_with(b"\n") {
                    text.push(b'\n');
                }
                text.extend_from_slice(DECLARED.as_bytes());
                let module = Cow::Borrowed(MODULE.as_bytes());
                texts.insert(format!("{folder}mutant_switch.rs"), module);
            }
        }
        texts
    }

    /// Removes what the project no longer has, and what tests have written.
    fn sweep(&self, folder: &Path, name: &str, texts: &BTreeMap<String, Cow<[u8]>>) -> Result<()> {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let path = entry.path();
            let name = format!("{name}{}", entry.file_name().to_string_lossy());
            let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
            if is_folder && name != "target" {
                self.sweep(&path, &format!("{name}/"), texts)?;
            } else if !is_folder && !texts.contains_key(&name) {
                fs::remove_file(&path).map_err(|error| Error::at(&path, &error))?;
            }
        }
        Ok(())
    }
}

/// Whether so many mutants have room in one program.
///
/// # Errors
/// If they have not.
pub fn has_room(mutants: usize) -> Result<()> {
    if mutants <= MOST {
        return Ok(());
    }
    Err(Error::new(format!(
        "{mutants} mutants are more than {MOST}: name fewer files"
    )))
}
