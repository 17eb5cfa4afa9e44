//! `cargo xtask render`, run as a program: its options, and what it says of bad files.

use ombrage::{Figure, Level, Picture, Shadow, Size};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;
use xtask::picture_file;

const BASE: &str = include_str!("../../tests/scenes/base.toml");

/// A directory that holds `scene.toml`.
struct Place(TempDir);

impl Place {
    fn with(text: impl AsRef<[u8]>) -> Self {
        let place = Self(TempDir::new().expect("a directory"));
        fs::write(place.scene(), text).expect("a file");
        place
    }

    fn scene(&self) -> PathBuf {
        self.0.path().join("scene.toml")
    }

    fn picture(&self) -> PathBuf {
        self.0.path().join("picture.png")
    }

    fn render(&self, args: &[&str]) -> Output {
        render(&self.scene(), &self.picture(), args)
    }

    /// The picture; the command must succeed.
    fn drawn(&self, args: &[&str]) -> Picture {
        let output = self.render(args);
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{args:?}: {errors}");
        assert_eq!(errors, "");
        picture_file::read(&self.picture()).expect("a picture")
    }

    /// The one line of the error; the command must fail with status 2 and write nothing.
    fn refused(&self, args: &[&str]) -> String {
        let error = error(&self.render(args));
        let left: Vec<_> = self.0.path().read_dir().expect("a directory").collect();
        assert_eq!(left.len(), 1, "{left:?}");
        error
    }
}

fn render(scene: &Path, picture: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command
        .arg("render")
        .arg(scene)
        .arg("--out")
        .arg(picture)
        .args(args);
    command.output().expect("the program starts")
}

fn error(output: &Output) -> String {
    let error = String::from_utf8(output.stderr.clone()).expect("UTF-8");
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert_eq!(error.lines().count(), 1, "{error}");
    assert!(output.stdout.is_empty());
    error
}

#[test]
fn the_scene_of_the_lab_becomes_its_figure() {
    let args = ["--shadow", "ulp-offset", "--float", "f32"];
    let figure = Figure::named("3c").expect("a figure");
    let figure = figure.draw::<f32>(Size::LAB).expect("a picture");
    assert!(Place::with(BASE).drawn(&args) == figure);
}

#[test]
fn options_choose_what_is_drawn() {
    let place = Place::with(BASE);
    let whole = place.drawn(&[]);
    assert_eq!(whole.size(), Size::LAB);
    for level in Level::available() {
        for threads in ["1", "5"] {
            let picture = place.drawn(&["--level", level.name(), "--threads", threads]);
            assert!(picture == whole, "{level}, {threads} threads");
        }
    }
    let small = place.drawn(&["--size", "31x17"]);
    assert_eq!((small.size().width(), small.size().height()), (31, 17));
    let acne = place.drawn(&["--shadow", "self-hitting"]);
    let black = |picture: &Picture| {
        let pixels = picture.bytes().chunks_exact(3);
        pixels.filter(|pixel| *pixel == [0; 3]).count()
    };
    assert!(black(&acne) > black(&whole) + 80_000);
    for shadow in Shadow::ALL {
        place.drawn(&[
            "--size",
            "6x4",
            "--shadow",
            &shadow.name(),
            "--quality",
            "wide",
        ]);
    }
}

#[test]
fn rows_in_steps_are_the_rows_at_once() {
    let mut text = BASE.to_owned();
    for i in 0..3000 {
        let x = f64::from(i) * 0.001;
        let center = format!("center = [{x}, -1.9, 3]");
        text += &format!("\n[[sphere]]\n{center}\nradius = 0.1\ncolor = [0, 1, 0]\n");
    }
    let place = Place::with(text);
    let stepped = place.drawn(&["--size", "300x190"]);
    let file = xtask::scene_file::load(&place.scene()).expect("a scene");
    let size = stepped.size();
    let chain =
        ombrage::Relative::<f64>::new(&file.scene, &file.view, size, ombrage::Lighting::Shadowed);
    let whole = ombrage::render(&chain.expect("a chain"), size, ombrage::Film::Clamp);
    assert!(stepped == whole);
}

