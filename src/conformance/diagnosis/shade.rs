//! From what a pixel shows to its bytes, as a recipe has it.

use super::recipe::{Cosine, POWER, Recipe, Rounding, Transfer};
use super::surface::{Object, Surfel};
use crate::film::Film;

/// A pixel as a recipe draws it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drawn {
    pub rgb: [u8; 3],
    /// What most of the pixel shows.
    pub object: Object,
    /// Whether a light shines on all of it.
    pub is_lit: bool,
}

impl Recipe {
    /// The radiance of white where this surfel is; what a colour is multiplied by.
    pub fn irradiance(&self, surfel: &Surfel) -> f64 {
        let Some(index) = surfel.object.index() else {
            return 0.0;
        };
        let facing = if self.light_at_eye {
            surfel.slope
        } else {
            surfel.cosine
        };
        let casts = self.viewpoint.shadow.is_some() && !self.light_at_eye;
        if casts && (surfel.is_shadowed || facing <= 0.0) {
            return 0.0;
        }
        let facing = f64::from(if self.flipped[index] { -facing } else { facing });
        let cosine = match self.cosine {
            Cosine::Clamped if facing > 0.0 => facing,
            Cosine::Clamped => 0.0,
            Cosine::Signed => facing,
            Cosine::Absolute => facing.abs(),
        };
        if self.light_at_eye {
            self.power * cosine
        } else {
            let distance = f64::from(surfel.distance);
            let divisor = match self.falloff {
                0 => 1.0,
                1 => distance,
                _ => distance * distance,
            };
            self.power * POWER * cosine / divisor
        }
    }

    /// The pixel of these surfels.
    pub fn draw(&self, surfels: &[Surfel]) -> Drawn {
        let (Some(first), Some(last)) = (surfels.first(), surfels.last()) else {
            return self.pixel([0.0; 3], Object::Background, false);
        };
        let mut sum = [0.0; 3];
        for surfel in surfels {
            let radiance = self.radiance(surfel);
            sum = [0, 1, 2].map(|c| sum[c] + radiance[c]);
        }
        let count = surfels.len();
        let radiance = sum.map(|sum| sum / count as f64);
        let same = surfels.iter().filter(|other| other.object == first.object);
        let of_most = if 2 * same.count() >= count {
            first
        } else {
            last
        };
        let is_lit = surfels.iter().all(|surfel| self.irradiance(surfel) > 0.0);
        self.pixel(radiance, of_most.object, is_lit)
    }

    fn radiance(&self, surfel: &Surfel) -> [f64; 3] {
        match surfel.object.index() {
            None => self.background,
            Some(index) => {
                let irradiance = self.irradiance(surfel);
                self.colors[index].map(|color| color * irradiance)
            }
        }
    }

    fn pixel(&self, radiance: [f64; 3], object: Object, is_lit: bool) -> Drawn {
        let [red, green, blue] = radiance.map(|x| self.byte(x));
        let rgb = if self.swapped {
            [blue, green, red]
        } else {
            [red, green, blue]
        };
        Drawn {
            rgb,
            object,
            is_lit,
        }
    }

    /// The byte of a component. A negative one wraps too, as a conversion by way of an integer has
    /// it.
    fn byte(&self, x: f64) -> u8 {
        let x = match self.film {
            Film::Clamp if x <= 0.0 => return 0,
            Film::Clamp if x >= 1.0 => return 255,
            _ => self.transfer.encode(x),
        };
        let level = match self.rounding {
            Rounding::Truncate => 255.0 * x,
            Rounding::Nearest => (255.0 * x).round(),
        };
        // The conversion truncates, and the mask is the remainder of a division by 256.
        (level as i64 & 255) as u8
    }

    /// The radiance that becomes this byte, give or take half a step; above 1 there are others.
    pub fn radiance_of(&self, byte: u8) -> f64 {
        let middle = match self.rounding {
            Rounding::Truncate if byte > 0 && byte < 255 => 0.5,
            _ => 0.0,
        };
        self.transfer.decode((f64::from(byte) + middle) / 255.0)
    }

    /// Which byte of a pixel holds the red, green and blue component.
    pub fn channels(&self) -> [usize; 3] {
        if self.swapped { [2, 1, 0] } else { [0, 1, 2] }
    }
}

impl Transfer {
    /// The curves other than the right one.
    pub const WRONG: [Transfer; 2] = [Transfer::Srgb, Transfer::Power];
}
