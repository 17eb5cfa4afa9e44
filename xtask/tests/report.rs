//! The report: its numbers are those that are measured, its page shows those of its data and no
//! others, and bad input leaves the old one whole.

use ombrage::Quality;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;
use xtask::case::{self, Case};
use xtask::compare::moved;
use xtask::figures;
use xtask::precision::measure::{errors, families};
use xtask::report::data::{Data, VERSION};
use xtask::report::page::{Pictures, page};
use xtask::report::{clauses, height, measure, proofs};
use xtask::shadows::{self, Strategy};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn committed() -> PathBuf {
    root().join("docs").join("report").join("data.json")
}

fn data() -> Data {
    Data::read(&committed()).expect("the committed data")
}

fn pictures() -> Pictures {
    Pictures::new(figures::draw_all().expect("the figures"))
}

fn report(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.arg("report").args(args).current_dir(root());
    command.output().expect("the program starts")
}

/// Not times, which differ; but counts and errors are the same on every machine.
#[test]
fn a_sample_of_the_numbers_is_what_is_measured_again() {
    let data = data();
    assert!(!data.run.quick, "a quick run is committed");
    for y in [-1.9, -2.0] {
        let again = height::measure_at(y).expect("a scene");
        assert!(data.heights.contains(&again), "{again:?}");
    }
    let truth = moved::truth().expect("a scene");
    let again = moved::measure_at(&truth, 1e5).expect("a scene");
    assert!(data.moved.contains(&again), "{again:?}");
    let scenes = root().join("tests").join("scenes");
    let cases = ["stack5", "planet"].map(|name| Case::read(&scenes.join(format!("{name}.toml"))));
    let cases: Vec<Case> = cases.into_iter().collect::<Result<_, _>>().expect("scenes");
    let bar = indicatif::ProgressBar::hidden();
    let again = shadows::judge(&cases, Quality::Textbook, &bar).expect("scenes");
    assert!(again.len() >= 48, "{} rows", again.len());
    for row in again {
        assert!(data.shadows.contains(&row), "{row:?}");
    }
    let again = proofs::measure(&cases).expect("scenes");
    assert_eq!(again.len(), 6, "four figures and two scenes");
    for row in again {
        assert!(data.proofs.contains(&row), "{row:?}");
    }
    assert_eq!(data.errors, errors().expect("the vectors"));
    assert_eq!(data.families, families().expect("the vectors"));
    assert_eq!(data.quantise, measure::quantise());
    assert!(pictures().are_those_of(&data).is_ok());
}

/// A scene, a strategy, a quality or a clause that is new is in the committed data too.
#[test]
fn nothing_is_left_out() {
    fn set<T: Ord>(of: impl IntoIterator<Item = T>) -> BTreeSet<T> {
        of.into_iter().collect()
    }
    let data = data();
    let renew = "renew docs/report with: cargo xtask report";
    let scenes = case::load(&[]).expect("the scenes");
    let scenes = set(scenes.into_iter().map(|case| case.name));
    let shown = data.shadows.iter().map(|row| row.scene.clone());
    assert_eq!(scenes, set(shown), "{renew}");
    let shown = data.shadows.iter().map(|row| row.strategy.clone());
    let strategies = set(Strategy::all().into_iter().map(Strategy::name));
    assert_eq!(strategies, set(shown), "{renew}");
    let shown = data.costs.iter().map(|row| &*row.quality);
    assert_eq!(set(Quality::ALL.map(Quality::name)), set(shown), "{renew}");
    let clauses = clauses::read(&root().join("docs/spec.md")).expect("the clauses");
    assert_eq!(clauses, data.clauses, "{renew}");
}

/// Findings of the literature that the project rests on: here they are its own.
#[test]
fn what_the_project_rests_on_is_measured() {
    let quantise = measure::quantise();
    assert_eq!((quantise.f32, quantise.f64, quantise.kit), (0, 143, 0));
    let lab = height::measure_at(-2.0).expect("a scene");
    let other = height::measure_at(-1.9).expect("a scene");
    assert_eq!((lab.f32.open, lab.f64.open), (0, 0));
    assert!(other.f32.open > 0 && other.f64.open > 0, "{other:?}");
    assert!(2 * lab.f64.closed > lab.f64.lit, "{lab:?}");
}