#[test]
fn json_says_what_was_done() {
    let place = Place::with(BASE);
    let args = [
        "--json",
        "--size",
        "60x40",
        "--shadow",
        "offset=0.01",
        "--float",
        "f32",
    ];
    let output = place.render(&[&args[..], &["--level", "scalar", "--threads", "3"]].concat());
    let row: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(row["name"], "base");
    assert_eq!(
        (row["width"].as_u64(), row["height"].as_u64()),
        (Some(60), Some(40))
    );
    assert_eq!(
        (&row["float"], &row["shadow"]),
        (&"f32".into(), &"offset=0.01".into())
    );
    assert_eq!(
        (&row["level"], &row["threads"]),
        (&"scalar".into(), &3.into())
    );
    assert_eq!(row["quality"], "textbook");
    assert_eq!(row["file"].as_str(), place.picture().to_str());
    let [ms, ns] = ["ms", "ns_per_pixel"].map(|key| row[key].as_f64().expect("a number"));
    assert!(ms > 0.0 && (ns * 2400.0 / 1e6 - ms).abs() < 1e-6 * ms);
}

#[test]
fn unknown_names_list_the_known_ones() {
    let place = Place::with(BASE);
    for (args, expected) in [
        (
            ["--shadow", "magic"],
            "relative, self-hitting, half-open, t-min=0.0001",
        ),
        (
            ["--shadow", "t-min=nan"],
            "t-min= or offset= with another length",
        ),
        (["--quality", "best"], "textbook, stable, wide"),
        (["--quality", "wide"], "--shadow"),
        (["--level", "mmx"], "auto, scalar"),
        (["--float", "f16"], "f32, f64"),
        (["--threads", "0"], "from 1 to 1024"),
        (["--threads", "1000000"], "from 1 to 1024"),
        (["--size", "0x5"], "at least 1x1"),
    ] {
        let error = place.refused(&args);
        assert!(error.contains(expected), "{error}");
    }
    if let Some(missing) = Level::ALL.into_iter().find(|level| !level.is_available()) {
        let error = place.refused(&["--level", missing.name()]);
        assert!(
            error.contains(missing.name()) && error.contains("auto, scalar"),
            "{error}"
        );
    }
    let error = error(&render(&place.scene(), Path::new("picture.jpg"), &[]));
    assert!(error.contains("ends in .png"), "{error}");
}

