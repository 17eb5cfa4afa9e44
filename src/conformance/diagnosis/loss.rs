//! What a file format takes from a picture.

/// What writing a picture to a file and reading it back does to its bytes.
///
/// Hypotheses go through the same loss as the picture did, so that it never counts as a fault.
pub trait Loss: Sync {
    /// Changes the pixels of a picture, or of a part of it whose edges are multiples of 16, as the
    /// file format does. `pixels` is row-major.
    fn degrade(&self, width: u32, height: u32, pixels: &mut [[u8; 3]]);

    /// How far off a byte may still be, for a conforming picture: 0 where nothing is lost.
    fn tolerance(&self) -> u8;
}

/// No loss: PNG, PPM, BMP.
#[derive(Clone, Copy, Debug, Default)]
pub struct Lossless;

impl Loss for Lossless {
    fn degrade(&self, _: u32, _: u32, _: &mut [[u8; 3]]) {}

    fn tolerance(&self) -> u8 {
        0
    }
}
