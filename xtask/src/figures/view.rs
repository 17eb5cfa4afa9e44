//! How large a picture stands on an annotated sheet.

use crate::draw::Area;
use ombrage::{Picture, Size};

/// The most columns or rows a sheet shows; larger pictures are shown by every second, third ... pixel.
const MOST: u32 = 4096;

/// The size for which sheets are laid out: one unit is one pixel there.
const DESIGN: [u32; 2] = [600, 400];

/// Small pictures are enlarged with hard pixels, very large ones thinned out, so that what is written
/// beside them can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    /// Every how many pixels, across and down, one is shown.
    pub every: u32,
    /// How many canvas pixels wide and high each shown pixel is.
    pub enlarged: u32,
    /// The shown columns and rows.
    pub shown: Size,
}

impl View {
    /// The view of a picture of this size.
    pub fn of(size: Size) -> Self {
        let every = size.width().max(size.height()).div_ceil(MOST);
        let [across, down] = [size.width(), size.height()].map(|n| f64::from(n.div_ceil(every)));
        let fits = (f64::from(DESIGN[0]) / across).min(f64::from(DESIGN[1]) / down);
        let enlarged = (fits.round() as u32).max(1);
        let shown = thinned(size, every);
        Self {
            every,
            enlarged,
            shown,
        }
    }

    /// The columns and rows it takes on a canvas.
    pub fn canvas_size(&self) -> [u32; 2] {
        [self.shown.width(), self.shown.height()].map(|n| n * self.enlarged)
    }

    /// The layout's unit in canvas pixels: 1 at the design's size, and never less.
    pub fn unit(&self) -> f32 {
        let [width, height] = self.canvas_size();
        let [across, down] = [
            width as f32 / DESIGN[0] as f32,
            height as f32 / DESIGN[1] as f32,
        ];
        across.min(down).max(1.0)
    }

    /// The pixels of a picture that are shown.
    pub fn thin_out(&self, picture: Picture) -> Picture {
        if self.every == 1 {
            return picture;
        }
        Picture::from_fn(self.shown, |x, y| {
            let pixel = picture.pixel(x * self.every, y * self.every);
            pixel.unwrap_or_default()
        })
    }

    /// The part of `across` x `down` shown pixels around a place given in hundredths of the picture.
    pub fn part(&self, percent: [u32; 2], across: u32, down: u32) -> Area {
        let [columns, rows] = [self.shown.width(), self.shown.height()];
        let (width, height) = (across.min(columns), down.min(rows));
        let start = |percent: u32, whole: u32, part: u32| {
            (whole * percent / 100)
                .saturating_sub(part / 2)
                .min(whole - part)
        };
        Area {
            left: start(percent[0], columns, width),
            top: start(percent[1], rows, height),
            width,
            height,
        }
    }
}

/// The size of every `every`th column and row. It exists, since a picture's size does.
fn thinned(size: Size, every: u32) -> Size {
    Size::new(size.width().div_ceil(every), size.height().div_ceil(every)).unwrap_or(size)
}
