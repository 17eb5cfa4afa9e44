//! The formats in which people hand pictures in.

use crate::naive::Naive;
use jpeg_encoder::{ColorType, Encoder, SamplingFactor};
use ombrage::{Picture, Size};
use std::fs;
use std::path::Path;

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Png,
    /// A quality, and whether chroma is halved: 4:2:0.
    Jpeg(u8, bool),
}

impl Format {
    pub const ALL: [Format; 7] = [
        Format::Png,
        Format::Jpeg(75, true),
        Format::Jpeg(75, false),
        Format::Jpeg(90, true),
        Format::Jpeg(90, false),
        Format::Jpeg(100, true),
        Format::Jpeg(100, false),
    ];

    pub fn name(self) -> String {
        match self {
            Format::Png => "PNG".to_owned(),
            Format::Jpeg(quality, true) => format!("{quality} 4:2:0"),
            Format::Jpeg(quality, false) => format!("{quality} 4:4:4"),
        }
    }

    /// Draws a picture and writes it.
    pub fn write(self, naive: &Naive, path: &Path) {
        let (width, height, pixels) = (naive.width, naive.height, naive.draw());
        match self {
            Format::Png => write_png(width, height, &pixels, path),
            Format::Jpeg(quality, halved) => {
                let mut encoder = Encoder::new_file(path, quality).expect("a file");
                encoder.set_sampling_factor(if halved {
                    SamplingFactor::F_2_2
                } else {
                    SamplingFactor::F_1_1
                });
                let [width, height] = [width, height].map(|n| u16::try_from(n).expect("a side"));
                let written = encoder.encode(&pixels, width, height, ColorType::Rgb);
                written.expect("a JPEG");
            }
        }
    }
}

/// Writes three bytes a pixel as PNG.
pub fn write_png(width: u32, height: u32, pixels: &[u8], path: &Path) {
    let size = Size::new(width, height).expect("a size");
    let picture = Picture::new(size, pixels).expect("three bytes a pixel");
    let file = fs::File::create(path).expect("a file");
    xtask::picture_file::write(&picture, file).expect("a PNG");
}