/// Other data, another page: no number stands in the page by itself.
#[test]
fn the_page_shows_the_numbers_of_its_data() {
    let (mut data, pictures) = (data(), pictures());
    let before = page(&data, &pictures).expect("a page");
    let marks = [
        "1,234,561",
        "1,234,562",
        "77,771",
        "77,772",
        "1111.1",
        "98.8 ns",
    ];
    assert!(marks.iter().all(|mark| !before.contains(mark)));
    for row in &mut data.shadows {
        if row.strategy == "ulp-offset" {
            row.wrong = shadows::Wrong::default();
        }
    }
    let of = |row: &&mut shadows::Row| row.strategy == "ulp-offset";
    let mut rows = data.shadows.iter_mut().filter(of);
    rows.next().expect("a row").wrong.acne = 1_234_561;
    rows.next().expect("a row").wrong.leak = 1_234_562;
    for row in &mut data.moved {
        (row.f32.lab, row.f32.relative) = (77_771, 77_772);
    }
    for row in &mut data.bench.rows {
        row.ratio_to_lab_way = 1111.1;
    }
    for cost in &mut data.costs {
        cost.ns = 98.76;
    }
    let after = page(&data, &pictures).expect("a page");
    for mark in marks {
        assert!(after.contains(mark), "{mark}");
    }
}

#[test]
fn the_committed_report_is_what_its_data_give() {
    let output = report(&["--check"]);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stdout)
    );
    let size = fs::metadata(committed().with_file_name("index.html"))
        .expect("a page")
        .len();
    assert!(size < 3_000_000, "{size} bytes");
}

/// A directory with an old report, and a file of data.
fn with_data(text: &str) -> (TempDir, String, String) {
    let folder = TempDir::new().expect("a directory");
    for name in ["data.json", "index.html"] {
        fs::write(folder.path().join(name), "old").expect("a file");
    }
    let from = folder.path().join("new.json");
    fs::write(&from, text).expect("a file");
    let text = |path: &Path| path.to_str().expect("Unicode").to_owned();
    let (out, from) = (text(folder.path()), text(&from));
    (folder, out, from)
}

/// The command fails with one line that says why, and the old report is as it was.
fn is_refused(text: &str, why: &[&str]) {
    let (folder, out, from) = with_data(text);
    let output = report(&["--from", &from, "--out", &out]);
    let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{complaint}");
    assert_eq!(complaint.lines().count(), 1, "{complaint}");
    for why in why {
        assert!(complaint.contains(why), "{why}: {complaint}");
    }
    for name in ["data.json", "index.html"] {
        assert_eq!(
            fs::read_to_string(folder.path().join(name)).expect("a file"),
            "old"
        );
    }
    assert_eq!(
        fs::read_dir(folder.path()).expect("a directory").count(),
        3,
        "nothing is left over"
    );
}

#[test]
fn data_that_are_cut_short_or_of_another_version_are_refused() {
    let text = fs::read_to_string(committed()).expect("the committed data");
    is_refused(
        &text[..text.len() / 2],
        &["new.json is cut short", "cargo xtask report"],
    );
    is_refused("", &["cut short"]);
    let (this, other) = (format!("\"version\": {VERSION}"), "\"version\": 4000000000");
    is_refused(
        &text.replacen(&this, other, 1),
        &["version 4000000000", &format!("version {VERSION}")],
    );
    is_refused(
        &format!("{{\"version\": {VERSION}, \"run\": 3}}"),
        &["no data of a report", "line 1"],
    );
    is_refused("<html>", &["no data of a report"]);
    let crc = text.find("\"picture\": ").expect("a checksum") + "\"picture\": ".len();
    let (before, after) = text.split_at(crc);
    let digits = after
        .find(|digit: char| !digit.is_ascii_digit())
        .expect("an end");
    let other = format!("{before}1{}", &after[digits..]);
    is_refused(&other, &["figure 1 is not the one", "cargo xtask report"]);
}

#[test]
fn a_place_that_cannot_be_written_to_is_refused_before_anything_is_measured() {
    let (folder, _, from) =
        with_data(&fs::read_to_string(committed()).expect("the committed data"));
    let file = folder.path().join("index.html");
    let output = report(&["--from", &from, "--out", file.to_str().expect("Unicode")]);
    let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{complaint}");
    assert!(
        complaint.contains("is a file, not a directory"),
        "{complaint}"
    );
    assert_eq!(fs::read_to_string(&file).expect("a file"), "old");
    let missing = report(&["--from", "no-such.json", "--out", "also-missing"]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&missing.stderr).contains("no-such.json"));
    assert!(
        !root().join("also-missing").exists(),
        "a directory is left over"
    );
}
