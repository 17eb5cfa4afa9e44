//! `cargo xtask figures`, run as a program.

use ombrage::{FIGURES, Figure, Level, Picture, Scalar, Size};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// The colour that marks acne in `annotated/fig3a.png`.
const YELLOW: [u8; 3] = [240, 228, 66];

fn command(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.arg("figures").args(args);
    command
}

fn run(args: &[&str]) -> Output {
    command(args).output().expect("the program starts")
}

/// Runs in a directory; the command must succeed.
fn write_to(directory: &Path, args: &[&str]) -> String {
    let out = directory.to_str().expect("a path in UTF-8");
    let output = run(&[&["--out", out], args].concat());
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{args:?}: {errors}");
    assert_eq!(errors, "");
    String::from_utf8(output.stdout).expect("UTF-8")
}

fn read(path: &Path) -> Picture {
    let file = fs::File::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let decoder = png::Decoder::new(std::io::BufReader::new(file));
    let mut reader = decoder.read_info().expect("a PNG");
    let size = Size::new(reader.info().width, reader.info().height).expect("a size");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    reader.next_frame(&mut bytes).expect("pixels");
    Picture::new(size, &bytes).expect("RGB")
}

/// Every file below a directory with its bytes, sorted.
fn files(directory: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut found = vec![];
    for entry in fs::read_dir(directory).expect("a directory") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(files(&path));
        } else {
            let bytes = fs::read(&path).expect("a file");
            found.push((path, bytes));
        }
    }
    found.sort();
    found
}

fn names(directory: &Path) -> Vec<String> {
    let relative = |path: &Path| {
        let path = path.strip_prefix(directory).expect("inside");
        path.to_string_lossy().replace('\\', "/")
    };
    files(directory)
        .iter()
        .map(|(path, _)| relative(path))
        .collect()
}

fn equals_draw<S: Scalar>(width: u32, height: u32) {
    let directory = TempDir::new().expect("a directory");
    let size = Size::new(width, height).expect("a size");
    write_to(
        directory.path(),
        &["--size", &format!("{width}x{height}"), "--float", S::NAME],
    );
    for figure in &FIGURES {
        let written = read(&directory.path().join(format!("fig{}.png", figure.name)));
        let drawn = figure.draw::<S>(size).expect("a figure");
        assert!(
            written == drawn,
            "{} at {width}x{height} {}",
            figure.name,
            S::NAME
        );
    }
    assert_eq!(
        names(directory.path()),
        [
            "annotated/fig2a.png",
            "annotated/fig2b.png",
            "annotated/fig3a.png",
            "annotated/fig3b.png",
            "annotated/fig3c.png",
            "fig1.png",
            "fig2a.png",
            "fig2b.png",
            "fig3a.png",
            "fig3b.png",
            "fig3c.png",
        ]
    );
}

#[test]
fn plain_files_hold_exactly_the_pixels() {
    equals_draw::<f32>(600, 400);
    for (width, height) in [(1, 1), (7, 5), (320, 213), (1, 300), (300, 1)] {
        equals_draw::<f32>(width, height);
        equals_draw::<f64>(width, height);
    }
}

#[test]
fn sheets_show_the_figure_and_mark_only_acne() {
    let directory = TempDir::new().expect("a directory");
    write_to(directory.path(), &[]);
    let sheet = |name: &str| read(&directory.path().join("annotated").join(name));
    let figure = Figure::named("3a").expect("a figure");
    let survey = figure.survey::<f32>(Size::LAB).expect("a survey");
    let drawn = figure.draw::<f32>(Size::LAB).expect("a picture");
    let marked = sheet("fig3a.png");
    let (mut shown, mut acne) = (0, 0);
    for y in 0..400 {
        for x in 0..600 {
            let pixel = survey.pixels()[(600 * y + x) as usize];
            let expected = if pixel.is_acne() {
                acne += 1;
                Some(YELLOW)
            } else {
                drawn.pixel(x, y)
            };
            shown += u32::from(marked.pixel(x, y) == expected);
            let is_yellow = marked.pixel(x, y) == Some(YELLOW);
            assert!(!is_yellow || pixel.is_acne(), "({x}, {y}) is marked");
        }
    }
    assert!(acne > 80_000, "{acne} pixels are acne");
    // Frames and leaders hide the others.
    assert!(
        shown > 236_000,
        "{shown} of 240000 pixels show what they should"
    );
    let drawn = Figure::named("2b").and_then(|f| f.draw::<f32>(Size::LAB).ok());
    let drawn = drawn.expect("a picture");
    let sheet = sheet("fig2b.png");
    for y in 150..400 {
        for x in 0..600 {
            assert_eq!(sheet.pixel(x, y), drawn.pixel(x, y), "({x}, {y})");
        }
    }
}

