//! Pictures of which every byte is proven to be that of exact mathematics.
//!
//! Ziv's strategy for correctly rounded functions, applied to pixels (A. Ziv, "Fast evaluation of
//! elementary mathematical functions with correctly rounded last bit", ACM TOMS 17 (1991)): the
//! kernels of [`Relative`](crate::Relative) run on numbers that carry a bound of their error,
//! [`Bounded`]. A pixel is proven when every decision on its way was certain and no bound reaches
//! over the border of a byte; the others are done again, one precision up.

mod byte;
mod exactly;
mod prover;
mod rows;

pub use prover::Prover;

use crate::camera::View;
use crate::error::Invalid;
use crate::film::Film;
use crate::picture::{Picture, Size};
use crate::real::{DoubleDouble, in_single_packets};
use crate::relative::Lighting;
use crate::render::Engine;
use crate::scene::Scene;
use exactly::Exactly;
use prover::Precisely;
use rows::Rows;
use std::sync::{LazyLock, Mutex, PoisonError};

/// What proved a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rung {
    /// Single precision.
    F32,
    /// Double precision.
    F64,
    /// Double-double.
    DoubleDouble,
    /// Exact arithmetic.
    Exact,
    /// Nothing: see [`Proven::undecided`].
    Undecided,
}

/// A pixel that nothing proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Undecided {
    /// Its column, from 0.
    pub column: u32,
    /// Its row, from 0.
    pub row: u32,
    /// Why.
    pub reason: &'static str,
}

/// A picture with its proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proven {
    picture: Picture,
    /// The indices of the pixels that the first rung did not prove, rising, and what did.
    climbed: Vec<(usize, Rung)>,
    undecided: Vec<Undecided>,
}

impl Rung {
    /// All rungs, from the first on.
    pub const ALL: [Rung; 5] = [
        Rung::F32,
        Rung::F64,
        Rung::DoubleDouble,
        Rung::Exact,
        Rung::Undecided,
    ];

    /// Its name in tables: `f32`, `f64`, `double_double`, `exact` or `undecided`.
    pub fn name(self) -> &'static str {
        match self {
            Rung::F32 => "f32",
            Rung::F64 => "f64",
            Rung::DoubleDouble => "double_double",
            Rung::Exact => "exact",
            Rung::Undecided => "undecided",
        }
    }
}

impl Proven {
    /// The picture. Undecided pixels are black.
    pub fn picture(&self) -> &Picture {
        &self.picture
    }

    /// What proved each pixel, row-major.
    pub fn rungs(&self) -> Vec<Rung> {
        let mut rungs = vec![Rung::F32; self.picture.size().pixels()];
        for &(i, rung) in &self.climbed {
            rungs[i] = rung;
        }
        rungs
    }

    /// The pixels that nothing proved, row-major.
    pub fn undecided(&self) -> &[Undecided] {
        &self.undecided
    }

    /// How many pixels the rung proved.
    pub fn count(&self, rung: Rung) -> usize {
        let climbed = self.climbed.iter().filter(|(_, r)| *r == rung).count();
        match rung {
            Rung::F32 => self.picture.size().pixels() - self.climbed.len(),
            _ => climbed,
        }
    }

    /// The picture, without its proof.
    pub fn into_picture(self) -> Picture {
        self.picture
    }
}

/// Renders the picture that [`render`](crate::render) comes near to: that of exact mathematics,
/// byte by byte.
///
/// The scene's numbers are taken as exact; so are the places of the pixels and the tangent of half
/// the field of view.
///
/// ```
/// use ombrage::*;
///
/// # fn main() -> Result<(), Invalid> {
/// let (scene, view) = (lab::scene()?, lab::view());
/// let proven = render_proven(&scene, &view, Size::LAB, Lighting::Shadowed, Film::Clamp)?;
/// assert!(proven.undecided().is_empty());
/// assert!(proven.count(Rung::F32) > 239_000);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`Relative::new`](crate::Relative::new).
pub fn render_proven(
    scene: &Scene<f64>,
    view: &View<f64>,
    size: Size,
    lighting: Lighting,
    film: Film,
) -> Result<Proven, Invalid> {
    Engine::default().render_proven(scene, view, size, lighting, film)
}

