//! The last rung: pixels decided in exact arithmetic.

use super::byte::byte;
use crate::camera::View;
use crate::error::Invalid;
use crate::film::Film;
use crate::picture::Size;
use crate::real::exact::{Exact, forgetting};
use crate::real::{Constant, Real};
use crate::relative::{Lighting, Relative, coordinate};
use crate::scene::Scene;
use crate::vector::Vector;

/// Decides pixels by the same kernels on numbers that are exact where they have to be. Stays on the
/// thread that made it.
pub(super) struct Exactly {
    chain: Relative<Exact>,
    size: Size,
    film: Film,
    background: [u8; 3],
}

impl Exactly {
    pub fn new(
        scene: &Scene<f64>,
        view: &View<f64>,
        size: Size,
        lighting: Lighting,
        film: Film,
    ) -> Result<Self, Invalid> {
        Ok(Self {
            chain: Relative::of(scene, view, size, lighting)?,
            size,
            film,
            background: scene.background().to_array().map(|x| film.byte(x) as u8),
        })
    }

    /// The bytes of the pixel in a column and a row, or why they are not known.
    pub fn pixel(&self, column: u32, row: u32) -> Result<[u8; 3], &'static str> {
        forgetting(|| {
            let across = coordinate::<Exact>(column, self.size.width());
            let down = coordinate::<Exact>(row, self.size.height());
            let direction = self.chain.across::<Exact>(across) + self.chain.down(down);
            let Some((hit, reflected)) = self.chain.reflected::<Exact>(direction) else {
                return Ok(self.background);
            };
            match (hit.certain, hit.possible) {
                (false, false) => return Ok(self.background),
                (false, true) => return Err("whether the ray meets a surface is not decided"),
                (true, _) => {}
            }
            let [red, green, blue] = reflected.to_array().map(|x| self.byte(x));
            Ok([red?, green?, blue?])
        })
    }

    /// The byte of a component, exactly where it is at the border of two.
    fn byte(&self, x: Exact) -> Result<u8, &'static str> {
        let near = x.bounded();
        let (level, certain) = byte(self.film, near);
        if certain {
            return Ok(level.high() as u8);
        }
        let scaled = x * Exact::from_f64(255.0);
        let border = scaled.bounded().value.high().round();
        let close = scaled.bounded().reach().high() <= 0.25;
        if !close {
            return Err("a choice between surfaces or of light and shadow is not decided");
        }
        let reaches = scaled.ge(Exact::from_f64(border));
        let level = match (reaches.certain, reaches.possible) {
            (true, _) => border,
            (_, false) => border - 1.0,
            _ => return Err("the radiance is too near to the border of two bytes"),
        };
        Ok(match self.film {
            Film::Clamp => level.clamp(0.0, 255.0) as u8,
            Film::Wrap => (level.max(0.0) % 256.0) as u8,
        })
    }
}
