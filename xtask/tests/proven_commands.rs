//! `--proven` of `cargo xtask figures` and `cargo xtask render`, run as a program.

use ombrage::{Engine, Figure, Film, Lighting, Picture, Rung, Size, render_proven};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;
use xtask::{picture_file, scene_file};

/// Two planes that meet in the middle column, at a place that no square roots give: the tangent of
/// 36.5 degrees is part of it.
const TIE: &str = "
name = \"tie\"
background = [0.5, 0.5, 0.5]
t_max = 1000

[camera]
position = [0, 0, 0]
look_at = [0, 0, 1]
up = [0, 1, 0]
fov = 73

[image]
width = 5
height = 3

[[plane]]
point = [0, 0, 5]
normal = [1, 1, 1]
color = [1, 0, 0]

[[plane]]
point = [0, 0, 5]
normal = [-1, 1, 1]
color = [0, 0, 1]

[[light]]
position = [0, 0, 1]
color = [1, 1, 1]
power = 10
";

fn run(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.args(args).output().expect("the program starts")
}

/// Standard output; the command must end with the status.
fn printed(args: &[&str], status: i32) -> String {
    let output = run(args);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(status), "{args:?}: {errors}");
    assert_eq!(errors, "");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// The error of bad usage.
fn refused(args: &[&str]) -> String {
    let output = run(args);
    assert_eq!(output.status.code(), Some(2), "{args:?}");
    assert!(output.stdout.is_empty());
    String::from_utf8(output.stderr).expect("UTF-8")
}

fn read(path: &Path) -> Picture {
    picture_file::read(path).expect("a picture")
}

/// The cells of a table's row.
fn cells(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}

/// `rungs` and `undecided` of a row are those of a proof.
fn has_counts(row: &Value, proven: &ombrage::Proven) {
    let rungs = row["rungs"].as_object().expect("rungs");
    let names: Vec<&String> = rungs.keys().collect();
    assert_eq!(names, ["f32", "f64", "double_double", "exact"]);
    for rung in Rung::ALL {
        let count = match rung {
            Rung::Undecided => &row["undecided"],
            _ => &rungs[rung.name()],
        };
        assert_eq!(*count, proven.count(rung), "{}", rung.name());
    }
}

#[test]
fn figures_are_proven() {
    let directory = TempDir::new().expect("a directory");
    let out = directory.path().to_str().expect("UTF-8");
    let size = Size::new(61, 41).expect("a size");
    let args = ["figures", "--proven", "--size", "61x41", "--out", out];
    let table = printed(&args, 0);
    let lines: Vec<&str> = table.lines().collect();
    let heads = "figure size ms ns/pixel f32 f64 double-double exact undecided";
    assert_eq!(cells(lines[0]).join(" "), heads);
    let json = printed(&[&args[..], &["--json"]].concat(), 0);
    let report: Value = serde_json::from_str(&json).expect("JSON");
    let rows = report["figures"].as_array().expect("rows");
    let names = ["1", "2a", "2b", "3c"];
    assert_eq!(rows.len(), names.len());
    for (name, (row, line)) in names
        .into_iter()
        .zip(rows.iter().zip(&lines[lines.len() - 4..]))
    {
        let figure = Figure::named(name).expect("a figure");
        let proven = figure.prove_with(size, Engine::default()).expect("valid");
        let proven = proven.expect("a figure without errors of rounding");
        assert_eq!(row["name"], name);
        has_counts(row, &proven);
        let counts = Rung::ALL.map(|rung| proven.count(rung).to_string());
        let line = line.replace(',', "");
        let found = cells(&line);
        assert_eq!(found[..2], [name, "61x41"]);
        assert_eq!(found[4..], counts);
        let file = directory.path().join(format!("fig{name}.png"));
        assert!(read(&file) == *proven.picture(), "figure {name}");
    }
    let files = fs::read_dir(directory.path()).expect("a directory").count();
    assert_eq!(files, names.len(), "3a, 3b and the sheets are left out");
}

/// Four rays of this picture touch the sphere exactly.
#[test]
fn json_counts_exact_ties() {
    let directory = TempDir::new().expect("a directory");
    let out = directory.path().to_str().expect("UTF-8");
    let args = [
        "figures", "--proven", "--json", "--only", "3c", "--size", "9x9", "--out", out,
    ];
    let report: Value = serde_json::from_str(&printed(&args, 0)).expect("JSON");
    let row = &report["figures"][0];
    assert_eq!(
        (&row["rungs"]["exact"], &row["undecided"]),
        (&4.into(), &0.into())
    );
    assert_eq!(row.get("undecided_pixels"), None);
}