/// What is wrong, the line, and what the message must contain beside it.
const BAD: [(&str, &str, usize, &str); 33] = [
    ("name = \"base\"\n", "", 1, "no name: write name = \"base\""),
    (
        "name = \"base\"",
        "name = 5",
        2,
        "name is a number, but must be text",
    ),
    ("name = \"base\"", "name = \"\"", 2, "name is \"\""),
    ("name = \"base\"", "name = \"base", 2, "TOML"),
    (
        "t_max = 1000",
        "t_max = 0",
        4,
        "t_max is 0, but must be greater than 0",
    ),
    ("t_max = 1000", "t_max = nan", 4, "t_max is NaN"),
    ("t_max = 1000", "t_max = 1e999", 4, "1e999, too large"),
    (
        "t_max = 1000",
        "t_max = 1000\nt_max = 2",
        5,
        "duplicate key",
    ),
    (
        "t_max = 1000",
        "tmax = 1000",
        4,
        "\"tmax\" is no key of the file: use name",
    ),
    (
        "[0.5, 0.5, 0.5]",
        "[0.5, -1, 0.5]",
        3,
        "background is (0.5, -1, 0.5)",
    ),
    (
        "[camera]",
        "[kamera]",
        6,
        "\"kamera\" is no key of the file",
    ),
    ("[camera]", "[[camera]]", 6, "begin it with [camera]"),
    ("[[sphere]]", "[[sphere]", 16, "write TOML"),
    ("[[sphere]]", "[sphere]", 16, "begin it with [[sphere]]"),
    (
        "position = [0, 0, -2]\n",
        "",
        6,
        "[camera] has no position: write position =",
    ),
    (
        "position = [0, 0, -2]",
        "position = [0, 0]",
        7,
        "a list of 2, but must be three",
    ),
    (
        "position = [0, 0, -2]",
        "position = [0, 0, nan]",
        7,
        "camera position is (0, 0, NaN)",
    ),
    (
        "position = [0, 0, -2]",
        "position = [0, 0, \"-2\"]",
        7,
        "a list with text in it",
    ),
    (
        "look_at = [0, 0, 79]",
        "look_at = [0, 0, -2]",
        8,
        "another point",
    ),
    (
        "up = [0, 1, 0]",
        "up = [0, 0, 1]",
        9,
        "camera up is (0, 0, 1)",
    ),
    ("fov = 60", "fov = 180", 10, "between 0 and 180"),
    (
        "fov = 60",
        "fov = true",
        10,
        "camera fov is true or false, but must be a number",
    ),
    ("width = 600", "width = 0", 12, "picture size is 0x400"),
    (
        "width = 600",
        "width = 6.5",
        13,
        "image width is 6.5, but must be a whole number",
    ),
    ("width = 600", "width = -600", 13, "image width is -600"),
    (
        "radius = 1",
        "radius = 0",
        18,
        "sphere radius is 0, but must be finite and greater",
    ),
    ("radius = 1", "radius = nan", 18, "sphere radius is NaN"),
    (
        "radius = 1\n",
        "",
        16,
        "[[sphere]] has no radius: write radius = 1",
    ),
    (
        "radius = 1",
        "radius = 1979-05-27",
        18,
        "sphere radius is a date",
    ),
    (
        "radius = 1",
        "radius = 1\nmirror = 1",
        19,
        "\"mirror\" is no key of [[sphere]]",
    ),
    (
        "normal = [0, 1, 0]",
        "normal = [0, 0, 0]",
        23,
        "plane normal is (0, 0, 0)",
    ),
    (
        "color = [1, 1, 1]",
        "color = [1, 1, inf]",
        28,
        "light color is (1, 1, inf)",
    ),
    ("power = 100", "power = -100", 29, "light power is -100"),
];

#[test]
fn bad_files_are_refused_with_their_line() {
    for (good, bad, line, expected) in BAD {
        assert!(BASE.contains(good), "{good}");
        let place = Place::with(BASE.replacen(good, bad, 1));
        let error = place.refused(&[]);
        let start = format!("error: {}:{line}: ", place.scene().display());
        assert!(error.starts_with(&start), "{error}: expected line {line}");
        assert!(error.contains(expected), "{error}: expected {expected}");
    }
    let camera = BASE.find("[camera]").expect("a camera")..BASE.find("[image]").expect("a size");
    let mut text = BASE.to_owned();
    text.replace_range(camera, "");
    let error = Place::with(text).refused(&[]);
    assert!(
        error.contains(":1: [camera] is missing: write [camera]"),
        "{error}"
    );
}

#[test]
fn what_is_no_scene_file_is_refused() {
    let error_of = |text: &[u8]| Place::with(text).refused(&[]);
    for (bytes, expected) in [
        (&b""[..], "scene.toml:1: the file has no name"),
        (&[0; 1000], "scene.toml:1: "),
        (b"# a\n# \xff\n", "scene.toml:2: the text is not UTF-8"),
        (b"\x89PNG\r\n\x1a\n", "scene.toml:1: the text is not UTF-8"),
    ] {
        let error = error_of(bytes);
        assert!(error.contains(expected), "{error}");
    }
    assert!(error_of(&vec![b'#'; 200_000_000]).contains("more than 128 MiB"));
    let place = Place::with("");
    let directory = place.0.path();
    let picture = place.picture();
    assert!(error(&render(directory, &picture, &[])).contains("directory"));
    let missing = directory.join("missing.toml");
    assert!(error(&render(&missing, &picture, &[])).contains("cannot read"));
}

#[test]
fn numbers_beyond_f32_are_refused_in_f32_only() {
    let place = Place::with(BASE.replace("radius = 1", "radius = 1e-50"));
    let error = place.refused(&["--float", "f32", "--shadow", "skip-self"]);
    assert!(
        error.contains("in f32, sphere radius is 0") && error.contains("f64"),
        "{error}"
    );
    place.drawn(&["--shadow", "skip-self"]);
}