#[test]
fn json_has_the_counts_of_the_survey() {
    let directory = TempDir::new().expect("a directory");
    let text = write_to(
        directory.path(),
        &["--json", "--size", "120x80", "--float", "f64"],
    );
    let report: Value = serde_json::from_str(&text).expect("JSON");
    let rows = report["figures"].as_array().expect("an array");
    assert_eq!(rows.len(), 6);
    for (row, figure) in rows.iter().zip(&FIGURES) {
        let size = Size::new(120, 80).expect("a size");
        let counts = figure.survey::<f64>(size).expect("a survey").counts();
        assert_eq!(row["name"], figure.name);
        assert_eq!(row["float"], "f64");
        assert_eq!((&row["width"], &row["height"]), (&120.into(), &80.into()));
        let path = PathBuf::from(row["file"].as_str().expect("a path"));
        assert_eq!(
            path,
            directory.path().join(format!("fig{}.png", figure.name))
        );
        let ms = row["ms"].as_f64().expect("a number");
        let ns = row["ns_per_pixel"].as_f64().expect("a number");
        assert!(ms > 0.0 && (ns - ms * 1e6 / 9600.0).abs() < 1e-6 * ns);
        for (key, count) in [
            ("sphere", counts.sphere),
            ("plane", counts.plane),
            ("shadowed", counts.shadowed),
            ("wrapped", counts.wrapped),
            ("acne_plane", counts.acne_plane),
            ("acne_sphere", counts.acne_sphere),
        ] {
            assert_eq!(row[key], count, "{key} of {}", figure.name);
        }
        assert_eq!(row.as_object().expect("an object").len(), 13);
    }
    assert!(rows[1]["wrapped"].as_u64() > Some(0) && rows[2]["wrapped"] == 0);
    assert!(rows[3]["acne_plane"].as_u64() > Some(0) && rows[5]["acne_plane"] == 0);
}

#[test]
fn only_writes_the_chosen_figures_in_the_labs_order() {
    let directory = TempDir::new().expect("a directory");
    let table = write_to(directory.path(), &["--only", "3c, 1", "--size", "30x20"]);
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 4, "{table}");
    assert!(
        lines[0].starts_with("figure") && lines[2].starts_with("1 ") && lines[3].starts_with("3c ")
    );
    let written = ["annotated/fig3c.png", "fig1.png", "fig3c.png"];
    assert_eq!(names(directory.path()), written);
}

#[test]
fn check_names_what_is_stale_or_missing_and_writes_nothing() {
    let directory = TempDir::new().expect("a directory");
    let out = directory.path().to_str().expect("UTF-8");
    let size = ["--size", "60x40", "--out", out];
    write_to(directory.path(), &size[..2]);
    let check = || run(&[&size[..], &["--check"]].concat());
    assert_eq!(check().status.code(), Some(0));

    let stale = directory.path().join("fig2b.png");
    fs::copy(directory.path().join("fig2a.png"), &stale).expect("a copy");
    let broken = directory.path().join("annotated").join("fig2a.png");
    fs::write(&broken, "no picture").expect("a file");
    let missing = directory.path().join("annotated").join("fig3c.png");
    fs::remove_file(&missing).expect("removed");
    let before = files(directory.path());
    let output = check();
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(
        text.contains(&format!("{} is stale", stale.display())),
        "{text}"
    );
    assert!(
        text.contains(&format!("{} is missing", missing.display())),
        "{text}"
    );
    assert!(text.contains(&broken.display().to_string()), "{text}");
    assert_eq!(text.lines().count(), 4, "{text}");
    assert_eq!(files(directory.path()), before);
}

#[test]
fn committed_figures_are_fresh() {
    // From a directory inside the workspace, as a person might call it.
    let output = command(&["--check"]).current_dir("src").output();
    let output = output.expect("the program starts");
    let text = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{text}");
}

