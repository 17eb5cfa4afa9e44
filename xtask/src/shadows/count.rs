//! What a strategy gets wrong, pixel by pixel.

use crate::truth::TruePixel;
use ombrage::{Pixel, Size};
use serde::{Deserialize, Serialize};

/// How many pixels a strategy gets wrong, of those that show the same surface as the truth and that
/// the light stands before; per light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Wrong {
    /// Pixels judged: one shadow ray each.
    pub rays: usize,
    /// Falsely black, and only the surface itself blocks.
    pub acne: usize,
    /// Falsely black: another object blocks.
    pub false_shadow: usize,
    /// Falsely lit.
    pub leak: usize,
    /// Falsely black since the surface seems turned away from the light.
    pub turned: usize,
    /// Left out: double-double cannot tell.
    pub undecided: usize,
    /// How far the shadow's edge is off at most, in pixels: the distance from a falsely black or
    /// falsely lit pixel that is no acne to the nearest one that is truly so. `None`: there is
    /// none.
    pub shift: Option<f64>,
}

impl Wrong {
    /// Judges a strategy's pixels by the truth.
    pub fn of(truth: &[TruePixel], pixels: impl Iterator<Item = Pixel>, size: Size) -> Self {
        let mut wrong = Wrong::default();
        let (mut dark, mut light) = (vec![], vec![]);
        for (place, (truth, pixel)) in truth.iter().zip(pixels).enumerate() {
            if truth.surface != pixel.object || !truth.faces_light {
                continue;
            }
            if truth.is_undecided() {
                wrong.undecided += 1;
                continue;
            }
            wrong.rays += 1;
            let lit = pixel.is_lit() && !pixel.blocked_by_itself;
            if lit == truth.is_lit() {
                continue;
            }
            if lit {
                wrong.leak += 1;
                light.push(place);
            } else if pixel.is_acne() {
                wrong.acne += 1;
            } else if pixel.blocked_by_another {
                wrong.false_shadow += 1;
                dark.push(place);
            } else {
                wrong.turned += 1;
            }
        }
        let darkened = farthest(&dark, size, |place| truth[place].is_black());
        let lightened = farthest(&light, size, |place| truth[place].is_lit());
        wrong.shift = [darkened, lightened].into_iter().flatten().reduce(f64::max);
        wrong
    }

    /// The wrong shadows: acne, false shadow and leak.
    pub fn shadows(&self) -> usize {
        self.acne + self.false_shadow + self.leak
    }

    /// Adds another scene's.
    pub fn add(&mut self, other: &Wrong) {
        self.rays += other.rays;
        self.acne += other.acne;
        self.false_shadow += other.false_shadow;
        self.leak += other.leak;
        self.turned += other.turned;
        self.undecided += other.undecided;
        self.shift = [self.shift, other.shift]
            .into_iter()
            .flatten()
            .reduce(f64::max);
    }
}

/// The largest distance, in pixels, from one of these places to the nearest pixel that `holds`.
///
/// The exact distance transform in two passes: along the columns for all pixels, then along the row
/// of each place.
fn farthest(places: &[usize], size: Size, holds: impl Fn(usize) -> bool) -> Option<f64> {
    if places.is_empty() {
        return None;
    }
    let (width, height) = (size.width() as usize, size.height() as usize);
    let mut above = vec![f64::INFINITY; width * height];
    for rows in [(0..height).collect::<Vec<_>>(), (0..height).rev().collect()] {
        let mut distance = vec![f64::INFINITY; width];
        for row in rows {
            for (column, distance) in distance.iter_mut().enumerate() {
                let place = row * width + column;
                *distance = if holds(place) { 0.0 } else { *distance + 1.0 };
                above[place] = above[place].min(*distance);
            }
        }
    }
    let nearest = |&place: &usize| {
        let (row, column) = (place / width, place % width);
        let squares = (0..width).map(|x| {
            let (across, along) = (x as f64 - column as f64, above[row * width + x]);
            across * across + along * along
        });
        squares.fold(f64::INFINITY, f64::min).sqrt()
    };
    let distances = places.iter().map(nearest).filter(|x| x.is_finite());
    distances.reduce(f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_farthest_place_counts() {
        let size = Size::new(5, 4).expect("a size");
        let holds = |place| place == 0 || place == 14;
        // (3, 0) is 3 from (0, 0) and √5 from (4, 2).
        let distance = farthest(&[3, 13], size, holds).expect("a distance");
        assert!((distance - 5f64.sqrt()).abs() < 1e-12, "{distance}");
        assert_eq!(farthest(&[], size, holds), None);
        assert_eq!(farthest(&[3], size, |_| false), None);
    }
}
