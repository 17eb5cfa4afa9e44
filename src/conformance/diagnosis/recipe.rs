//! A picture's recipe: the lab's renderer with a knob for everything that programs do differently.

use super::Code;
use crate::figure::Figure;
use crate::film::Film;
use crate::integrator::Integrator;
use crate::lab;
use crate::scene::{Object, Scene};

/// Where in a pixel its rays go, and what the picture's width means: `n` pixels or `n - 1` steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sampling {
    /// One ray through `i / (n - 1)`: the lab's.
    Corner,
    /// One ray through `(i + 1/2) / n`.
    Center,
    /// One ray through `(i + 1/2) / (n - 1)`.
    CenterOfSteps,
    /// The average of several rays through `(i + x) / n`, x from 0 to 1.
    Average,
    /// The average of several rays through `(i + x) / (n - 1)`.
    AverageOfSteps,
}

impl Sampling {
    /// All of them, the lab's first.
    pub const ALL: [Sampling; 5] = [
        Sampling::Corner,
        Sampling::Center,
        Sampling::CenterOfSteps,
        Sampling::Average,
        Sampling::AverageOfSteps,
    ];

    /// The formula, as reports give it.
    pub fn name(self) -> &'static str {
        match self {
            Sampling::Corner => "i/(w-1)",
            Sampling::Center => "(i+0.5)/w",
            Sampling::CenterOfSteps => "(i+0.5)/(w-1)",
            Sampling::Average => "average over (i+x)/w",
            Sampling::AverageOfSteps => "average over (i+x)/(w-1)",
        }
    }

    /// Whether a pixel is the average of several rays.
    pub fn is_average(self) -> bool {
        matches!(self, Sampling::Average | Sampling::AverageOfSteps)
    }

    /// The place in the picture, from 0 to 1, of the point `within` (0 to 1) a pixel.
    pub(super) fn place(self, index: u32, count: u32, within: f64) -> f64 {
        let (index, count) = (f64::from(index), f64::from(count));
        match self {
            Sampling::Corner => index / (count - 1.0),
            Sampling::Center => (index + 0.5) / count,
            Sampling::CenterOfSteps => (index + 0.5) / (count - 1.0),
            Sampling::Average => (index + within) / count,
            Sampling::AverageOfSteps => (index + within) / (count - 1.0),
        }
    }
}

/// How a number becomes a whole one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// `truncate(255 x)`: the lab's.
    Truncate,
    /// `round(255 x)`.
    Nearest,
}

/// The curve between radiance and byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Transfer {
    Linear,
    Srgb,
    /// `x^(1 / 2.2)`.
    Power,
}

impl Transfer {
    pub fn encode(self, x: f64) -> f64 {
        match self {
            Transfer::Linear => x,
            Transfer::Srgb if x <= 0.003_130_8 => 12.92 * x,
            Transfer::Srgb => 1.055 * x.powf(1.0 / 2.4) - 0.055,
            Transfer::Power => x.signum() * x.abs().powf(1.0 / 2.2),
        }
    }

    pub fn decode(self, x: f64) -> f64 {
        match self {
            Transfer::Linear => x,
            Transfer::Srgb if x <= 0.040_45 => x / 12.92,
            Transfer::Srgb => ((x + 0.055) / 1.055).powf(2.4),
            Transfer::Power => x.powf(2.2),
        }
    }
}

/// What is made of a cosine below 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cosine {
    Clamped,
    Signed,
    Absolute,
}

/// Where shadow rays start and end; all lengths in scene units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ShadowRay {
    /// Along the normal.
    pub offset: f64,
    /// Along x and z.
    pub shift: [f64; 2],
    /// How far along x and z the light stands beside the one that shines.
    pub light: [f64; 2],
}

impl ShadowRay {
    pub fn is_exact(self) -> bool {
        self == Self::default()
    }
}

/// Everything that decides which surface a pixel shows and how it stands to the light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Viewpoint {
    pub sampling: Sampling,
    pub mirrored: bool,
    pub upside_down: bool,
    /// The vertical field of view in degrees.
    pub fov: f64,
    pub has_plane: bool,
    pub t_max: f64,
    /// `None`: nothing casts a shadow.
    pub shadow: Option<ShadowRay>,
}

/// The knobs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Recipe {
    pub viewpoint: Viewpoint,
    /// The light is at the eye: Figure 1.
    pub light_at_eye: bool,
    /// Of the sphere and of the plane.
    pub flipped: [bool; 2],
    pub cosine: Cosine,
    /// The power of the distance that the radiance is divided by.
    pub falloff: i32,
    /// The factor of the radiance; the lab's is 1.
    pub power: f64,
    /// Of the sphere and of the plane.
    pub colors: [[f64; 3]; 2],
    pub background: [f64; 3],
    pub transfer: Transfer,
    pub swapped: bool,
    pub film: Film,
    pub rounding: Rounding,
    /// Whether pixels of the sphere and of the plane may be falsely black.
    pub acne: [bool; 2],
}

/// The lab's light, whose power the recipe scales.
pub(super) const POWER: f64 = 100.0;

