//! Scene files: those of the project, and bad ones.

use std::path::{Path, PathBuf};
use xtask::scene_file;

/// The scene files of the project, sorted.
fn scene_files() -> Vec<PathBuf> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/scenes");
    let entries = directory.read_dir().expect("a directory");
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    assert!(paths.len() >= 23);
    paths
}

#[test]
fn every_scene_loads_under_its_name() {
    for path in scene_files() {
        let file = scene_file::load(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(path.file_stem().unwrap_or_default(), file.name.as_str());
    }
}
