//! `cargo xtask explain`: its numbers are those of the pictures, its truth is that of another
//! method, and all of it fits a screen.

use ombrage::conformance::{Drawing, Loss, explain};
use ombrage::{FIGURES, Figure, Integrator, Quality, Shadow, Size, lab};
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};
use xtask::case::{self, direct};
use xtask::truth;

fn run(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.arg("explain").args(arguments);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    command.current_dir(root).output().expect("it starts")
}

fn text(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&text(&[arguments, &["--json"]].concat())).expect("JSON")
}

fn step<'a>(told: &'a Value, name: &str) -> &'a Value {
    let steps = told["steps"].as_array().expect("an array");
    let mut steps = steps.iter().filter(|step| step["name"] == name);
    steps.next().unwrap_or_else(|| panic!("no {name}"))
}

/// What is explained is what is drawn: both chains' bytes are those of the figures.
#[test]
fn the_bytes_are_those_of_the_figures() {
    for figure in FIGURES.iter().filter(|figure| figure.detail.is_none()) {
        let single = figure.draw::<f32>(Size::LAB).expect("valid");
        let double = figure.draw::<f64>(Size::LAB).expect("valid");
        for pixel in (0..400).map(|i| [(i * 7919) % 600, (i * 104_729) % 400]) {
            let drawing = Drawing {
                size: Size::LAB,
                pixel,
                integrator: figure.integrator,
                film: figure.film,
            };
            let told = explain(&lab::scene().expect("valid"), &lab::view(), &drawing);
            let told = told.expect("valid");
            let [x, y] = pixel;
            assert_eq!(
                Some(told.single.bytes),
                single.pixel(x, y),
                "{} {pixel:?}",
                figure.name
            );
            assert_eq!(
                Some(told.double.bytes),
                double.pixel(x, y),
                "{} {pixel:?}",
                figure.name
            );
            // But for acne, and the border between two bytes, the truth is what f64 computes.
            let near = |(a, b): (&u8, &u8)| a.abs_diff(*b) <= 1 || a.abs_diff(*b) == 255;
            let is_near = told.truth.bytes.iter().zip(&told.double.bytes).all(near);
            assert!(is_near || figure.name == "3a", "{} {pixel:?}", figure.name);
        }
    }
}

/// Which surface is seen, whether it faces the light and what blocks: as [`truth`] has it, which
/// solves for crossings where this compares sides.
#[test]
fn the_truth_is_that_of_another_method() {
    let (mut lit, mut blocked) = (0, 0);
    for case in case::load(&[]).expect("the scenes") {
        let case = case.at_most(40).expect("smaller");
        let alone = case.with_light(0).expect("valid");
        let truths = truth::of(&alone.scene, &case.view, case.size).expect("valid");
        let surfaces = truth::surfaces(&case.scene);
        for (number, truth) in truths.iter().enumerate().step_by(7) {
            if truth.is_undecided() {
                continue;
            }
            let number = number as u32;
            let drawing = Drawing {
                size: case.size,
                pixel: [number % case.size.width(), number / case.size.width()],
                integrator: direct(Quality::Textbook, Some(Shadow::UlpOffset)),
                film: ombrage::Film::Clamp,
            };
            let told = explain(&alone.scene, &case.view, &drawing).expect("valid");
            let seen = told.truth.first.map(|first| surfaces[first.object]);
            let is_lit = told.truth.radiance.0.high() > 0.0
                || told.truth.radiance.1.high() > 0.0
                || told.truth.radiance.2.high() > 0.0;
            let name = format!("{} {:?}", case.name, drawing.pixel);
            assert_eq!(seen, truth.surface, "{name}");
            let Some(from) = told.truth.lights.first() else {
                continue;
            };
            assert_eq!(from.cosine.high() > 0.0, truth.faces_light, "{name}");
            assert_eq!(!from.blockers[0].is_empty(), truth.blocked, "{name}");
            assert_eq!(is_lit, truth.is_lit(), "{name}");
            lit += usize::from(truth.is_lit());
            blocked += usize::from(truth.blocked);
        }
    }
    assert!(lit > 1000 && blocked > 100, "{lit} lit, {blocked} blocked");
}

#[test]
fn all_of_it_fits_a_screen() {
    let scenes = [
        "planet",
        "many125",
        "coincident",
        "base_moved_1e7",
        "far_tele",
        "three_lights",
    ];
    let paths = scenes.map(|name| format!("tests/scenes/{name}.toml"));
    let figures = FIGURES.map(|figure| figure.name.to_owned());
    for scene in figures.iter().chain(&paths) {
        for place in [
            ["0", "0"],
            ["150", "120"],
            ["150", "199"],
            ["151", "60"],
            ["299", "101"],
        ] {
            let text = text(&[&[scene.as_str()], &place[..]].concat());
            let widest = text.lines().map(|line| line.chars().count()).max();
            assert!(widest <= Some(100), "{widest:?}\n{text}");
            assert!(
                text.lines().count() <= 45,
                "{}\n{text}",
                text.lines().count()
            );
        }
    }
}

