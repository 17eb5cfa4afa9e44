//! Strangers' input: scene files, protocol lines, pictures and the output of programs, made by a
//! grammar and by mutation.
//!
//! No input makes the kit panic, hang, or say anything but one line. tests/fuzz has what must hold,
//! and the seeds; `PROPTEST_CASES` sets how many inputs there are.

use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::fs;
use std::path::{Path, PathBuf};

#[path = "../../tests/fuzz/src/lib.rs"]
mod properties;

mod fuzz {
    mod adapter_answers;
    mod picture_files;
    mod protocol_lines;
    mod scene_files;
}

/// The files of a folder of tests/, sorted by name.
fn files(folder: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../tests")
        .join(folder);
    let entries = fs::read_dir(folder).expect("a directory");
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    let bytes = |path: &PathBuf| fs::read(path).expect("a file");
    paths.iter().map(bytes).collect()
}

/// The same, of texts.
fn texts(folder: &str) -> Vec<String> {
    let text = |bytes| String::from_utf8(bytes).expect("a text");
    files(folder).into_iter().map(text).collect()
}

/// `PROPTEST_CASES`, or so many.
fn cases(usual: u32) -> ProptestConfig {
    let mut config = ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = usual;
    }
    config
}

/// A change of a text: at a place, so many bytes go, and others come.
fn change() -> impl Strategy<Value = (Index, usize, String)> {
    // Parted by blanks; `_` stands for one, and `~` for the end of a line.
    let words = "nan inf -inf -1 0 1e308 1e-320 1e999 0x10 9223372036854775808 [ ] [[sphere]]~ \
        [camera]~ radius_=_ center_=_ \" ''' ~ # = , { } . \u{0} \u{e9} \u{1f300} true 1979-05-27 up \
        null 7fc00000 ffffffff \"in\": \"tmin\": \\ud800";
    let word = |word: &str| word.replace('_', " ").replace('~', "\n");
    let words = select(words.split_whitespace().map(word).collect::<Vec<_>>());
    let text = prop_oneof![words, ".{0,3}"];
    (any::<Index>(), 0_usize..12, text)
}

fn changed(text: &str, changes: Vec<(Index, usize, String)>) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for (place, gone, text) in changes {
        let start = place.index(bytes.len() + 1);
        let end = bytes.len().min(start + gone);
        bytes.splice(start..end, text.into_bytes());
    }
    bytes
}

fn changes() -> impl Strategy<Value = Vec<(Index, usize, String)>> {
    prop::collection::vec(change(), 1..5)
}
