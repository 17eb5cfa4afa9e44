//! What is wrong with somebody's picture of a figure.
//!
//! The method: every hypothesis - a convention, a fault, several of them - is a setting of a
//! renderer with knobs ([the recipe](Code)), so a picture's recipe is what draws the picture
//! again. All single faults and their pairs are drawn on a part of the picture's pixels, the
//! nearest are refined, and each fault that remains must explain the pixels in which it shows
//! better than the same recipe without it. Acne alone cannot be drawn again, since it depends on a
//! program's every rounding; it is judged by its statistics.

mod acne;
mod best;
mod changes;
mod clauses;
mod code;
mod color;
mod evidence;
mod finding;
mod fit;
mod loss;
mod measure;
mod palette;
mod recipe;
mod refine;
mod search;
mod shade;
mod shadow;
mod surface;
mod verdict;

pub use code::{Code, Severity};
pub use finding::{Estimate, Finding};
pub use loss::{Loss, Lossless};
pub use recipe::{Rounding, Sampling};
pub use surface::Region;

use crate::error::Invalid;
use crate::figure::Figure;
use crate::lab;
use crate::picture::{Picture, Size};
use recipe::Recipe;

/// What is known of a picture.
#[derive(Clone, Debug)]
pub struct Diagnosis {
    /// The figure it claims to be.
    pub figure: &'static str,
    /// Whether it is.
    pub verdict: Verdict,
    /// How it was drawn, where that is a matter of taste. Means little where the verdict is
    /// [`Verdict::Unknown`].
    pub conventions: Conventions,
    /// What is wrong with it, the widest fault first.
    pub findings: Vec<Finding>,
    /// The clauses of `docs/spec.md` that it shows to hold.
    pub shown: Vec<&'static str>,
    /// The clauses that it says nothing about.
    pub not_shown: Vec<&'static str>,
    /// The faults that would leave no trace in it.
    pub invisible: Vec<Code>,
    /// How sure the verdict is.
    pub margin: Margin,
}

/// Whether a picture is the figure it claims to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// It is.
    Conforms,
    /// It is not, and the findings say why.
    Faults,
    /// Nothing explains it.
    Unknown,
}

impl Verdict {
    /// `conforms`, `faults` or `unknown`.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Conforms => "conforms",
            Verdict::Faults => "faults",
            Verdict::Unknown => "unknown",
        }
    }
}

/// How a picture was drawn, where the choice is no fault.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conventions {
    /// Where in a pixel its rays go.
    pub sampling: Sampling,
    /// How a number becomes a byte.
    pub rounding: Rounding,
    /// The largest parameter of a primary hit: 1000 or infinity; `None` where this picture would
    /// be the same with both.
    pub t_max: Option<f64>,
    /// Which of the losses that the file may have had fits best.
    pub loss: usize,
}

/// How much nearer the picture is to what was found than to anything else.
#[derive(Clone, Debug)]
pub struct Margin {
    /// The mean error of a pixel in levels, for what was found.
    pub error: f64,
    /// The faults of the nearest other explanation; empty: none at all.
    pub runner_up: Vec<Code>,
    /// The mean error of that.
    pub runner_up_error: f64,
}

impl Margin {
    /// From 0, where the other explanation is as good, to 1, where it explains nothing.
    pub fn share(&self) -> f64 {
        // A thousandth of a level is nothing: two exact explanations are equal.
        let [error, other] = [self.error, self.runner_up_error].map(|error| error + 0.001);
        (1.0 - error / other).max(0.0)
    }
}

/// The smallest width and height that are judged.
pub const SMALLEST: u32 = 32;

/// The most pixels that are judged: 2^24.
pub const MOST_PIXELS: usize = 1 << 24;

/// Finds out what is wrong with a picture that claims to be a figure: `1`, `2a`, `2b`, `3a` or
/// `3c`. `losses` is what the picture's file format may have taken from it, one of them; empty:
/// nothing.
///
/// ```
/// use ombrage::conformance::diagnosis::{Code, Verdict, diagnose};
/// use ombrage::{Figure, Invalid, Size};
///
/// # fn main() -> Result<(), Invalid> {
/// let [asked, drawn] = ["3c", "2b"].map(|name| Figure::named(name).expect("a figure"));
/// let picture = drawn.draw::<f32>(Size::new(120, 80)?)?;
/// let diagnosis = diagnose(&picture, asked, &[])?;
/// assert_eq!(diagnosis.verdict, Verdict::Faults);
/// assert_eq!(diagnosis.findings[0].code, Code::NoShadow);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// If the figure is an enlarged detail, or the picture is smaller than 32x32 or has more than 2^24
/// pixels.
pub fn diagnose(
    picture: &Picture,
    figure: &'static Figure,
    losses: &[&dyn Loss],
) -> Result<Diagnosis, Invalid> {
    check_size(picture.size())?;
    if figure.detail.is_some() {
        return Err(Invalid {
            field: "figure",
            value: figure.name.to_owned(),
            must_be: "one that shows the whole picture",
        });
    }
    let expected = Recipe::of(figure, &lab::scene::<f64>()?);
    verdict::reach(picture, figure, &expected, losses)
}

/// Whether pictures of this size are judged.
///
/// # Errors
/// If they are not.
pub fn check_size(size: Size) -> Result<(), Invalid> {
    let small = size.width() < SMALLEST || size.height() < SMALLEST;
    if small || size.pixels() > MOST_PIXELS {
        return Err(Invalid {
            field: "picture size",
            value: format!("{}x{}", size.width(), size.height()),
            must_be: "at least 32x32 and at most 2^24 pixels to be judged",
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests;