impl Recipe {
    /// The recipe of a figure.
    pub fn of(figure: &Figure, scene: &Scene<f64>) -> Self {
        let (light_at_eye, casts) = match figure.integrator {
            Integrator::RayCast(_) => (true, false),
            Integrator::DirectLighting(direct) => (false, direct.shadow.is_some()),
        };
        let color = |color: Option<glam::DVec3>| color.unwrap_or_default().to_array();
        Self {
            viewpoint: Viewpoint {
                sampling: Sampling::Corner,
                mirrored: false,
                upside_down: false,
                fov: lab::view::<f64>().fov,
                has_plane: true,
                t_max: scene.t_max(),
                shadow: casts.then(ShadowRay::default),
            },
            light_at_eye,
            flipped: [false; 2],
            cosine: Cosine::Clamped,
            falloff: 2,
            power: 1.0,
            colors: [
                color(scene.spheres().first().map(Object::color)),
                color(scene.planes().first().map(Object::color)),
            ],
            background: scene.background().to_array(),
            transfer: Transfer::Linear,
            swapped: false,
            film: figure.film,
            rounding: Rounding::Truncate,
            acne: [figure.name == "3a"; 2],
        }
    }

    /// The faults of this recipe against the expected one. Conventions are none.
    pub fn faults(&self, expected: &Recipe) -> Vec<Code> {
        Code::ALL
            .into_iter()
            .filter(|code| self.has(*code, expected))
            .collect()
    }

    /// How many knobs are turned: one a fault, two where both objects have another colour.
    pub fn knobs(&self, expected: &Recipe) -> usize {
        let both = (0..2).all(|i| self.colors[i] != expected.colors[i]);
        self.faults(expected).len() + usize::from(both)
    }

    /// Whether the recipe has a fault.
    pub fn has(&self, code: Code, expected: &Recipe) -> bool {
        let (view, right) = (&self.viewpoint, &expected.viewpoint);
        let ray = view.shadow.unwrap_or_default();
        let other_figure = self.light_at_eye != expected.light_at_eye
            || view.shadow.is_some() && right.shadow.is_none()
            || expected.acne.contains(&true) && !self.acne.contains(&true) && view.shadow.is_some();
        let shifted = ray.shift != [0.0; 2] || ray.light != [0.0; 2];
        match code {
            Code::OtherFigure => other_figure,
            Code::Wrapped => self.film == Film::Wrap && expected.film == Film::Clamp,
            Code::Clamped => self.film == Film::Clamp && expected.film == Film::Wrap,
            Code::NoShadow => view.shadow.is_none() && right.shadow.is_some() && !self.light_at_eye,
            Code::Acne => self.acne.contains(&true) && !expected.acne.contains(&true),
            Code::OffsetTooLarge => ray.offset != 0.0,
            Code::ShadowShifted => shifted,
            Code::CosineUnclamped => self.cosine != expected.cosine,
            Code::NoFalloff => self.falloff == 0,
            Code::LinearFalloff => self.falloff == 1,
            Code::WrongPower => self.power != 1.0 && self.power != 1.0 / std::f64::consts::PI,
            Code::ExtraPi => self.power == 1.0 / std::f64::consts::PI,
            Code::PlaneMissing => !view.has_plane,
            Code::NormalFlipped => self.flipped != expected.flipped,
            Code::Mirrored => view.mirrored,
            Code::UpsideDown => view.upside_down,
            Code::Gamma => self.transfer != expected.transfer,
            Code::RedBlueSwapped => self.swapped,
            Code::WrongColour => self.colors != expected.colors,
            Code::WrongBackground => self.background != expected.background,
            Code::WrongFov => view.fov != right.fov,
            Code::Saturated | Code::OtherScene => false,
        }
    }

    /// The recipe with the other way to make a number a whole one.
    pub fn with_other_rounding(mut self) -> Self {
        self.rounding = match self.rounding {
            Rounding::Truncate => Rounding::Nearest,
            Rounding::Nearest => Rounding::Truncate,
        };
        self
    }

    /// The recipe with the other convention for the largest parameter of a primary hit.
    pub fn with_other_t_max(mut self) -> Self {
        let t_max = &mut self.viewpoint.t_max;
        *t_max = if t_max.is_finite() {
            f64::INFINITY
        } else {
            1000.0
        };
        self
    }

    /// The recipe without a fault: its knobs as expected.
    pub fn without(mut self, code: Code, expected: &Recipe) -> Self {
        let right = &expected.viewpoint;
        let view = &mut self.viewpoint;
        match code {
            Code::OtherFigure => {
                self.light_at_eye = expected.light_at_eye;
                view.shadow = right.shadow;
                self.acne = expected.acne;
            }
            Code::Wrapped | Code::Clamped | Code::Saturated => self.film = expected.film,
            Code::NoShadow => view.shadow = right.shadow,
            Code::Acne => self.acne = expected.acne,
            Code::OffsetTooLarge | Code::ShadowShifted => {
                if let Some(ray) = &mut view.shadow {
                    if code == Code::OffsetTooLarge {
                        ray.offset = 0.0;
                    } else {
                        (ray.shift, ray.light) = ([0.0; 2], [0.0; 2]);
                    }
                }
            }
            Code::CosineUnclamped => self.cosine = expected.cosine,
            Code::NoFalloff | Code::LinearFalloff => self.falloff = expected.falloff,
            Code::WrongPower | Code::ExtraPi => self.power = expected.power,
            Code::PlaneMissing => view.has_plane = true,
            Code::NormalFlipped => self.flipped = expected.flipped,
            Code::Mirrored => view.mirrored = false,
            Code::UpsideDown => view.upside_down = false,
            Code::Gamma => self.transfer = expected.transfer,
            Code::RedBlueSwapped => self.swapped = false,
            Code::WrongColour => self.colors = expected.colors,
            Code::WrongBackground => self.background = expected.background,
            Code::WrongFov => view.fov = right.fov,
            Code::OtherScene => {}
        }
        self
    }
}
