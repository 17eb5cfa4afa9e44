//! `cargo xtask digests`, run as a program.

use std::process::{Command, Output};

fn run(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.arg("digests").args(args);
    command.output().expect("the program starts")
}

#[test]
fn this_build_computes_the_committed_digests() {
    let output = run(&["--check"]);
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}");
    assert_eq!(said, "");
}

#[test]
fn unknown_builds_are_refused_and_the_known_ones_named() {
    let output = run(&["--builds", "dev,zebra"]);
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert_eq!(error.lines().count(), 1);
    assert!(
        error.contains("'zebra' is no build") && error.contains("release-v3"),
        "{error}"
    );
}
