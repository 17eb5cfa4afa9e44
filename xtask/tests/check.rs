//! `cargo xtask check` on pictures that another renderer drew, in the formats people hand in.

#[path = "../../tests/support/faults.rs"]
mod faults;
#[path = "../../tests/support/naive.rs"]
mod naive;

mod support {
    pub mod format;
    pub mod scenery;
}

use naive::Naive;
use ombrage::Figure;
use ombrage::conformance::diagnosis::{Diagnosis, Verdict};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use support::format::{Format, write_png};
use tempfile::TempDir;
use xtask::{check, parallel};

fn codes(diagnosis: &Diagnosis) -> Vec<&'static str> {
    let findings = diagnosis.findings.iter();
    findings.map(|finding| finding.code.name()).collect()
}

fn run(arguments: &[&str], directory: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_xtask"))
        .arg("check")
        .args(arguments)
        .current_dir(directory)
        .output()
        .expect("the program starts")
}

#[test]
fn exit_codes_json_table_and_annotation() {
    let directory = TempDir::new().expect("a directory");
    let at = |name: &str| directory.path().join(name);
    let right = Naive::figure("3c", 120, 80);
    Format::Png.write(&right, &at("right.png"));
    let faults = faults::faults(120, 80);
    let wrong = faults.iter().find(|(code, ..)| *code == "NO_SHADOW");
    let (.., wrong) = wrong.expect("a fault");
    Format::Png.write(wrong, &at("wrong.png"));
    for format in Format::ALL {
        format.write(
            &right,
            &at(&format!("{}.jpg", format.name().replace(':', "-"))),
        );
    }
    let status = |arguments: &[&str]| {
        let output = run(arguments, directory.path());
        (
            output.status.code(),
            String::from_utf8(output.stdout).expect("UTF-8"),
        )
    };
    let (code, text) = status(&["right.png", "--figure", "3c"]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.starts_with("conforms"), "{text}");
    let (code, text) = status(&[
        "wrong.png",
        "--figure",
        "3c",
        "--json",
        "--annotate",
        "m.png",
    ]);
    assert_eq!(code, Some(1), "{text}");
    let report: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(report["verdict"], "faults");
    let finding = &report["findings"][0];
    assert_eq!(finding["code"], "NO_SHADOW");
    assert_eq!(finding["clause"], "4.1");
    assert!(
        finding["pixels"]
            .as_u64()
            .is_some_and(|pixels| pixels > 100),
        "{finding}"
    );
    assert!(
        report["shown"]
            .as_array()
            .is_some_and(|shown| shown.contains(&"3.3".into()))
    );
    assert!(
        report["not_shown"]
            .as_array()
            .is_some_and(|hidden| hidden.contains(&"5.1".into()))
    );
    assert!(xtask::picture_file::read(&at("m.png")).is_ok());
    let (code, text) = status(&[".", "--figure", "3c"]);
    assert_eq!(code, Some(1), "{text}");
    assert_eq!(text.matches("conforms").count(), 8, "{text}");
    assert!(text.contains("NO_SHADOW"), "{text}");
}

/// Photographs, noise, text, drawings: nothing explains them.
#[test]
fn other_peoples_pictures_are_unknown() {
    let directory = TempDir::new().expect("a directory");
    let pictures = support::scenery::pictures(150, 100);
    let figures = ["1", "2a", "2b", "3a", "3c"];
    let numbered: Vec<_> = pictures.iter().enumerate().collect();
    let verdicts = parallel::map(&numbered, |(number, (name, pixels))| {
        let path = directory.path().join(name);
        write_png(150, 100, pixels, &path);
        let figure = figures[number % figures.len()];
        let (_, found) = check::judge(&path, Figure::named(figure).expect("a figure"))?;
        Ok((name, figure, found))
    });
    for (name, figure, found) in verdicts.expect("pictures") {
        let codes = codes(&found);
        assert_eq!(
            found.verdict,
            Verdict::Unknown,
            "{name} as {figure}: {codes:?}"
        );
    }
}

