//! Text as outlines.

use std::sync::LazyLock;
use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Ubuntu Light, under the Ubuntu Font Licence.
static FACE: LazyLock<Option<Face<'static>>> =
    LazyLock::new(|| Face::parse(epaint_default_fonts::UBUNTU_LIGHT, 0).ok());

/// How strong the strokes of letters are: the font is a light one, and its outline is widened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// For running text.
    Regular,
    /// For headings.
    Bold,
}

impl Weight {
    /// How wide the pen is that traces the outline, in units of the text's size.
    pub fn pen(self) -> f32 {
        match self {
            Weight::Regular => 0.03,
            Weight::Bold => 0.075,
        }
    }

    /// The space that the pen takes from between letters, given back; in units of the text's size.
    fn spacing(self) -> f32 {
        match self {
            Weight::Regular => 0.01,
            Weight::Bold => 0.035,
        }
    }
}

/// How wide a line of text is, in pixels; `size` is that of the font, in pixels.
pub fn width(text: &str, size: f32, weight: Weight) -> f32 {
    glyphs(text, size, weight).1
}

/// The outline of a line of text whose baseline starts at `x`, `y`; `None` where nothing is drawn.
pub fn path(text: &str, [x, y]: [f32; 2], size: f32, weight: Weight) -> Option<Path> {
    let face = FACE.as_ref()?;
    let scale = size / f32::from(face.units_per_em());
    let mut outline = Outline {
        builder: PathBuilder::new(),
        x,
        y,
        scale,
    };
    for (glyph, offset) in glyphs(text, size, weight).0 {
        outline.x = x + offset;
        face.outline_glyph(glyph, &mut outline);
    }
    outline.builder.finish()
}

/// The glyphs of a text, each with its distance from the start, and the whole width.
fn glyphs(text: &str, size: f32, weight: Weight) -> (Vec<(GlyphId, f32)>, f32) {
    let Some(face) = FACE.as_ref() else {
        return (vec![], 0.0);
    };
    let scale = size / f32::from(face.units_per_em());
    let mut x = 0.0;
    let mut placed = vec![];
    for character in text.chars() {
        let glyph = face.glyph_index(character).unwrap_or_default();
        placed.push((glyph, x));
        let advance = face.glyph_hor_advance(glyph).unwrap_or(0);
        x += f32::from(advance) * scale + weight.spacing() * size;
    }
    (placed, x)
}

/// Turns glyph outlines, in font units with y up, into a path in pixels with y down.
struct Outline {
    builder: PathBuilder,
    x: f32,
    y: f32,
    scale: f32,
}

impl Outline {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + x * self.scale, self.y - y * self.scale)
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.builder.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.builder.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.builder.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.builder.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}
