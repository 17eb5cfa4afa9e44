//! What is drawn on.

use super::palette::{Color, PAPER};
use super::text::{self, Weight};
use crate::error::{Error, Result};
use ombrage::{Picture, Size};
use tiny_skia::{FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, Transform};

/// A rectangle of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    /// Its first column.
    pub left: u32,
    /// Its first row.
    pub top: u32,
    /// Its columns.
    pub width: u32,
    /// Its rows.
    pub height: u32,
}

/// How lines are drawn: a colour, a width in pixels, and the colour of the rim around them.
#[derive(Clone, Copy, Debug)]
pub struct Pen {
    /// The line's colour.
    pub color: Color,
    /// The line's width in pixels.
    pub width: f32,
    /// What sets the line off from the pixels under it, half as wide as the line on both sides.
    pub rim: Color,
}

/// A picture to draw on.
pub struct Canvas {
    pixmap: Pixmap,
}

impl Canvas {
    /// An empty sheet.
    ///
    /// # Errors
    /// If there is no memory for so many pixels.
    pub fn new(width: u32, height: u32) -> Result<Self> {
        let mut pixmap = Pixmap::new(width, height)
            .ok_or_else(|| Error::new(format!("cannot draw on {width}x{height} pixels")))?;
        pixmap.fill(tiny_skia::Color::from_rgba8(
            PAPER[0], PAPER[1], PAPER[2], 255,
        ));
        Ok(Self { pixmap })
    }

    /// Sets every pixel of the area to `color(x, y)`, counted from the area's upper left. What lies
    /// outside the canvas is left out.
    pub fn fill(&mut self, area: Area, mut color: impl FnMut(u32, u32) -> Color) {
        let [columns, rows] = [self.pixmap.width(), self.pixmap.height()];
        let pixels = self.pixmap.data_mut();
        for y in 0..area.height.min(rows.saturating_sub(area.top)) {
            for x in 0..area.width.min(columns.saturating_sub(area.left)) {
                let [column, row] = [area.left + x, area.top + y].map(|n| n as usize);
                let at = 4 * (row * columns as usize + column);
                pixels[at..at + 3].copy_from_slice(&color(x, y));
            }
        }
    }

    /// Draws a line of text with its baseline from `at` on.
    pub fn text(&mut self, words: &str, at: [f32; 2], size: f32, weight: Weight, color: Color) {
        let Some(path) = text::path(words, at, size, weight) else {
            return;
        };
        let paint = paint(color);
        let identity = Transform::identity();
        self.pixmap
            .fill_path(&path, &paint, FillRule::Winding, identity, None);
        let stroke = stroke(weight.pen() * size);
        self.pixmap
            .stroke_path(&path, &paint, &stroke, identity, None);
    }

    /// Draws along a path.
    pub fn stroke(&mut self, path: &Path, pen: Pen) {
        for (color, width) in [(pen.rim, 2.0 * pen.width), (pen.color, pen.width)] {
            let (paint, stroke) = (paint(color), stroke(width));
            self.pixmap
                .stroke_path(path, &paint, &stroke, Transform::identity(), None);
        }
    }

    /// Draws a straight line.
    pub fn line(&mut self, from: [f32; 2], to: [f32; 2], pen: Pen) {
        let mut builder = PathBuilder::new();
        builder.move_to(from[0], from[1]);
        builder.line_to(to[0], to[1]);
        if let Some(path) = builder.finish() {
            self.stroke(&path, pen);
        }
    }

    /// Draws a frame around an area, sharp and its rim included, so that no pixel of it is hidden.
    pub fn frame(&mut self, area: Area, pen: Pen) {
        let rim = (pen.width / 2.0).round().max(1.0) as u32;
        let line = pen.width.round().max(1.0) as u32;
        self.ring(area, rim, pen.rim);
        self.ring(area.grown(rim), line, pen.color);
        self.ring(area.grown(rim + line), rim, pen.rim);
    }

    /// Fills the border of `width` pixels around an area.
    fn ring(&mut self, area: Area, width: u32, color: Color) {
        let outer = area.grown(width);
        let below = area.top + area.height;
        let beside = area.left + area.width;
        let strips = [
            Area {
                height: area.top - outer.top,
                ..outer
            },
            Area {
                top: below,
                height: width,
                ..outer
            },
            Area {
                width: area.left - outer.left,
                ..outer
            },
            Area {
                left: beside,
                width,
                ..outer
            },
        ];
        for strip in strips {
            self.fill(strip, |_, _| color);
        }
    }

    /// The drawing as a picture.
    ///
    /// # Errors
    /// If it has more pixels than a picture may have.
    pub fn into_picture(self) -> Result<Picture> {
        let size = Size::new(self.pixmap.width(), self.pixmap.height())?;
        let pixels = self
            .pixmap
            .data()
            .chunks_exact(4)
            .map(|pixel| [pixel[0], pixel[1], pixel[2]])
            .collect();
        Ok(Picture::from_pixels(size, pixels)?)
    }
}

impl Area {
    /// The area without a border of `by` pixels.
    pub fn shrunk(self, by: u32) -> Self {
        Self {
            left: self.left + by,
            top: self.top + by,
            width: self.width.saturating_sub(2 * by),
            height: self.height.saturating_sub(2 * by),
        }
    }

    /// The area with a border of `by` pixels, cut off where it would leave the canvas at the left or top.
    pub fn grown(self, by: u32) -> Self {
        let (left, top) = (self.left.saturating_sub(by), self.top.saturating_sub(by));
        Self {
            left,
            top,
            width: self.left - left + self.width + by,
            height: self.top - top + self.height + by,
        }
    }

    /// Left, top, right and bottom edge, in pixels.
    pub fn edges(self) -> [f32; 4] {
        let [left, top, width, height] =
            [self.left, self.top, self.width, self.height].map(|n| n as f32);
        [left, top, left + width, top + height]
    }
}

fn paint(color: Color) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(color[0], color[1], color[2], 255);
    paint
}

fn stroke(width: f32) -> Stroke {
    Stroke {
        width,
        line_cap: LineCap::Square,
        line_join: LineJoin::Miter,
        ..Stroke::default()
    }
}
