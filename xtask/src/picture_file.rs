//! Pictures as PNG files: 8 bits, RGB.

use crate::error::{Error, Result};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use ombrage::{Picture, Size};
use png::{BitDepth, ColorType, Decoder, Encoder, EncodingError, chunk};
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

/// The scanlines are deflated many at a time, and not by the encoder, which hands them over one by
/// one: that would clear the compressor's output buffer twice a row.
fn encode(picture: &Picture, out: impl Write) -> std::result::Result<(), EncodingError> {
    const LINES_AT_A_TIME: usize = 64;
    /// Flat colours and noise: both are smallest unfiltered, and the quickest deflate is enough.
    const UNFILTERED: u8 = 0;
    let (width, height) = (picture.size().width(), picture.size().height());
    let mut encoder = Encoder::new(out, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    let mut deflated = ZlibEncoder::new(vec![], Compression::fast());
    let lines = picture.bytes().chunks_exact(3 * width as usize);
    let mut some = vec![];
    for (row, line) in (1..).zip(lines) {
        some.push(UNFILTERED);
        some.extend_from_slice(line);
        if row % LINES_AT_A_TIME == 0 || row == height as usize {
            deflated.write_all(&some)?;
            some.clear();
        }
    }
    writer.write_chunk(chunk::IDAT, &deflated.finish()?)?;
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
    Ok(Picture::new(size, &bytes)?)
}
