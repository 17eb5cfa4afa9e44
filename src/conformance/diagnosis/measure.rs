//! What can be measured on a picture: colours, and the light's power.

use super::evidence::Evidence;
use super::recipe::Recipe;
use super::surface::{Object, Surfel};
use crate::error::Invalid;

/// Fewer pixels than this measure nothing.
const FEWEST: usize = 24;

/// The background's colour, as the pixels have it that show it in this recipe.
pub(super) fn background(
    evidence: &Evidence,
    recipe: &Recipe,
) -> Result<Option<[f64; 3]>, Invalid> {
    let surfels = evidence.surfels(&recipe.viewpoint)?;
    let of_background = |pixel: &[Surfel]| pixel.iter().all(|s| s.object == Object::Background);
    let pixels = surfels.pixels().zip(&evidence.observed);
    let observed: Vec<[u8; 3]> = pixels
        .filter(|(pixel, _)| of_background(pixel))
        .map(|(_, &observed)| observed)
        .collect();
    if observed.len() < FEWEST {
        return Ok(None);
    }
    let color = recipe.channels().map(|channel| {
        let mut bytes: Vec<u8> = observed.iter().map(|rgb| rgb[channel]).collect();
        let middle = bytes.len() / 2;
        recipe.radiance_of(*bytes.select_nth_unstable(middle).1)
    });
    Ok(Some(color))
}

/// An object's colour: how much of white's radiance its lit pixels have, component by component.
pub(super) fn color(
    evidence: &Evidence,
    recipe: &Recipe,
    object: Object,
) -> Result<Option<[f64; 3]>, Invalid> {
    color_in(&evidence.observed, evidence, recipe, object)
}

/// The same in other pixels than those of the picture.
pub(super) fn color_in(
    pixels: &[[u8; 3]],
    evidence: &Evidence,
    recipe: &Recipe,
    object: Object,
) -> Result<Option<[f64; 3]>, Invalid> {
    let channels = recipe.channels();
    let ratios = channels.map(|channel| ratio(pixels, evidence, recipe, object, channel));
    let [red, green, blue] = ratios;
    Ok(match (red?, green?, blue?) {
        (Some(red), Some(green), Some(blue)) => Some([red, green, blue]),
        _ => None,
    })
}

/// The factor of the recipe's power at which its objects are as bright as in the picture.
pub(super) fn power(evidence: &Evidence, recipe: &Recipe) -> Result<Option<f64>, Invalid> {
    let mut factors = vec![];
    for (object, color) in [Object::Sphere, Object::Plane]
        .into_iter()
        .zip(recipe.colors)
    {
        let brightest = (0..3).max_by(|&a, &b| color[a].total_cmp(&color[b]));
        let Some(component) = brightest.filter(|&component| color[component] > 0.0) else {
            continue;
        };
        let channel = recipe.channels()[component];
        if let Some(ratio) = ratio(&evidence.observed, evidence, recipe, object, channel)? {
            factors.push(ratio / color[component]);
        }
    }
    // The plane is larger, and says more; the sphere speaks where there is no plane.
    Ok(factors.last().copied())
}

/// Observed radiance over white's, of an object's lit pixels.
///
/// Pixels that seem falsely black are left out: of all ratios, the median of those in the upper
/// half of their range counts. Bright pixels may be clamped or wrapped, so the dim ones have the
/// first word: from them it is known which bright ones are not.
fn ratio(
    observed: &[[u8; 3]],
    evidence: &Evidence,
    recipe: &Recipe,
    object: Object,
    channel: usize,
) -> Result<Option<f64>, Invalid> {
    let surfels = evidence.surfels(&recipe.viewpoint)?;
    let pixels = surfels.pixels().zip(observed);
    let mut samples: Vec<(f64, f64)> = pixels
        .filter(|(pixel, _)| pixel.iter().all(|surfel| surfel.object == object))
        .map(|(pixel, observed)| {
            let white: f64 = pixel.iter().map(|surfel| recipe.irradiance(surfel)).sum();
            (
                white / pixel.len() as f64,
                recipe.radiance_of(observed[channel]),
            )
        })
        .filter(|&(white, _)| white > 0.0)
        .collect();
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    let Some(&(dimmest, _)) = samples.get(samples.len() / 50) else {
        return Ok(None);
    };
    let mut ceiling = 8.0 * dimmest;
    let mut ratio = None;
    loop {
        let known = samples.partition_point(|&(white, _)| white <= ceiling);
        let from = samples.partition_point(|&(white, _)| white <= ceiling / 8.0);
        let part = &samples[from..known];
        let ratios = part
            .iter()
            .filter(|(_, seen)| *seen < 0.97)
            .map(|(white, seen)| seen / white);
        if let Some(found) = upper_median(ratios.collect()) {
            ratio = Some(found);
        }
        if known == samples.len() || ratio.is_some_and(|ratio| ratio * ceiling > 0.9) {
            return Ok(ratio);
        }
        ceiling *= 2.0;
    }
}

/// The median of the numbers in the upper half of their range; none of too few.
fn upper_median(mut numbers: Vec<f64>) -> Option<f64> {
    if numbers.len() < FEWEST {
        return None;
    }
    numbers.sort_by(f64::total_cmp);
    let nearly_largest = numbers[numbers.len() * 98 / 100];
    let from = numbers.partition_point(|&x| x < nearly_largest / 2.0);
    let upper = &numbers[from..];
    upper.get(upper.len() / 2).copied()
}
