//! Pictures as PNG files: 8 bits, RGB.

use crate::error::{Error, Result};
use ombrage::{Picture, Size};
use png::{BitDepth, ColorType, Decoder, DeflateCompression, Encoder, EncodingError, Filter};
use std::fs::File;
use std::io::{self, BufReader, BufWriter, Write};
use std::path::Path;

/// Encodes a picture.
///
/// # Errors
/// If `out` does not take the bytes.
pub fn write(picture: &Picture, out: impl Write) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    encode(picture, &mut out).map_err(|error| match error {
        EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    })?;
    out.flush()
}

fn encode(picture: &Picture, out: impl Write) -> std::result::Result<(), EncodingError> {
    let mut encoder = Encoder::new(out, picture.size().width(), picture.size().height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    // Flat colours and noise: both are smallest unfiltered, and the quickest deflate is enough.
    encoder.set_deflate_compression(DeflateCompression::Level(1));
    encoder.set_filter(Filter::NoFilter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(picture.bytes())?;
    writer.finish()
}

/// Decodes the picture of a file.
///
/// # Errors
/// If the file cannot be read, or is anything but a PNG of 8-bit RGB.
pub fn read(path: &Path) -> Result<Picture> {
    let failed =
        |why: &dyn std::fmt::Display| Error::new(format!("cannot read {}: {why}", path.display()));
    let file = File::open(path).map_err(|error| failed(&error))?;
    let mut reader = Decoder::new(BufReader::new(file))
        .read_info()
        .map_err(|error| failed(&error))?;
    let info = reader.info();
    if (info.color_type, info.bit_depth) != (ColorType::Rgb, BitDepth::Eight) {
        return Err(failed(&"it is not an 8-bit RGB picture"));
    }
    let size = Size::new(info.width, info.height)?;
    let mut bytes = vec![0; 3 * size.pixels()];
    reader
        .next_frame(&mut bytes)
        .map_err(|error| failed(&error))?;
    Ok(Picture::new(size, bytes)?)
}
