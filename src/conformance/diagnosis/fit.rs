//! How well a recipe explains a whole picture.

use super::evidence::{Evidence, TILE, distance};
use super::recipe::Recipe;
use super::shade::Drawn;
use super::surface::Region;
use std::collections::HashMap;

/// What a recipe leaves unexplained.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fit {
    /// The part of the pixels that nothing near them explains.
    pub unexplained: f64,
    /// The mean error of the pixels away from silhouettes, in levels.
    pub inside: f64,
    /// How much of that is no noise: it does not cancel out over a tile.
    pub bias: f64,
}

/// Neighbours that differ by more make a silhouette.
const SILHOUETTE: u8 = 12;

impl Fit {
    /// Compares a whole picture with its prediction. A silhouette may lie a pixel beside where the
    /// recipe has it; acne may not hide behind its neighbours.
    pub fn of(evidence: &Evidence, recipe: &Recipe, predicted: &[Drawn]) -> Self {
        let tolerance = evidence.loss.tolerance();
        let reach = if tolerance > 0 { 2 } else { 1 };
        let size = evidence.size;
        let (width, height) = (size.width() as usize, size.height() as usize);
        let (mut unexplained, mut inside, mut error) = (0_usize, 0_usize, 0.0);
        let mut sums: HashMap<(usize, usize), [i32; 3]> = HashMap::new();
        for (at, (pixel, &observed)) in predicted.iter().zip(&evidence.observed).enumerate() {
            let (x, y) = (at % width, at / width);
            let (mut low, mut high) = (pixel.rgb, pixel.rgb);
            for row in y.saturating_sub(reach)..(y + reach + 1).min(height) {
                for column in x.saturating_sub(reach)..(x + reach + 1).min(width) {
                    let near = predicted[row * width + column].rgb;
                    low = [0, 1, 2].map(|c| low[c].min(near[c]));
                    high = [0, 1, 2].map(|c| high[c].max(near[c]));
                }
            }
            let off = evidence.pixel_error(recipe, pixel, observed);
            let near_enough = (0..3).all(|c| {
                observed[c] >= low[c].saturating_sub(2 + tolerance)
                    && observed[c] <= high[c].saturating_add(2 + tolerance)
            });
            let is_explained = near_enough || off <= explained_error(evidence);
            unexplained += usize::from(!is_explained);
            if distance(low, high) <= SILHOUETTE {
                inside += 1;
                error += off;
                let tile = (x / TILE as usize, y / TILE as usize);
                let sum = sums.entry(tile).or_default();
                *sum = [0, 1, 2].map(|c| sum[c] + i32::from(pixel.rgb[c]) - i32::from(observed[c]));
            }
        }
        let largest = |sum: &[i32; 3]| sum.iter().map(|c| c.abs()).max().unwrap_or(0);
        let biased: i32 = sums.values().map(largest).sum();
        Self {
            bias: f64::from(biased) / inside.max(1) as f64,
            unexplained: unexplained as f64 / predicted.len().max(1) as f64,
            inside: error / inside.max(1) as f64,
        }
    }

    /// Whether the recipe explains the picture. Rays through random places in a pixel make noise;
    /// what does not cancel out is an error.
    pub fn is_good(&self, evidence: &Evidence, recipe: &Recipe) -> bool {
        let tolerance = f64::from(evidence.loss.tolerance());
        let lost = tolerance > 0.0;
        let has_acne = recipe.acne.contains(&true);
        let most = match (lost, has_acne) {
            (false, _) => 0.003,
            (true, false) => 0.008,
            // Black pixels ring where JPEG has stored them.
            (true, true) => 0.03,
        };
        let lossy = if lost { 0.1 + tolerance / 40.0 } else { 0.0 };
        let acne = if has_acne { 3.5 + tolerance } else { 0.0 };
        self.unexplained <= most
            && self.inside <= 0.5 + lossy + acne
            && (has_acne || self.bias <= 0.12 + lossy)
    }
}

/// The error of a pixel that acne explains.
fn explained_error(evidence: &Evidence) -> f64 {
    3.0 + f64::from(evidence.loss.tolerance()) / 2.0
}

/// The pixels in which two pictures differ by more than `tolerance`, and the smallest rectangle
/// around them.
pub(super) fn difference(
    a: &[Drawn],
    b: &[Drawn],
    width: u32,
    tolerance: u8,
) -> (Vec<usize>, Option<Region>) {
    let differing: Vec<usize> = a
        .iter()
        .zip(b)
        .enumerate()
        .filter(|(_, (a, b))| distance(a.rgb, b.rgb) > tolerance)
        .map(|(at, _)| at)
        .collect();
    let region = around(&differing, width);
    (differing, region)
}

/// The smallest rectangle around pixels, each given by its place in a picture.
pub(super) fn around(pixels: &[usize], width: u32) -> Option<Region> {
    let places = pixels.iter().map(|&at| {
        let (x, y) = (at % width as usize, at / width as usize);
        (x as u32, y as u32)
    });
    let bounds = places.fold(None, |bounds, (x, y)| {
        let [left, top, right, bottom] = bounds.unwrap_or([x, y, x, y]);
        Some([left.min(x), top.min(y), right.max(x), bottom.max(y)])
    });
    bounds.map(|[left, top, right, bottom]| Region {
        left,
        top,
        width: right - left + 1,
        height: bottom - top + 1,
    })
}
