//! `cargo xtask check` on pictures that another renderer drew, in the formats people hand in.

#[path = "../../tests/support/naive.rs"]
mod naive;

use naive::Naive;
use ombrage::Figure;
use ombrage::conformance::diagnosis::{Diagnosis, Verdict};
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use xtask::check;

/// The formats of the table: a name, and what writes the file.
const FORMATS: [Format; 7] = [
    Format::Png,
    Format::Jpeg(75, true),
    Format::Jpeg(90, true),
    Format::Jpeg(100, true),
    Format::Jpeg(75, false),
    Format::Jpeg(90, false),
    Format::Jpeg(100, false),
];

#[derive(Clone, Copy, Debug)]
enum Format {
    Png,
    /// A quality, and whether chroma is halved: 4:2:0.
    Jpeg(u8, bool),
}

impl Format {
    fn name(self) -> String {
        match self {
            Format::Png => "png".into(),
            Format::Jpeg(quality, true) => format!("jpeg {quality} 4:2:0"),
            Format::Jpeg(quality, false) => format!("jpeg {quality} 4:4:4"),
        }
    }

    fn write(self, naive: &Naive, path: &Path) {
        let (width, height, pixels) = (naive.width, naive.height, naive.draw());
        match self {
            Format::Png => {
                let size = ombrage::Size::new(width, height).expect("a size");
                let picture = ombrage::Picture::new(size, pixels).expect("bytes");
                let file = fs::File::create(path).expect("a file");
                xtask::picture_file::write(&picture, file).expect("a PNG");
            }
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

fn judge(naive: &Naive, figure: &str, format: Format) -> Diagnosis {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path().join("picture");
    format.write(naive, &path);
    let figure = Figure::named(figure).expect("a figure");
    check::judge(&path, figure).expect("a picture").1
}

fn codes(diagnosis: &Diagnosis) -> Vec<&'static str> {
    diagnosis
        .findings
        .iter()
        .map(|finding| finding.code.name())
        .collect()
}

#[test]
#[ignore = "long"]
fn experiment() {
    let want: String = std::env::var("WANT").unwrap_or_default();
    let size: Vec<u32> = std::env::var("SIZE")
        .unwrap_or("320x213".into())
        .split('x')
        .map(|s| s.parse().unwrap())
        .collect();
    let mut bad = 0;
    for (code, figure, naive) in naive::faults(size[0], size[1]) {
        if !want.is_empty() && !format!("{code} {figure}").contains(&want) {
            continue;
        }
        for format in FORMATS {
            let start = std::time::Instant::now();
            let d = judge(&naive, figure, format);
            let ok = codes(&d) == [code] || code == "SATURATED" && codes(&d) == ["CLAMPED"];
            bad += u32::from(!ok);
            println!(
                "{code:18} {figure} {:15} {:9} {:?} margin {:.3} ({:.3} {:?} {:.3}) {:?} {:?} {}",
                format.name(),
                d.verdict.name(),
                codes(&d),
                d.margin.share(),
                d.margin.error,
                d.margin.runner_up,
                d.margin.runner_up_error,
                start.elapsed(),
                d.findings.iter().map(|f| &f.estimates).collect::<Vec<_>>(),
                if ok { "" } else { "<<<<<<" }
            );
        }
    }
    println!("BAD {bad}");
}

#[test]
#[ignore = "long"]
fn experiment_right() {
    let size: Vec<u32> = std::env::var("SIZE")
        .unwrap_or("320x213".into())
        .split('x')
        .map(|s| s.parse().unwrap())
        .collect();
    for figure in ["1", "2a", "2b", "3a", "3c"] {
        for (i, (words, naive)) in naive::conventions(figure, size[0], size[1])
            .into_iter()
            .enumerate()
        {
            for (j, format) in FORMATS.into_iter().enumerate() {
                if j > 0 && i % 7 != j {
                    continue;
                }
                let d = judge(&naive, figure, format);
                println!(
                    "{figure} {words:40} {:15} {:9} {:?} {:?} {:?} {}",
                    format.name(),
                    d.verdict.name(),
                    codes(&d),
                    d.conventions,
                    d.margin,
                    if d.verdict == Verdict::Conforms {
                        ""
                    } else {
                        "<<<<<<"
                    }
                );
            }
        }
    }
}
