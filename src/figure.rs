//! The six figures of the lab, as data.

use crate::camera::PerspectiveCamera;
use crate::chain::LabChain;
use crate::error::Invalid;
use crate::film::Film;
use crate::integrator::{DirectLighting, Integrator, ShadowQuery};
use crate::lab;
use crate::picture::{Picture, Size};
use crate::proven::Proven;
use crate::quality::Quality;
use crate::real::Scalar;
use crate::relative::Lighting;
use crate::render::Engine;
use crate::shadow::Shadow;
use crate::survey::{Pixel, Survey, visit};

/// One figure of the lab: how the lab's scene is drawn for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Its number: `1`, `2a`, `2b`, `3a`, `3b` or `3c`.
    pub name: &'static str,
    /// What it shows.
    pub title: &'static str,
    /// The clause of the lab that asks for it.
    pub clause: &'static str,
    /// How light is summed up.
    pub integrator: Integrator,
    /// How radiance becomes bytes.
    pub film: Film,
    /// The part of the picture that is shown enlarged; `None`: the whole.
    pub detail: Option<Detail>,
}

/// A part of a picture, enlarged with hard pixels, its contrast raised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Detail {
    /// The left edge of the part, in hundredths of the picture's width.
    pub left_percent: u32,
    /// Its upper edge, in hundredths of the picture's height.
    pub top_percent: u32,
    /// How many pixels wide and high each of its pixels becomes. The part is the picture's size
    /// divided by this, rounded up.
    pub factor: u32,
    /// What every byte is multiplied by, up to 255.
    pub gain: u8,
}

const fn direct(shadow: Option<Shadow>) -> Integrator {
    Integrator::DirectLighting(DirectLighting {
        quality: Quality::Textbook,
        shadow,
        query: ShadowQuery::Any,
    })
}

/// The figures, in the lab's order.
pub const FIGURES: [Figure; 6] = [
    Figure {
        name: "1",
        title: "a plane joins the sphere; the light is at the eye",
        clause: "1.3",
        integrator: Integrator::RayCast(Quality::Textbook),
        film: Film::Clamp,
        detail: None,
    },
    Figure {
        name: "2a",
        title: "direct light, no clamp: bytes wrap",
        clause: "3.2",
        integrator: direct(None),
        film: Film::Wrap,
        detail: None,
    },
    Figure {
        name: "2b",
        title: "direct light, clamped",
        clause: "3.3",
        integrator: direct(None),
        film: Film::Clamp,
        detail: None,
    },
    Figure {
        name: "3a",
        title: "shadow rays hit the surface they start on: acne",
        clause: "4.2",
        integrator: direct(Some(Shadow::SelfHitting)),
        film: Film::Clamp,
        detail: None,
    },
    Figure {
        name: "3b",
        title: "the same, enlarged and with more contrast",
        clause: "4.2",
        integrator: direct(Some(Shadow::SelfHitting)),
        film: Film::Clamp,
        detail: Some(Detail {
            left_percent: 33,
            top_percent: 41,
            factor: 3,
            gain: 6,
        }),
    },
    Figure {
        name: "3c",
        title: "shadow rays start off their surface",
        clause: "4.3",
        integrator: direct(Some(Shadow::UlpOffset)),
        film: Film::Clamp,
        detail: None,
    },
];

impl Figure {
    /// The figure of this name.
    pub fn named(name: &str) -> Option<&'static Figure> {
        FIGURES.iter().find(|figure| figure.name == name)
    }

    /// Draws the figure in a format, from a picture of the given size.
    ///
    /// # Errors
    /// None for the formats there are; the lab's scene is valid in each of them.
    pub fn draw<S: Scalar>(&self, size: Size) -> Result<Picture, Invalid> {
        self.draw_with::<S>(size, Engine::default())
    }

    /// The same, with an engine of choice.
    ///
    /// # Errors
    /// None for the formats there are; the lab's scene is valid in each of them.
    pub fn draw_with<S: Scalar>(&self, size: Size, engine: Engine) -> Result<Picture, Invalid> {
        let camera = PerspectiveCamera::new(&lab::view::<S>(), S::from_f64(size.aspect()))?;
        let scene = lab::scene::<S>()?;
        let chain = LabChain {
            scene: &scene,
            camera: &camera,
            integrator: self.integrator,
        };
        let picture = engine.render(&chain, size, self.film);
        Ok(match self.detail {
            None => picture,
            Some(detail) => detail.of(&picture),
        })
    }
}

impl Figure {
    /// What the figure shows in exact mathematics. `None` where it shows errors of rounding: 3(a)
    /// and 3(b).
    pub fn lighting(&self) -> Option<Lighting> {
        match self.integrator {
            Integrator::RayCast(_) => Some(Lighting::Eye),
            Integrator::DirectLighting(direct) => match direct.shadow {
                None => Some(Lighting::Unshadowed),
                Some(Shadow::SelfHitting) => None,
                Some(_) => Some(Lighting::Shadowed),
            },
        }
    }

    /// Draws the figure as exact mathematics has it, with an engine of choice; `None` for a figure
    /// that shows errors of rounding.
    ///
    /// # Errors
    /// None; the lab's scene is valid.
    pub fn prove_with(&self, size: Size, engine: Engine) -> Result<Option<Proven>, Invalid> {
        let Some(lighting) = self.lighting() else {
            return Ok(None);
        };
        let (scene, view) = (lab::scene()?, lab::view());
        let proven = engine.render_proven(&scene, &view, size, lighting, self.film)?;
        Ok(Some(proven))
    }

    /// What happens at every pixel of the figure; for an enlarged detail, of the whole picture.
    ///
    /// # Errors
    /// None for the formats there are; the lab's scene is valid in each of them.
    pub fn survey<S: Scalar>(&self, size: Size) -> Result<Survey, Invalid> {
        let camera = PerspectiveCamera::new(&lab::view::<S>(), S::from_f64(size.aspect()))?;
        Ok(Survey::new(
            &lab::scene::<S>()?,
            &camera,
            size,
            self.integrator,
            self.film,
        ))
    }

    /// The same, without keeping it: hands every pixel to `pixel` with its column and row,
    /// row-major.
    ///
    /// # Errors
    /// None for the formats there are; the lab's scene is valid in each of them.
    pub fn visit<S: Scalar>(
        &self,
        size: Size,
        pixel: impl FnMut(u32, u32, Pixel),
    ) -> Result<(), Invalid> {
        let camera = PerspectiveCamera::new(&lab::view::<S>(), S::from_f64(size.aspect()))?;
        visit(&lab::scene::<S>()?, &camera, size, self.integrator, pixel);
        Ok(())
    }
}

impl Detail {
    /// Left, upper edge, width and height of the part, in pixels of a picture of this size.
    pub fn region(&self, size: Size) -> [u32; 4] {
        let (width, height) = (
            size.width().div_ceil(self.factor),
            size.height().div_ceil(self.factor),
        );
        let at = |percent: u32, whole: u32| (u64::from(whole) * u64::from(percent) / 100) as u32;
        let left = at(self.left_percent, size.width()).min(size.width() - width);
        let top = at(self.top_percent, size.height()).min(size.height() - height);
        [left, top, width, height]
    }

    /// The part of a picture, enlarged to the picture's own size.
    pub fn of(&self, picture: &Picture) -> Picture {
        let [left, top, ..] = self.region(picture.size());
        Picture::from_fn(picture.size(), |x, y| {
            let pixel = picture.pixel(left + x / self.factor, top + y / self.factor);
            pixel
                .unwrap_or_default()
                .map(|byte| byte.saturating_mul(self.gain))
        })
    }
}