/// More lights than a bound in `f32` may add up: see the allowance of [`Bounded`].
const MANY_LIGHTS: usize = 1000;

impl Engine {
    /// Renders like [`render_proven`]. Every engine gives the same picture and the same proof.
    ///
    /// # Errors
    /// As [`Relative::new`](crate::Relative::new).
    pub fn render_proven(
        self,
        scene: &Scene<f64>,
        view: &View<f64>,
        size: Size,
        lighting: Lighting,
        film: Film,
    ) -> Result<Proven, Invalid> {
        self.render_proven_over(scene, view, lighting, film, Picture::black(size))
    }

    /// The same over a picture, at its size: see [`render_into`](Self::render_into).
    ///
    /// # Errors
    /// As [`Relative::new`](crate::Relative::new).
    pub fn render_proven_over(
        self,
        scene: &Scene<f64>,
        view: &View<f64>,
        lighting: Lighting,
        film: Film,
        mut picture: Picture,
    ) -> Result<Proven, Invalid> {
        let size = picture.size();
        let precisely = Precisely::of(scene, view, size, lighting)?;
        let background = scene.background();
        let single = Prover::<f32>::of(&precisely, background, size, film);
        let double = LazyLock::new(|| Prover::<f64>::of(&precisely, background, size, film));
        let wide = LazyLock::new(|| Prover::<DoubleDouble>::of(&precisely, background, size, film));
        let climb = |column: u32, row: u32| {
            let by = |rung| move |bytes| (rung, bytes);
            let first = double.pixel(column, row).map(by(Rung::F64));
            first.or_else(|| wide.pixel(column, row).map(by(Rung::DoubleDouble)))
        };
        let climbed = Mutex::new(vec![]);
        let width = size.width() as usize;
        let pixels = picture.pixels_mut();
        self.share(size, 0..size.height(), pixels, |rows, pixels| {
            let mut open = vec![];
            let (first, count) = (rows.start, rows.len() * width);
            if scene.lights().len() > MANY_LIGHTS {
                open.extend(0..count);
            } else {
                let rows = Rows {
                    prover: &single,
                    size,
                    rows,
                    pixels,
                    open: &mut open,
                };
                in_single_packets(self.level(), rows);
            }
            let start = first as usize * width;
            let above = open.into_iter().map(|i| {
                let (column, row) = ((i % width) as u32, first + (i / width) as u32);
                let (rung, bytes) = climb(column, row).unwrap_or((Rung::Undecided, [0; 3]));
                pixels[i] = bytes;
                (start + i, rung)
            });
            let above: Vec<_> = above.collect();
            let mut climbed = climbed.lock().unwrap_or_else(PoisonError::into_inner);
            climbed.extend(above);
        });
        let mut climbed = climbed.into_inner().unwrap_or_else(PoisonError::into_inner);
        climbed.sort_unstable_by_key(|&(i, _)| i);
        let mut undecided = vec![];
        let open = climbed.iter_mut();
        let mut open = open.filter(|(_, rung)| *rung == Rung::Undecided).peekable();
        if open.peek().is_some() {
            let exactly = Exactly::new(scene, view, size, lighting, film)?;
            for (i, rung) in open {
                let (column, row) = ((*i % width) as u32, (*i / width) as u32);
                match exactly.pixel(column, row) {
                    Ok(bytes) => (pixels[*i], *rung) = (bytes, Rung::Exact),
                    Err(reason) => undecided.push(Undecided {
                        column,
                        row,
                        reason,
                    }),
                }
            }
        }
        Ok(Proven {
            picture,
            climbed,
            undecided,
        })
    }
}
