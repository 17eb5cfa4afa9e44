//! The shadow strategies on the scenes of tests/scenes: the default is never wrong, and what the
//! others get wrong is known.
//!
//! All counts are of pictures at most 300 pixels wide. A count that changes on purpose is accepted
//! with `cargo insta review`.

use indicatif::ProgressBar;
use ombrage::Quality;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::sync::LazyLock;
use xtask::case::Case;
use xtask::compare::moved;
use xtask::shadows::{Row, Strategy, judge, totals};

const WIDTH: u32 = 300;

/// What every strategy gets wrong on every scene, counted once for all tests.
static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/scenes");
    let files = std::fs::read_dir(folder).expect("the folder of scenes");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    paths.sort();
    let case = |path| Case::read(path).and_then(|case| case.at_most(WIDTH));
    let cases: Vec<Case> = paths
        .iter()
        .map(|path| case(path).expect("a scene"))
        .collect();
    assert!(cases.len() >= 23, "{} scenes", cases.len());
    judge(&cases, Quality::Textbook, &ProgressBar::hidden()).expect("every scene is valid")
});

fn sidedness(float: &str) -> Vec<&'static Row> {
    let name = Strategy::Sidedness.name();
    let rows = ROWS
        .iter()
        .filter(|row| row.strategy == name && row.float == float);
    rows.collect()
}

fn is_never_wrong(float: &str) {
    let rows = sidedness(float);
    for row in &rows {
        assert_eq!(row.wrong.shadows() + row.wrong.turned, 0, "{row:?}");
    }
    let rays: usize = rows.iter().map(|row| row.wrong.rays).sum();
    assert!(rays > 1_000_000, "only {rays} shadow rays were judged");
}

#[test]
fn the_default_is_never_wrong_in_f64() {
    is_never_wrong("f64");
}

/// Scenes are rounded to `f32` first, so there is none that `f32` cannot represent.
#[test]
fn the_default_is_never_wrong_in_f32() {
    is_never_wrong("f32");
}

/// Every other strategy is wrong somewhere, in `f32` at least: the truth can tell.
#[test]
fn every_other_strategy_is_wrong_somewhere() {
    for total in totals(&ROWS) {
        let is_default = total.strategy == Strategy::Sidedness.name();
        if total.float == "f32" && !is_default {
            assert!(total.wrong.acne + total.wrong.leak > 0, "{total:?}");
        }
    }
}

#[test]
fn the_counts_are_the_accepted_ones() {
    let mut text = format!(
        "{:<20} {:<14} {:<5} {:>8} {:>8} {:>8} {:>8} {:>8}\n",
        "scene", "strategy", "float", "rays", "acne", "false", "leak", "turned"
    );
    for row in ROWS.iter() {
        let wrong = &row.wrong;
        writeln!(
            text,
            "{:<20} {:<14} {:<5} {:>8} {:>8} {:>8} {:>8} {:>8}",
            row.scene,
            row.strategy,
            row.float,
            wrong.rays,
            wrong.acne,
            wrong.false_shadow,
            wrong.leak,
            wrong.turned
        )
        .expect("a string takes everything");
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/../snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("shadow-strategies", text));
}

/// Far from the origin the default stays right, and the lab's way does not.
#[test]
fn moving_the_scene_changes_hardly_a_byte() {
    let truth = moved::truth().expect("the lab's scene is valid");
    let far = moved::measure_at(&truth, 1e7).expect("the lab's scene is valid");
    assert!(far.f32.relative <= 10, "{far:?}");
    assert_eq!(far.f64.relative, 0, "{far:?}");
    assert!(far.f32.lab > 50_000, "{far:?}");
}

/// Seen up to the horizon, the plane has the same bytes in truth as in `f64`.
#[test]
fn an_infinite_t_max_has_a_true_picture() {
    let infinite = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/scenes/infinite.toml");
    let output = Command::new(env!("CARGO_BIN_EXE_xtask"))
        .args(["compare", "--json"])
        .arg(infinite)
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{output:?}");
    let rows: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    for way in 0..2 {
        assert_eq!(rows[way]["f64"]["bytes"], 0, "{}", rows[way]);
    }
}
