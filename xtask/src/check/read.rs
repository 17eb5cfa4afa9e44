//! Somebody's picture file as 8-bit RGB.

use super::jpeg::Jpeg;
use crate::error::{Error, Result};
use image::codecs::png::PngDecoder;
use image::{ColorType, DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};
use ombrage::conformance::diagnosis::check_size;
use ombrage::{Picture, Size};
use std::fmt::Display;
use std::fs;
use std::io::Cursor;
use std::path::Path;

/// A picture and what is known of its file.
pub struct Submission {
    /// The picture.
    pub picture: Picture,
    /// `png`, `jpeg`, `bmp` or `pnm`.
    pub format: &'static str,
    /// What the format took from it; `None`: nothing.
    pub loss: Option<Jpeg>,
    /// What was changed to get at 8-bit RGB.
    pub remarks: Vec<&'static str>,
}

/// The largest file that is read, in bytes.
const LARGEST_FILE: u64 = 1 << 28;

/// The memory that decoding may take, in bytes.
const MEMORY: u64 = 1 << 29;

/// Reads a picture.
///
/// # Errors
/// If the file cannot be read, is no picture of the known formats, is animated, damaged, too small
/// or too large.
pub fn read(path: &Path) -> Result<Submission> {
    let failed = |why: &dyn Display| cannot_read(path, why);
    let about = fs::metadata(path).map_err(|error| failed(&error))?;
    if !about.is_file() {
        return Err(failed(&"it is not a file"));
    }
    if about.len() > LARGEST_FILE {
        return Err(failed(
            &"it has more than 2^28 bytes; save it as PNG or scale it down",
        ));
    }
    let bytes = fs::read(path).map_err(|error| failed(&error))?;
    decode(path, &bytes)
}

fn cannot_read(path: &Path, why: &dyn Display) -> Error {
    Error::new(format!("cannot read {}: {why}", path.display()))
}

/// Decodes the bytes of a picture file; `path` is for messages. The size is known, and checked,
/// before memory is taken for the pixels.
///
/// # Errors
/// As [`read`], but for reading the file.
pub fn decode(path: &Path, bytes: &[u8]) -> Result<Submission> {
    let failed = |why: &dyn Display| cannot_read(path, why);
    let format = format_of(bytes).map_err(|why| failed(&why))?;
    let mut remarks = vec![];
    if format == ImageFormat::Png {
        // Before the decoder, which may miss the pixels first.
        if let Some(&[w0, w1, w2, w3, h0, h1, h2, h3]) = bytes.get(16..24) {
            let [width, height] = [[w0, w1, w2, w3], [h0, h1, h2, h3]].map(u32::from_be_bytes);
            let size = Size::new(width, height).map_err(|invalid| failed(&invalid))?;
            check_size(size).map_err(|invalid| failed(&invalid))?;
        }
        let decoder = PngDecoder::new(Cursor::new(bytes)).map_err(|error| failed(&error))?;
        if decoder.is_apng().map_err(|error| failed(&error))? {
            return Err(failed(&"it is animated; save one of its pictures"));
        }
        if bytes.get(25) == Some(&PALETTE) {
            remarks.push("it has a palette: its colours were looked up");
        }
    }
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    limits.max_alloc = Some(MEMORY);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(|error| failed(&error))?;
    let (width, height) = decoder.dimensions();
    let size = Size::new(width, height).map_err(|invalid| failed(&invalid))?;
    check_size(size).map_err(|invalid| failed(&invalid))?;
    remarks.extend(remarks_on(decoder.color_type()));
    let image = DynamicImage::from_decoder(decoder).map_err(|error| failed(&error))?;
    let picture = Picture::new(size, &image.into_rgb8())?;
    let (format, loss) = match format {
        ImageFormat::Png => ("png", None),
        ImageFormat::Bmp => ("bmp", None),
        ImageFormat::Pnm => ("pnm", None),
        _ => {
            let loss = Jpeg::of(bytes).ok_or_else(|| {
                failed(&"its JPEG headers are not those of a grey or a colour picture")
            })?;
            ("jpeg", Some(loss))
        }
    };
    Ok(Submission {
        picture,
        format,
        loss,
        remarks,
    })
}

/// The colour type of PNG files with a palette.
const PALETTE: u8 = 3;

fn format_of(bytes: &[u8]) -> std::result::Result<ImageFormat, &'static str> {
    if bytes.starts_with(b"GIF8") || bytes.get(8..12) == Some(b"WEBP") {
        return Err("GIF and WebP may be animated or lossy; save it as PNG");
    }
    let known = [
        ImageFormat::Png,
        ImageFormat::Jpeg,
        ImageFormat::Bmp,
        ImageFormat::Pnm,
    ];
    image::guess_format(bytes)
        .ok()
        .filter(|format| known.contains(format))
        .ok_or("it is no PNG, JPEG, PPM or BMP picture; save it as PNG")
}

fn remarks_on(color: ColorType) -> Vec<&'static str> {
    let mut remarks = vec![];
    if color.bytes_per_pixel() / color.channel_count() > 1 {
        remarks.push("it has more than 8 bits a component: they were rounded to 8");
    }
    if color.has_alpha() {
        remarks.push("it has an alpha channel, which was left out");
    }
    if !color.has_color() {
        remarks.push("it is grey: its components are all the same");
    }
    remarks
}
