//! Pictures: bytes with a size.

use crate::error::Invalid;

/// The width and height of a picture in pixels, neither of them 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// The size of every figure: 600 x 400.
    pub const LAB: Size = Size {
        width: 600,
        height: 400,
    };

    /// The largest number of pixels a picture may have: 2^28.
    pub const MOST_PIXELS: u64 = 1 << 28;

    /// A size of `width` x `height`.
    ///
    /// # Errors
    /// If either is 0, or there are more than 2^28 pixels.
    pub fn new(width: u32, height: u32) -> Result<Self, Invalid> {
        let pixels = u64::from(width) * u64::from(height);
        if pixels == 0 || pixels > Self::MOST_PIXELS {
            let value = format!("{width}x{height}");
            let must_be = "at least 1x1 and at most 2^28 pixels";
            return Err(Invalid {
                field: "picture size",
                value,
                must_be,
            });
        }
        Ok(Self { width, height })
    }

    /// Pixels in a row.
    pub fn width(self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(self) -> u32 {
        self.height
    }

    /// Pixels in all.
    pub fn pixels(self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Width over height.
    pub fn aspect(self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }
}

/// An 8-bit RGB picture: width x height x 3 bytes, row-major, the upper left pixel first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    size: Size,
    pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// A picture of these bytes.
    ///
    /// # Errors
    /// If there are not exactly three bytes a pixel.
    pub fn new(size: Size, bytes: &[u8]) -> Result<Self, Invalid> {
        if bytes.len() != 3 * size.pixels() {
            let value = bytes.len().to_string();
            return Err(Invalid {
                field: "picture bytes",
                value,
                must_be: "three for each pixel",
            });
        }
        let (pixels, _) = bytes.as_chunks();
        let pixels = pixels.to_vec();
        Ok(Self { size, pixels })
    }

    /// A picture of these pixels, row-major.
    ///
    /// # Errors
    /// If there are not as many as the size says.
    pub fn from_pixels(size: Size, pixels: Vec<[u8; 3]>) -> Result<Self, Invalid> {
        if pixels.len() != size.pixels() {
            let value = pixels.len().to_string();
            return Err(Invalid {
                field: "picture pixels",
                value,
                must_be: "width x height",
            });
        }
        Ok(Self { size, pixels })
    }

    /// A black picture.
    pub fn black(size: Size) -> Self {
        let pixels = vec![[0; 3]; size.pixels()];
        Self { size, pixels }
    }

    /// Width and height.
    pub fn size(&self) -> Size {
        self.size
    }

    /// The bytes: width x height x 3, row-major.
    pub fn bytes(&self) -> &[u8] {
        self.pixels.as_flattened()
    }

    /// The pixel in column `x` and row `y`, both from 0; `None` outside.
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        if x >= self.size.width {
            return None;
        }
        let place = y as usize * self.size.width as usize + x as usize;
        self.pixels.get(place).copied()
    }

    /// Its pixels to be overwritten, row-major.
    pub(crate) fn pixels_mut(&mut self) -> &mut [[u8; 3]] {
        &mut self.pixels
    }

    /// The picture of this size whose pixel in column x and row y is `pixel(x, y)`.
    pub fn from_fn(size: Size, mut pixel: impl FnMut(u32, u32) -> [u8; 3]) -> Self {
        let mut pixels = Vec::with_capacity(size.pixels());
        for y in 0..size.height {
            for x in 0..size.width {
                pixels.push(pixel(x, y));
            }
        }
        Self { size, pixels }
    }
}
