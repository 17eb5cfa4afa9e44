//! Acne: pixels that are falsely black, judged by how many and how speckled they are.
//!
//! Which pixels they are depends on a program's every rounding, so no hypothesis can predict them.

use super::evidence::Evidence;
use super::recipe::Recipe;
use super::shade::Drawn;
use super::surface::Object;

/// What the lit pixels of one object look like.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Speckle {
    /// Lit pixels well inside the object's lit part.
    pub lit: usize,
    /// Those with less than half of the light that they should have.
    pub dark: usize,
    /// The part of the light that all of them together have, from 0 to 1.
    pub mean: f64,
    /// Those that have some of their light, but not all.
    pub partly: usize,
    /// How much neighbours differ: 1 where each is black or not regardless of the next, near 0
    /// where a surface is evenly darker or a part of it is black.
    pub roughness: f64,
}

/// Bytes below this say too little, and less still where there is loss.
fn dim(tolerance: u8) -> u8 {
    24 + 6 * tolerance
}

impl Speckle {
    /// Looks at a whole picture, predicted without acne.
    pub fn of(evidence: &Evidence, recipe: &Recipe, drawn: &[Drawn], object: Object) -> Self {
        let width = evidence.size.width() as usize;
        let interior = |at: usize| is_interior(drawn, width, at, object);
        let (mut sum, mut steps, mut pairs) = (0.0, 0.0, 0_usize);
        let mut speckle = Speckle::default();
        let mut before = None;
        let dim = dim(evidence.loss.tolerance());
        for (at, pixel) in drawn.iter().enumerate() {
            let channel = brightest(pixel.rgb);
            if pixel.rgb[channel] < dim || !interior(at) {
                before = None;
                continue;
            }
            let [right, seen] = [pixel.rgb, evidence.observed[at]].map(|rgb| rgb[channel]);
            let share = (recipe.radiance_of(seen) / recipe.radiance_of(right)).min(1.0);
            speckle.lit += 1;
            speckle.dark += usize::from(share < 0.5);
            speckle.partly += usize::from(share > 0.08 && share < 0.92);
            sum += share;
            if let Some(before) = before {
                steps += f64::abs(share - before);
                pairs += 1;
            }
            before = Some(share);
        }
        speckle.mean = sum / speckle.lit.max(1) as f64;
        let random = 2.0 * speckle.mean * (1.0 - speckle.mean) * pairs as f64;
        speckle.roughness = if random > 0.0 { steps / random } else { 0.0 };
        speckle
    }

    /// Whether this is acne: dark pixels, or darkened ones, that speckle the object.
    pub fn is_acne(&self, tolerance: u8) -> bool {
        let speckled = self.dark >= FEWEST && self.roughness > 0.3;
        // Loss smooths speckles; the edge of a solid shadow, though, is a little rough as well.
        let rough = match (tolerance > 0, self.mean < 0.8) {
            (false, _) => 0.08,
            (true, true) => 0.042,
            (true, false) => 0.15,
        };
        let darkened = self.mean < 0.95 && self.roughness > rough;
        self.lit >= FEWEST && (speckled || darkened)
    }

    /// Whether pixels are averages: most have a part of their light.
    pub fn is_averaged(&self) -> bool {
        2 * self.partly > self.lit
    }
}

/// Fewer dark pixels than this are no acne, but a rounding here and there.
const FEWEST: usize = 12;

/// The component that says most.
pub(super) fn brightest(rgb: [u8; 3]) -> usize {
    (0..3).max_by_key(|&c| rgb[c]).unwrap_or(0)
}

/// Whether a pixel and its eight neighbours are lit parts of one object.
fn is_interior(drawn: &[Drawn], width: usize, at: usize, object: Object) -> bool {
    let (x, y) = (at % width, at / width);
    let height = drawn.len() / width;
    if x == 0 || y == 0 || x + 1 == width || y + 1 == height {
        return false;
    }
    let rows = [at - width, at, at + width];
    rows.into_iter().all(|row| {
        drawn[row - 1..=row + 1]
            .iter()
            .all(|pixel| pixel.object == object && pixel.is_lit)
    })
}
