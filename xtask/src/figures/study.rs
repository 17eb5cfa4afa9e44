//! What a figure shows, and what its annotation says about it.

use super::view::View;
use crate::draw::Area;
use crate::error::{Error, Result};
use ombrage::{Counts, FIGURES, Figure, Film, Invalid, Picture, Pixel, Scalar, Size};
use std::sync::OnceLock;

/// A figure's pixels as its sheet shows them, and what was found at them.
pub struct Study<'a> {
    /// The figure.
    pub figure: &'static Figure,
    /// The size of the picture it was drawn from.
    pub size: Size,
    /// The format it was computed in.
    pub float: &'static str,
    /// How it stands on the sheet.
    pub view: View,
    /// The shown pixels.
    pub shown: Picture,
    /// For an enlarged detail: the shown pixels of the whole picture.
    pub whole: Option<Picture>,
    /// What happens at the pixels of the whole picture.
    pub findings: &'a Findings,
}

/// The findings of all figures. Figures with the same integrator share them, found once.
#[derive(Default)]
pub struct Surveys([OnceLock<std::result::Result<Findings, Invalid>>; FIGURES.len()]);

impl Surveys {
    /// What happens at the pixels of a figure. All calls must be of one format and size.
    ///
    /// # Errors
    /// None for the formats there are.
    pub fn of<S: Scalar>(&self, figure: &Figure, size: Size, view: &View) -> Result<&Findings> {
        let alike = |other: &Figure| other.integrator == figure.integrator;
        let first = FIGURES.iter().position(alike).unwrap_or_default();
        self.0[first]
            .get_or_init(|| Findings::of::<S>(figure, size, view))
            .as_ref()
            .map_err(|invalid| Error::from(invalid.clone()))
    }
}

/// What happens at the pixels of a picture.
pub struct Findings {
    /// How many pixels are what; those that pass 255 are counted as wrapped, whatever the film.
    pub counts: Counts,
    /// How many pixels are marked.
    pub marks: u64,
    marked: Vec<bool>,
    columns: u32,
    /// The smallest rectangle around the marked pixels, in shown pixels.
    pub bounds: Option<Area>,
}

impl Findings {
    /// Follows the ray of every pixel of the figure.
    fn of<S: Scalar>(
        figure: &Figure,
        size: Size,
        view: &View,
    ) -> std::result::Result<Self, Invalid> {
        let is_marked = mark_of(figure);
        let mut counts = Counts::default();
        let mut marked = Vec::with_capacity(view.shown.pixels());
        let mut marks = 0;
        let mut bounds: Option<[u32; 4]> = None;
        figure.visit::<S>(size, |x, y, pixel| {
            counts.add(&pixel, Film::Wrap);
            let mark = is_marked(&pixel);
            if x % view.every == 0 && y % view.every == 0 {
                marked.push(mark);
            }
            if mark {
                marks += 1;
                let (x, y) = (x / view.every, y / view.every);
                let [left, top, right, bottom] = bounds.unwrap_or([x, y, x, y]);
                bounds = Some([left.min(x), top.min(y), right.max(x), bottom.max(y)]);
            }
        })?;
        Ok(Self {
            counts,
            marks,
            marked,
            columns: view.shown.width(),
            bounds: bounds.map(|[left, top, right, bottom]| Area {
                left,
                top,
                width: right - left + 1,
                height: bottom - top + 1,
            }),
        })
    }

    /// Whether a shown pixel is marked: passes 255 in Figure 2, is acne in Figure 3(a), lies in
    /// shadow in Figure 3(c).
    pub fn is_marked(&self, x: u32, y: u32) -> bool {
        let at = y as usize * self.columns as usize + x as usize;
        self.marked.get(at).is_some_and(|&marked| marked)
    }
}

/// Which pixels the annotation of a figure marks.
fn mark_of(figure: &Figure) -> fn(&Pixel) -> bool {
    match figure.name {
        "2a" | "2b" => Pixel::is_too_bright,
        "3c" => |pixel| pixel.blocked_by_another,
        _ => Pixel::is_acne,
    }
}