#[test]
fn bad_input_is_one_line_and_status_2() {
    let directory = TempDir::new().expect("a directory");
    let path = |name: &str| directory.path().join(name).to_string_lossy().into_owned();
    write_to(directory.path(), &["--size", "30x20"]);
    fs::write(path("file"), "").expect("a file");
    fs::create_dir_all(path("taken/fig2a.png")).expect("a directory");
    let before = files(directory.path());
    let out = path("");
    for (args, names) in [
        (vec!["--only", ""], "1,2a,2b,3a,3b,3c"),
        (vec!["--only", "3a,9z"], "'9z'"),
        (vec!["--float", "f16"], "f16"),
        (vec!["--size", "0x5"], "0x5"),
        (vec!["--size", "20000x20000"], "2^28"),
        (vec!["--size", "99999999999x1"], "600x400"),
        (vec!["--size", "600"], "600x400"),
        (vec!["--out", &path("file")], "is a file"),
        (vec!["--out", &path("file/below")], "is a file"),
        (vec!["--out", &path("taken")], "fig2a.png"),
        (vec!["--out", ""], "--out"),
        (vec!["--check", "--json"], "--json"),
        (vec!["--nonsense"], "--nonsense"),
    ] {
        let size = if args.contains(&"--size") {
            vec![]
        } else {
            vec!["--size", "31x20"]
        };
        let place = if args.contains(&"--out") {
            vec![]
        } else {
            vec!["--out", &out]
        };
        let output = run(&[args.clone(), size, place].concat());
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {errors}");
        assert_eq!(errors.lines().count(), 1, "{args:?}: {errors}");
        assert!(
            errors.starts_with("error: ") && errors.contains(names),
            "{args:?}: {errors}"
        );
        assert!(output.stdout.is_empty());
    }
    assert_eq!(files(directory.path()), before);
}

#[cfg(unix)]
#[test]
fn a_file_that_cannot_be_finished_leaves_the_old_ones() {
    let directory = TempDir::new().expect("a directory");
    let out = directory.path().to_str().expect("UTF-8");
    write_to(directory.path(), &["--size", "30x20"]);
    let before = files(directory.path());
    // Files may have 8 KiB here: a disk that fills up in the middle of one.
    let limited = "ulimit -f 16; trap '' XFSZ; exec \"$0\" figures --out \"$1\"";
    let output = Command::new("sh")
        .args(["-c", limited, env!("CARGO_BIN_EXE_xtask"), out])
        .output()
        .expect("a shell");
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{errors}");
    assert!(
        errors.contains("cannot write") && errors.lines().count() == 1,
        "{errors}"
    );
    assert_eq!(files(directory.path()), before);
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_the_old_files_and_nothing_else() {
    use std::thread::sleep;
    use std::time::{Duration, Instant};

    let directory = TempDir::new().expect("a directory");
    let out = directory.path().to_str().expect("UTF-8");
    write_to(directory.path(), &["--size", "30x20"]);
    let before = files(directory.path());
    let mut child = command(&["--size", "2400x1600", "--out", out])
        .spawn()
        .expect("the program starts");
    let start = Instant::now();
    while names(directory.path()).len() == before.len() {
        assert!(
            start.elapsed() < Duration::from_secs(120),
            "no file was begun"
        );
        sleep(Duration::from_millis(1));
    }
    let kill = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(kill.expect("kill starts").success());
    let status = child.wait().expect("an end");
    assert_eq!(status.code(), Some(130));
    assert_eq!(files(directory.path()), before);
}

#[test]
fn help_teaches() {
    let output = run(&["--help"]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success() && text.contains("Examples:") && text.contains("--check"));
    let bare = Command::new(env!("CARGO_BIN_EXE_xtask"))
        .output()
        .expect("the program starts");
    let text = String::from_utf8_lossy(&bare.stdout).into_owned();
    assert!(bare.status.success() && text.contains("figures"), "{text}");
}

#[test]
fn every_level_and_thread_count_draws_the_same_files() {
    let expected = TempDir::new().expect("a directory");
    write_to(expected.path(), &["--size", "61x41"]);
    let bytes = |directory: &Path| -> Vec<Vec<u8>> {
        let found = files(directory).into_iter();
        found.map(|(_, bytes)| bytes).collect()
    };
    for level in Level::ALL {
        let args = ["--size", "61x41", "--level", level.name(), "--threads", "3"];
        if level.is_available() {
            let found = TempDir::new().expect("a directory");
            write_to(found.path(), &args);
            assert!(bytes(expected.path()) == bytes(found.path()), "{level}");
        } else {
            let output = run(&args);
            let errors = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(2), "{errors}");
            assert!(errors.contains("must be auto, scalar"), "{errors}");
        }
    }
}
