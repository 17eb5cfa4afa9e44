//! `cargo xtask check` on pictures that another renderer drew, in the formats people hand in.

#[path = "../../tests/support/naive.rs"]
mod naive;

use naive::Naive;
use ombrage::conformance::diagnosis::{Diagnosis, Verdict};
use ombrage::{Figure, Picture, Size};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;
use xtask::check;

/// A file format.
#[derive(Clone, Copy, Debug)]
enum Format {
    Png,
    /// A quality, and whether chroma is halved: 4:2:0.
    Jpeg(u8, bool),
}

const JPEGS: [Format; 6] = [
    Format::Jpeg(75, true),
    Format::Jpeg(90, true),
    Format::Jpeg(100, true),
    Format::Jpeg(75, false),
    Format::Jpeg(90, false),
    Format::Jpeg(100, false),
];

impl Format {
    fn write(self, naive: &Naive, path: &Path) {
        let (width, height, pixels) = (naive.width, naive.height, naive.draw());
        match self {
            Format::Png => write_png(width, height, pixels, path),
            Format::Jpeg(quality, halved) => {
                use jpeg_encoder::{ColorType, Encoder, SamplingFactor};
                let mut encoder = Encoder::new_file(path, quality).expect("a file");
                encoder.set_sampling_factor(if halved {
                    SamplingFactor::F_2_2
                } else {
                    SamplingFactor::F_1_1
                });
                encoder
                    .encode(&pixels, width as u16, height as u16, ColorType::Rgb)
                    .expect("a JPEG");
            }
        }
    }
}

fn write_png(width: u32, height: u32, pixels: Vec<u8>, path: &Path) {
    let size = Size::new(width, height).expect("a size");
    let picture = Picture::new(size, pixels).expect("three bytes a pixel");
    let file = fs::File::create(path).expect("a file");
    xtask::picture_file::write(&picture, file).expect("a PNG");
}

fn judge(naive: &Naive, figure: &str, format: Format) -> Diagnosis {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path().join("picture");
    format.write(naive, &path);
    let figure = Figure::named(figure).expect("a figure");
    check::judge(&path, figure).expect("a picture").1
}

fn codes(diagnosis: &Diagnosis) -> Vec<&'static str> {
    let findings = diagnosis.findings.iter();
    findings.map(|finding| finding.code.name()).collect()
}

/// Whether a code is what was found, and alone: CLAMPED and SATURATED look alike.
fn is_named(code: &str, diagnosis: &Diagnosis) -> bool {
    let [finding] = &diagnosis.findings[..] else {
        return false;
    };
    finding.code.name() == code || finding.or.is_some_and(|or| or.name() == code)
}

/// Every third fault in another format; all faults in PNG are tests of the library.
#[test]
fn faults_are_named_through_jpeg() {
    let faults = naive::faults(240, 160);
    for (number, (code, figure, naive)) in faults.into_iter().enumerate().step_by(3) {
        let format = JPEGS[number / 3 % 6];
        let found = judge(&naive, figure, format);
        assert!(
            is_named(code, &found),
            "{code} {figure} {format:?}: {:?}",
            codes(&found)
        );
    }
}

#[test]
fn right_pictures_conform_through_jpeg() {
    let figures = ["1", "2a", "2b", "3a", "3c"];
    for (figure, format) in figures.into_iter().zip(&JPEGS) {
        let found = judge(&Naive::figure(figure, 160, 107), figure, *format);
        assert_eq!(
            found.verdict,
            Verdict::Conforms,
            "{figure} {format:?}: {found:?}"
        );
    }
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
    let wrong = Naive {
        shadows: false,
        ..right
    };
    Format::Png.write(&wrong, &at("wrong.png"));
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
    assert!(
        text.contains("NO_SHADOW") && text.contains("conforms"),
        "{text}"
    );
}

#[test]
fn noise_gradients_and_text_are_unknown() {
    let directory = TempDir::new().expect("a directory");
    let mut seed = 1_u32;
    let mut random = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 24) as u8
    };
    let noise: Vec<u8> = (0..3 * 160 * 120).map(|_| random()).collect();
    let gradient = |i: usize| [(i % 160) as u8, (i / 160) as u8, 200];
    let lines = |i: usize| {
        [if (i / 7 + i / 160 / 5).is_multiple_of(3) {
            0
        } else {
            255
        }; 3]
    };
    let smooth = |i: usize| {
        let (x, y) = ((i % 160) as f32 / 20.0, (i / 160) as f32 / 20.0);
        let wave = |k: f32| (127.0 + 60.0 * (x * k).sin() + 60.0 * (y / k + x).cos()) as u8;
        [wave(0.7), wave(1.1), wave(1.9)]
    };
    let pictures = [
        ("noise", noise),
        ("gradient", (0..160 * 120).flat_map(gradient).collect()),
        ("text", (0..160 * 120).flat_map(lines).collect()),
        ("clouds", (0..160 * 120).flat_map(smooth).collect()),
        ("blank", vec![127; 3 * 160 * 120]),
    ];
    for (name, pixels) in pictures {
        let path = directory.path().join(name);
        write_png(160, 120, pixels, &path);
        let figure = Figure::named("3c").expect("a figure");
        let (_, found) = check::judge(&path, figure).expect("a picture");
        assert_eq!(
            found.verdict,
            Verdict::Unknown,
            "{name}: {:?}",
            codes(&found)
        );
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
    write_png(1, 1, vec![1, 2, 3], &at("dot.png"));
    fs::create_dir(at("none")).expect("a directory");
    let cases: [(&[&str], &str); 10] = [
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
            "--annotate is empty",
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