#[test]
fn figures_of_errors_are_not_proven() {
    let directory = TempDir::new().expect("a directory");
    let out = directory.path().to_str().expect("UTF-8");
    let error = refused(&["figures", "--proven", "--only", "3a", "--out", out]);
    assert!(
        error.contains("3a") && error.lines().count() == 1,
        "{error}"
    );
    for more in [
        &["--float", "f64", "--out", out][..],
        &["--check", "--out", out],
        &[],
    ] {
        refused(&[&["figures", "--proven"], more].concat());
    }
    assert_eq!(
        fs::read_dir(directory.path()).expect("a directory").count(),
        0
    );
}

#[test]
fn scenes_are_proven() {
    let directory = TempDir::new().expect("a directory");
    let [scene, out] = ["scene.toml", "picture.png"].map(|name| directory.path().join(name));
    fs::write(&scene, include_str!("../../tests/scenes/three_lights.toml")).expect("a file");
    let [path, picture] = [&scene, &out].map(|path| path.to_str().expect("UTF-8"));
    let args = [
        "render", path, "--proven", "--size", "60x40", "--out", picture,
    ];
    let content = scene_file::load(&scene).expect("a scene");
    let size = Size::new(60, 40).expect("a size");
    let (lighting, film) = (Lighting::Shadowed, Film::Clamp);
    let proven = render_proven(&content.scene, &content.view, size, lighting, film);
    let proven = proven.expect("valid");
    let table = printed(&args, 0);
    let lines: Vec<&str> = table.lines().collect();
    let heads = cells(lines[0]).join(" ");
    assert!(
        heads.ends_with("f32 f64 double-double exact undecided"),
        "{heads}"
    );
    let row = lines[lines.len() - 1].replace(',', "");
    let counts = Rung::ALL.map(|rung| proven.count(rung).to_string());
    assert!(
        cells(&row).ends_with(&counts.each_ref().map(String::as_str)),
        "{row}"
    );
    assert!(read(&out) == *proven.picture());
    let json = printed(&[&args[..], &["--json"]].concat(), 0);
    let row: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(row["float"], "proven");
    has_counts(&row, &proven);
    for more in [
        ["--shadow", "ulp-offset"],
        ["--quality", "wide"],
        ["--float", "f32"],
    ] {
        refused(&[&args[..], &more].concat());
    }
}

/// Plain pictures have no rungs in their table.
#[test]
fn plain_pictures_have_no_proof() {
    let directory = TempDir::new().expect("a directory");
    let out = directory.path().to_str().expect("UTF-8");
    let args = [
        "figures", "--json", "--only", "1", "--size", "6x4", "--out", out,
    ];
    let json = printed(&args, 0);
    assert!(
        !json.contains("rungs") && !json.contains("undecided"),
        "{json}"
    );
}

/// What cannot be proven is listed with its reason, is black, and is a finding.
#[test]
fn undecided_pixels_are_told() {
    let directory = TempDir::new().expect("a directory");
    let [scene, out] = ["scene.toml", "picture.png"].map(|name| directory.path().join(name));
    fs::write(&scene, TIE).expect("a file");
    let [path, picture] = [&scene, &out].map(|path| path.to_str().expect("UTF-8"));
    let args = ["render", path, "--proven", "--out", picture];
    let text = printed(&args, 1);
    let told: Vec<&str> = text
        .lines()
        .skip_while(|line| *line != "not proven:")
        .collect();
    assert_eq!(told.len(), 3, "{text}");
    for (line, row) in told[1..].iter().zip([0, 2]) {
        let place = format!("tie: column 2, row {row}: ");
        assert!(
            line.starts_with(&place) && line.contains("not decided"),
            "{line}"
        );
    }
    let json = printed(&[&args[..], &["--json"]].concat(), 1);
    let row: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(row["undecided"], 2);
    let pixels = row["undecided_pixels"].as_array().expect("pixels");
    assert_eq!(
        (&pixels[1]["column"], &pixels[1]["row"]),
        (&2.into(), &2.into())
    );
    assert_eq!(read(&out).pixel(2, 2), Some([0; 3]));
    assert_ne!(read(&out).pixel(1, 2), Some([0; 3]));
}