#[test]
fn acne_is_explained() {
    let told = json(&["3a", "300", "290"]);
    assert_eq!(told["object"], "plane 1");
    assert_eq!(told["bytes"]["truth"], serde_json::json!([142, 0, 0]));
    assert_eq!(told["bytes"]["f32"], serde_json::json!([0, 0, 0]));
    let verdict = |name: &str| {
        let mut all = told["shadows"].as_array().expect("an array").iter();
        all.find(|verdict| verdict["strategy"] == name)
            .expect("it is there")
            .clone()
    };
    assert_eq!(verdict("truth")["f32"], "lit");
    assert_eq!(verdict("self-hitting")["f32"], "acne");
    assert_eq!(verdict("self-hitting")["f64"], "acne");
    assert_eq!(verdict("ulp-offset")["f32"], "lit");
    assert_eq!(verdict("sidedness")["f64"], "lit");
    assert_eq!(
        told["shadows"].as_array().map(Vec::len),
        Some(Shadow::ALL.len() + 2)
    );
    let text = text(&["3a", "300", "290"]);
    assert!(
        text.contains("!acne") && text.contains("by self-hitting: acne in f32"),
        "{text}"
    );
    let cured = json(&["3a", "300", "290", "--shadow", "ulp-offset"]);
    assert_eq!(cured["bytes"]["f32"], serde_json::json!([142, 0, 0]));
}

/// Losses are named where they are: exactly known ones in the lab's scene.
#[test]
fn losses_are_named() {
    let wraps = json(&["2a", "299", "133"]);
    assert_eq!(wraps["wraps"][2], "wrap: 1 x 256 is dropped");
    let clamped = json(&["2b", "299", "133"]);
    assert_eq!(clamped["wraps"][2], Value::Null);
    let lost =
        |told: &Value, name: &str| step(told, name)["lost"].as_str().unwrap_or("").to_owned();
    assert!(
        lost(&wraps, "t sphere 0").starts_with("cancellation"),
        "{wraps}"
    );
    // Row 201 is the first that sees the plane: almost along it.
    let grazing = json(&["1", "20", "201"]);
    assert!(
        lost(&grazing, "t plane 1").starts_with("grazing"),
        "{grazing}"
    );
    assert_eq!(lost(&json(&["1", "20", "390"]), "t plane 1"), "");
    // The columns at which the sphere begins, in the row through its middle.
    let edge = (200..299).find(|x| {
        let told = json(&["1", &x.to_string(), "199"]);
        step(&told, "t sphere 0")["truth"].is_string()
    });
    let edge = edge.expect("the sphere's edge").to_string();
    assert!(lost(&json(&["1", &edge, "199"]), "t sphere 0").starts_with("tangency"));
}

#[test]
fn agreement_counts_ulps_and_bits() {
    let one = json(&["3c", "300", "290"]);
    let exact = step(&one, "o.z");
    assert_eq!(
        exact["agreement"]["f32"],
        serde_json::json!({ "ulps": 0.0, "bits": 24 })
    );
    assert_eq!(
        exact["agreement"]["f64"],
        serde_json::json!({ "ulps": 0.0, "bits": 53 })
    );
    // 290/399, rounded: at most half a unit off, and then all bits but the last agree.
    let sy = step(&one, "sy");
    let digits = "7.268170426065162907268170426";
    assert!(
        sy["truth"]
            .as_str()
            .is_some_and(|truth| truth.starts_with(digits)),
        "{sy}"
    );
    for float in ["f32", "f64"] {
        let ulps = sy["agreement"][float]["ulps"].as_f64().expect("a number");
        assert!(ulps > 0.0 && ulps <= 0.5, "{sy}");
    }
}

#[test]
fn the_enlarged_figure_shows_its_source() {
    let Some(figure) = Figure::named("3b") else {
        panic!("Figure 3(b) is there");
    };
    let [left, top, ..] = figure.detail.expect("a detail").region(Size::LAB);
    let told = json(&["3b", "7", "3"]);
    assert_eq!(told["pixel"], serde_json::json!([left + 2, top + 1]));
}

#[test]
fn a_pixel_outside_is_an_error_of_the_library_too() {
    let drawing = Drawing {
        size: Size::LAB,
        pixel: [600, 0],
        integrator: Integrator::RayCast(Quality::Stable),
        film: ombrage::Film::Clamp,
    };
    let error = explain(&lab::scene().expect("valid"), &lab::view(), &drawing).unwrap_err();
    assert_eq!(error.field, "pixel");
    assert!(Loss::Wrap(1).bits().is_infinite());
}

#[test]
fn bad_input_is_told() {
    for (arguments, message) in [
        (
            &["4", "0", "0"][..],
            "\"4\" is no figure: choose one of 1, 2a",
        ),
        (
            &["1", "600", "0"],
            "X is \"600\": write the column as a whole number from 0 to 599",
        ),
        (&["1", "0", "400"], "Y is \"400\""),
        (&["1", "-1", "0"], "X is \"-1\""),
        (&["1", "1.5", "0"], "X is \"1.5\""),
        (&["1", "0"], "<Y>"),
        (
            &["1", "0", "0", "--shadow", "ulp-offset"],
            "casts no shadow rays",
        ),
        (&["3c", "0", "0", "--shadow", "magic"], "self-hitting"),
        (&["3c", "0", "0", "--light", "3"], "--light 3"),
        (&["no-such.toml", "0", "0"], "no-such.toml"),
        (&["Cargo.toml", "0", "0"], "Cargo.toml:"),
    ] {
        let output = run(arguments);
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?} {error}");
        assert!(
            error.starts_with("error: ") && error.contains(message),
            "{error}"
        );
        assert_eq!(error.lines().count(), 1, "{error}");
        assert!(output.stdout.is_empty());
    }
}
