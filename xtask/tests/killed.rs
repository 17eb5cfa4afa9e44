//! Commands that are killed at any moment leave whole files only, and the next run repairs.
//!
//! `OMBRAGE_KILLS=100 cargo test -p xtask --test killed` kills each command so many times.

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::hash::{BuildHasher, RandomState};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};
use tempfile::TempDir;
use xtask::whole_file::{PREFIX, WholeFile};

/// The commands that write files; `OUT` stands for the directory they write to. A report that
/// measures differs from run to run; it is written as one from known data is.
const WRITERS: [&[&str]; 4] = [
    &["figures", "--size", "300x200", "--out", "OUT"],
    &["vectors", "--out", "OUT"],
    &["report", "--from", "DOCS/report/data.json", "--out", "OUT"],
    &["render", "SCENES/base.toml", "--out", "OUT/base.png"],
];

/// What a file holds before a command runs: nothing that a command writes.
const OLD: &[u8] = b"old";

type Files = BTreeMap<PathBuf, Vec<u8>>;

fn start(writer: &[&str], out: &Path) -> Child {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let places = [
        ("OUT", out.to_owned()),
        ("SCENES", root.join("tests").join("scenes")),
        ("DOCS", root.join("docs")),
    ];
    let args = writer.iter().map(|word| {
        let named = |word: String, (name, path): &(&str, PathBuf)| {
            word.replace(name, path.to_str().expect("a path in UTF-8"))
        };
        places.iter().fold((*word).to_owned(), named)
    });
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.args(args).stdout(Stdio::null());
    command.spawn().expect("the program starts")
}

/// Runs to the end; how long it took.
fn run(writer: &[&str], out: &Path) -> Duration {
    let begin = Instant::now();
    let status = start(writer, out).wait().expect("an end");
    assert!(status.success(), "{writer:?}: {status}");
    begin.elapsed()
}

/// Every file below a directory, by its path from there.
fn files(directory: &Path) -> Files {
    let mut found = Files::new();
    for entry in fs::read_dir(directory).expect("a directory") {
        let entry = entry.expect("an entry");
        let (name, path) = (PathBuf::from(entry.file_name()), entry.path());
        if path.is_dir() {
            let inner = files(&path).into_iter();
            found.extend(inner.map(|(path, bytes)| (name.join(path), bytes)));
        } else {
            found.insert(name, fs::read(&path).expect("a file"));
        }
    }
    found
}

fn is_unfinished(path: &Path) -> bool {
    let name = path.file_name().expect("a name");
    name.as_encoded_bytes().starts_with(PREFIX.as_bytes())
}

fn has_unfinished(directory: &Path) -> bool {
    let entries = fs::read_dir(directory).expect("a directory");
    entries.flatten().any(|entry| is_unfinished(&entry.path()))
}

/// A part of a duration, by chance.
fn part_of(duration: Duration) -> Duration {
    let chance = RandomState::new().hash_one(0) as f64 / u64::MAX as f64;
    duration.mul_f64(chance)
}

/// Kills the command: at any moment of its life, or, for `while_writing`, soon after it has begun
/// a file.
fn kill(writer: &[&str], out: &Path, life: Duration, while_writing: bool) {
    let mut child = start(writer, out);
    if while_writing {
        while !has_unfinished(out) && child.try_wait().expect("a status").is_none() {
            sleep(Duration::from_micros(50));
        }
        sleep(part_of(life / 20));
    } else {
        sleep(part_of(life));
    }
    child.kill().expect("it is killed or has ended");
    child.wait().expect("an end");
}

#[test]
fn a_killed_command_leaves_whole_files_and_the_next_run_repairs() {
    let kills = env::var("OMBRAGE_KILLS").map_or(4, |kills| kills.parse().expect("a number"));
    let mut abandoned = 0;
    for writer in WRITERS {
        let place = TempDir::new().expect("a directory");
        let out = place.path();
        let life = run(writer, out);
        let new = files(out);
        assert!(!new.is_empty(), "{writer:?} writes nothing");
        let (mut untouched, mut half, mut done) = (0, 0, 0);
        for number in 0..kills {
            for name in new.keys() {
                fs::write(out.join(name), OLD).expect("a file");
            }
            kill(writer, out, life, number % 2 == 0);
            let left = files(out);
            let (unfinished, whole): (Files, Files) =
                left.into_iter().partition(|(path, _)| is_unfinished(path));
            abandoned += unfinished.len();
            assert!(
                whole.keys().eq(new.keys()),
                "{writer:?}: {:?}",
                whole.keys()
            );
            for (name, bytes) in &whole {
                let is_whole = bytes == OLD || *bytes == new[name];
                assert!(is_whole, "{writer:?}: {} is cut short", name.display());
            }
            match whole.values().filter(|bytes| *bytes == OLD).count() {
                0 => done += 1,
                old if old == new.len() => untouched += 1,
                _ => half += 1,
            }
            run(writer, out);
            assert!(
                files(out) == new,
                "{writer:?}: the next run does not repair"
            );
        }
        println!(
            "{}: {kills} kills; {untouched} left all files old, {half} some, {done} none",
            writer[0]
        );
    }
    println!("{abandoned} unfinished files were left and removed");
    assert!(abandoned > 0, "no kill met a file that was being written");
}

#[test]
fn only_abandoned_files_are_removed() {
    let place = TempDir::new().expect("a directory");
    let path = |name: &str| place.path().join(name);
    fs::write(path(&format!("{PREFIX}abandoned")), "half").expect("a file");
    fs::create_dir(path(&format!("{PREFIX}directory"))).expect("a directory");
    fs::write(path("another"), "whole").expect("a file");

    let first = WholeFile::create(&path("first")).expect("a file");
    let second = WholeFile::create(&path("second")).expect("a file");
    assert!(!path(&format!("{PREFIX}abandoned")).exists());
    assert!(path(&format!("{PREFIX}directory")).exists());
    first.keep().expect("it is in its place");
    drop(second);
    let names: Vec<_> = files(place.path()).into_keys().collect();
    assert_eq!(names, ["another", "first"].map(PathBuf::from));
}

#[test]
fn a_file_that_is_there_already_keeps_its_time() {
    let place = TempDir::new().expect("a directory");
    let path = place.path().join("file");
    let write = |text: &str| {
        let mut file = WholeFile::create(&path).expect("a file");
        file.write(|file| file.write_all(text.as_bytes()))
            .expect("it is filled");
        file.keep().expect("it is in its place");
        assert_eq!(fs::read_to_string(&path).expect("a file"), text);
        fs::metadata(&path)
            .and_then(|data| data.modified())
            .expect("a time")
    };
    let long_ago = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000);
    write("old");
    let file = fs::File::options().write(true).open(&path).expect("a file");
    file.set_modified(long_ago).expect("a time");
    assert_eq!(write("old"), long_ago);
    assert!(write("new") > long_ago);
    assert_eq!(files(place.path()).len(), 1);
}