/// Every scene of the kit but the lab's own: another scene, or one that a fault of the lab's makes
/// as well.
#[test]
fn other_scenes_are_no_figure() {
    let directory = TempDir::new().expect("a directory");
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/scenes");
    for (scene, verdict) in [
        ("planet", Verdict::Faults),
        ("stack5", Verdict::Faults),
        ("plane_y-2.1", Verdict::Faults),
        ("plane_tilted", Verdict::Faults),
        ("many125", Verdict::Unknown),
        ("contact_tiny", Verdict::Faults),
        ("base_moved_1e5", Verdict::Conforms),
    ] {
        let path = directory.path().join(format!("{scene}.png"));
        let output = Command::new(env!("CARGO_BIN_EXE_xtask"))
            .args(["render", "--size", "240x160", "--out"])
            .arg(&path)
            .arg(scenes.join(format!("{scene}.toml")))
            .output()
            .expect("the program starts");
        assert!(output.status.success(), "{output:?}");
        let figure = Figure::named("3c").expect("a figure");
        let (_, found) = check::judge(&path, figure).expect("a picture");
        assert_eq!(found.verdict, verdict, "{scene}: {:?}", codes(&found));
        if verdict == Verdict::Faults {
            assert_eq!(codes(&found), ["OTHER_SCENE"], "{scene}");
        }
    }
}

/// A PNG's first 33 bytes, for a picture of any size.
fn png_header(width: u32, height: u32) -> Vec<u8> {
    let mut chunk = b"IHDR".to_vec();
    chunk.extend(width.to_be_bytes());
    chunk.extend(height.to_be_bytes());
    chunk.extend([8, 2, 0, 0, 0]);
    let mut crc = u32::MAX;
    for byte in &chunk {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = if crc & 1 == 1 {
                crc >> 1 ^ 0xedb8_8320
            } else {
                crc >> 1
            };
        }
    }
    let mut bytes = b"\x89PNG\r\n\x1a\n\0\0\0\x0d".to_vec();
    bytes.extend(chunk);
    bytes.extend((!crc).to_be_bytes());
    bytes
}

#[test]
fn bad_input_is_named_in_a_line() {
    let directory = TempDir::new().expect("a directory");
    let at = |name: &str| directory.path().join(name);
    Format::Png.write(&Naive::figure("3c", 64, 40), &at("right.png"));
    let whole = fs::read(at("right.png")).expect("a file");
    fs::write(at("cut.png"), &whole[..whole.len() / 2]).expect("a file");
    fs::write(at("words.png"), "no picture").expect("a file");
    fs::write(at("empty.png"), "").expect("a file");
    fs::write(at("huge.png"), png_header(100_000, 100_000)).expect("a file");
    fs::write(at("moving.gif"), b"GIF89a\x01\0\x01\0").expect("a file");
    write_png(1, 1, &[1, 2, 3], &at("dot.png"));
    fs::create_dir(at("none")).expect("a directory");
    let cases: [(&[&str], &str); 11] = [
        (&["cut.png", "--figure", "3c"], "cut.png"),
        (&["words.png", "--figure", "3c"], "save it as PNG"),
        (&["empty.png", "--figure", "3c"], "save it as PNG"),
        (&["huge.png", "--figure", "3c"], "100000x100000"),
        (&["moving.gif", "--figure", "3c"], "animated"),
        (&["dot.png", "--figure", "3c"], "1x1"),
        (&["none", "--figure", "3c"], "holds no pictures"),
        (&["missing.png", "--figure", "3c"], "missing.png"),
        (&["right.png", "--figure", "3b"], "1, 2a, 2b, 3a, 3c"),
        (
            &["right.png", "--figure", "3c", "--annotate", ""],
            "a name that ends in .png",
        ),
        (
            &["right.png", "--figure", "3c", "--annotate", "marked.jpg"],
            "a name that ends in .png",
        ),
    ];
    for (arguments, words) in cases {
        let output = run(arguments, directory.path());
        let text = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
        assert_eq!(text.lines().count(), 1, "{arguments:?}: {text}");
        assert!(text.contains(words), "{arguments:?}: {text}");
    }
}
