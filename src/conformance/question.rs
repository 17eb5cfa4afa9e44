//! Questions of the kernel protocol and their answers, as types.

use super::kernels::{Kernels, Offset};
use super::shade::{Shade, Shaded};
use super::surface::{Ends, Surface};
use crate::float::Float;
use crate::light::LightSample;
use crate::ray::Ray;

/// A question about one kernel. Which numbers it may hold is in `docs/protocol.md`: among them are
/// infinities, NaN and objects that no scene can have.
#[derive(Clone, Debug)]
pub enum Question<F: Float> {
    /// The nearest hit of a surface in a closed interval.
    Hit {
        /// The ray; its direction may have any length.
        ray: Ray<F>,
        /// `[tmin, tmax]`
        ends: Ends<F>,
        /// What it may hit.
        surface: Surface<F>,
    },
    /// Whether any surface is hit in a closed interval.
    AnyHit {
        /// The ray; its direction may have any length.
        ray: Ray<F>,
        /// `[tmin, tmax]`
        ends: Ends<F>,
        /// What it may hit.
        surfaces: Vec<Surface<F>>,
    },
    /// What a point receives from a light.
    LightSample {
        /// The point.
        point: F::Vector,
        /// Where the light is.
        light: F::Vector,
        /// Its linear colour.
        color: F::Vector,
        /// The factor of its radiance.
        power: F,
    },
    /// The radiance along a ray.
    Shade(Shade<F>),
    /// A shadow ray's origin.
    Offset(Offset<F>),
    /// The byte of a component of radiance.
    Quantise(F),
}

/// The answer to the [`Question`] of the same name.
#[derive(Clone, Copy, Debug)]
pub enum Answer<F: Float> {
    /// The parameter of the hit; `None`: there is none.
    Hit(Option<F>),
    /// Whether there is a hit.
    AnyHit(bool),
    /// The sample; `None`: the light adds nothing.
    LightSample(Option<LightSample<F>>),
    /// Radiance and bytes.
    Shade(Shaded<F>),
    /// The origin.
    Offset(F::Vector),
    /// The byte.
    Quantise(u8),
}

impl Kernels {
    /// The kit's answer.
    ///
    /// # Errors
    /// As [`Kernels::shade`].
    pub fn answer<F: Float>(&self, question: &Question<F>) -> Result<Answer<F>, String> {
        Ok(match question {
            Question::Hit { ray, ends, surface } => Answer::Hit(self.hit(ray, *ends, surface)),
            Question::AnyHit {
                ray,
                ends,
                surfaces,
            } => Answer::AnyHit(self.any_hit(ray, *ends, surfaces)),
            Question::LightSample {
                point,
                light,
                color,
                power,
            } => Answer::LightSample(self.light_sample::<F>(*point, [*light, *color], *power)),
            Question::Shade(shade) => Answer::Shade(self.shade(shade)?),
            Question::Offset(offset) => Answer::Offset(self.offset(offset)),
            Question::Quantise(x) => Answer::Quantise(self.quantise(*x)),
        })
    }
}
