//! Files that are written whole or not at all.
//!
//! A file is filled under another name beside its place and then renamed. Its writer holds a lock on
//! it, which the system takes back however the writer ends. So an unfinished file that nobody locks
//! was left by a writer that was killed, and whoever writes to the same directory next removes it.

use crate::error::{Error, Result};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use tempfile::NamedTempFile;

/// How the names of unfinished files begin. `.gitignore` knows it too.
pub const PREFIX: &str = ".ombrage-";

/// The unfinished files, for Ctrl-C to remove.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// A new file beside the one it is to replace. Dropped before [`WholeFile::keep`], it disappears.
#[derive(Debug)]
pub struct WholeFile {
    file: NamedTempFile,
    target: PathBuf,
}

impl WholeFile {
    /// Starts the file, and makes the directory it belongs to; removes what killed writers left there.
    ///
    /// # Errors
    /// If the directory cannot be made or written to, or the place is itself a directory.
    pub fn create(target: &Path) -> Result<Self> {
        remove_on_interrupt();
        if target.is_dir() {
            let error = io::Error::from(io::ErrorKind::IsADirectory);
            return Err(cannot_write(target, &error));
        }
        let directory = target.parent().unwrap_or(Path::new(""));
        make_directory(directory)?;
        let beside = if directory.as_os_str().is_empty() {
            Path::new(".")
        } else {
            directory
        };
        // Created under the mutex: an interrupt either sees the file or comes before it.
        let mut unfinished = unfinished();
        remove_abandoned(beside);
        let file = locked_file(beside).map_err(|error| cannot_write(target, &error))?;
        unfinished.insert(file.path().to_path_buf());
        Ok(Self {
            file,
            target: target.to_path_buf(),
        })
    }

    /// Fills the file.
    ///
    /// # Errors
    /// If `write` fails.
    pub fn write(&mut self, write: impl FnOnce(&mut File) -> io::Result<()>) -> Result<()> {
        write(self.file.as_file_mut()).map_err(|error| cannot_write(&self.target, &error))
    }

    /// Puts the file in its place, in one step. One that is there already keeps its time of change,
    /// so that nothing is built again that includes it.
    ///
    /// # Errors
    /// If it cannot be put there.
    pub fn keep(self) -> Result<()> {
        let Self { file, target } = self;
        let unfinished_path = file.path().to_path_buf();
        let kept = match is_same(&unfinished_path, &target) {
            true => file.close(),
            false => file
                .persist(&target)
                .map(drop)
                .map_err(|failed| failed.error),
        };
        unfinished().remove(&unfinished_path);
        kept.map_err(|error| cannot_write(&target, &error))
    }
}

/// Whether two files are there and have the same bytes.
fn is_same(a: &Path, b: &Path) -> bool {
    let length = |path: &Path| fs::metadata(path).ok().map(|data| data.len());
    length(a).is_some_and(|of_a| length(b) == Some(of_a))
        && fs::read(a).is_ok_and(|of_a| fs::read(b).is_ok_and(|of_b| of_a == of_b))
}

/// A new file under a name that nobody takes for a finished one, locked.
fn locked_file(directory: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    loop {
        let file = builder.tempfile_in(directory)?;
        // Where files cannot be locked, nobody can hold this one for abandoned either.
        let _ = file.as_file().lock();
        // Another writer may have held it for abandoned before the lock was ours.
        if file.path().exists() {
            return Ok(file);
        }
    }
}

/// Removes the unfinished files of writers that are no more. What cannot be read, locked or removed
/// stays: it is in nobody's way.
fn remove_abandoned(directory: &Path) {
    let Ok(entries) = fs::read_dir(directory) else {
        return;
    };
    for entry in entries.flatten() {
        let is_unfinished = entry
            .file_name()
            .as_encoded_bytes()
            .starts_with(PREFIX.as_bytes());
        if !is_unfinished || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        let path = entry.path();
        // The lock is held while the file is removed, so its writer cannot come in between.
        if let Ok(file) = File::open(&path)
            && file.try_lock().is_ok()
        {
            let _ = fs::remove_file(&path);
        }
    }
}

fn make_directory(directory: &Path) -> Result<()> {
    if directory.as_os_str().is_empty() || directory.is_dir() {
        return Ok(());
    }
    let not_a_directory = directory
        .ancestors()
        .find(|part| part.exists() && !part.is_dir());
    if let Some(file) = not_a_directory {
        return Err(Error::new(format!(
            "{} is a file, not a directory: choose another directory",
            file.display()
        )));
    }
    fs::create_dir_all(directory).map_err(|error| {
        Error::new(format!(
            "cannot make the directory {}: {error}; choose another directory",
            directory.display()
        ))
    })
}

fn cannot_write(target: &Path, error: &io::Error) -> Error {
    let advice = match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "free some space",
        io::ErrorKind::IsADirectory => "remove that directory",
        _ => "make its directory writable",
    };
    Error::new(format!(
        "cannot write {}: {error}; {advice}, or choose another directory",
        target.display()
    ))
}

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes Ctrl-C and SIGTERM remove the unfinished files before they end the process.
fn remove_on_interrupt() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let handler = || {
            // Held to the end of the process, so that nothing new is begun.
            let unfinished = unfinished();
            for path in unfinished.iter() {
                // Nothing is left to do about a file that cannot be removed.
                let _ = fs::remove_file(path);
            }
            process::exit(130);
        };
        // Without the handler an interrupt still leaves every old file whole.
        let _ = ctrlc::set_handler(handler);
    });
}
