//! How far a picture is from the truth.

use super::subject::Computed;
use crate::truth::TruePixel;
use ombrage::{DoubleDouble, Pixel, Scalar};
use serde::{Deserialize, Serialize};

/// What is wrong with a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// The largest error of a component of the radiance, where nothing flips.
    pub largest: f64,
    /// Its mean over the same components.
    pub mean: f64,
    /// Bytes that differ.
    pub bytes: usize,
    /// Pixels that show another object, one of the two a sphere.
    pub silhouette: usize,
    /// Pixels that show another object, neither of them a sphere.
    pub horizon: usize,
    /// Pixels and lights that are falsely lit or falsely black.
    pub shadow: usize,
}

impl Verdict {
    /// Judges a picture by the true one.
    pub fn of(truth: &Computed<DoubleDouble, TruePixel>, found: &Computed<f64, Pixel>) -> Self {
        let mut verdict = Verdict {
            bytes: differing(truth.picture.bytes(), found.picture.bytes()),
            ..Verdict::default()
        };
        let mut flipped = vec![false; truth.radiance.len()];
        for (light, (truths, pixels)) in truth.lights.iter().zip(&found.lights).enumerate() {
            for ((true_pixel, pixel), flipped) in truths.iter().zip(pixels).zip(&mut flipped) {
                if true_pixel.surface != pixel.object {
                    let objects = [true_pixel.surface, pixel.object];
                    let is_sphere = |object: &usize| *object < truth.spheres;
                    let sphere = objects.iter().flatten().any(is_sphere);
                    verdict.silhouette += usize::from(light == 0 && sphere);
                    verdict.horizon += usize::from(light == 0 && !sphere);
                    *flipped = true;
                } else if truth.casts_shadows && !true_pixel.is_undecided() {
                    let lit = pixel.is_lit() && !pixel.blocked_by_itself;
                    let differs = lit != true_pixel.is_lit();
                    verdict.shadow += usize::from(differs);
                    *flipped |= differs;
                }
            }
        }
        let steady = flipped.iter().map(|flipped| !flipped);
        let pairs = truth.radiance.iter().zip(&found.radiance);
        let (mut sum, mut count) = (0.0, 0);
        for ((truth, found), _) in pairs.zip(steady).filter(|(_, steady)| *steady) {
            for (&truth, &found) in truth.iter().zip(found) {
                let error = (DoubleDouble::from_f64(found) - truth).to_f64().abs();
                verdict.largest = verdict.largest.max(error);
                sum += error;
                count += 1;
            }
        }
        verdict.mean = if count > 0 {
            sum / f64::from(count)
        } else {
            0.0
        };
        verdict
    }
}

/// How many bytes differ.
pub fn differing(a: &[u8], b: &[u8]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a != b).count()
}
