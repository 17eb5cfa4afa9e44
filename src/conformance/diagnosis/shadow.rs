//! Where the shadow's edge lies: at full resolution, and only there.

use super::evidence::{Evidence, tiles_of};
use super::recipe::{Recipe, ShadowRay};
use super::refine::shadow_rays;
use super::shade::Drawn;
use super::surface::{Object, Region};
use crate::error::Invalid;
use crate::picture::{Picture, Size};

/// Shorter offsets, in scene units, move no shadow that one could see.
const SHORTEST: f64 = 0.002;

/// What a displacement must gain, in levels of all pixels together: a dozen pixels that turn from
/// shadow to light in a picture as wide as the lab's; fewer in one whose shadow has fewer.
fn least_gain(picture: &Picture) -> f64 {
    let wide = f64::from(picture.size().width()) / f64::from(Size::LAB.width());
    500.0 * wide.clamp(0.25, 1.0)
}

/// The recipe with the shadow ray that explains the shadow's edge, if one does so clearly better
/// than the exact one.
pub(super) fn displaced(
    picture: &Picture,
    whole: &Evidence,
    recipe: &Recipe,
    drawn: &[Drawn],
) -> Result<Recipe, Invalid> {
    let is_clear = recipe.viewpoint.shadow.is_some() && !recipe.acne[1];
    let Some(around) = shadow_region(whole, recipe, drawn).filter(|_| is_clear) else {
        return Ok(*recipe);
    };
    let regions = tiles_of(picture.size())
        .map(|(.., tile)| tile)
        .filter(|tile| overlap(*tile, around))
        .collect();
    let evidence = Evidence::new(picture, regions, whole.loss);
    let pixels = evidence.observed.len() as f64;
    let least_gain = least_gain(picture);
    let mut exact = *recipe;
    exact.viewpoint.shadow = Some(ShadowRay::default());
    let error = evidence.error(&exact)?;
    if error * pixels < least_gain || !is_worth_a_walk(&evidence, &exact, error)? {
        return Ok(exact);
    }
    let [offset, shift, light] = shadow_rays(&evidence, recipe)?;
    let is_better = |other: f64| other < 0.8 * error && (error - other) * pixels > least_gain;
    let beside = if light.1 < 0.9 * shift.1 {
        light
    } else {
        shift
    };
    let is_offset = offset.1 <= 1.2 * beside.1 + 0.02;
    let length = offset.0.viewpoint.shadow.unwrap_or_default().offset;
    Ok(if is_offset && is_better(offset.1) && length >= SHORTEST {
        offset.0
    } else if !is_offset && is_better(beside.1) {
        beside.0
    } else {
        exact
    })
}

/// Whether some displacement brings the shadow nearer.
fn is_worth_a_walk(evidence: &Evidence, exact: &Recipe, error: f64) -> Result<bool, Invalid> {
    let offsets = [0.02, 0.1, 0.4].map(|offset| (offset, [0.0; 2]));
    let shifts = [
        [0.1, 0.0],
        [-0.1, 0.0],
        [0.0, 0.1],
        [0.0, -0.1],
        [0.0, -0.5],
        [0.5, 0.0],
    ];
    for (offset, shift) in offsets.into_iter().chain(shifts.map(|shift| (0.0, shift))) {
        let mut tried = *exact;
        tried.viewpoint.shadow = Some(ShadowRay {
            offset,
            shift,
            ..ShadowRay::default()
        });
        if evidence.error(&tried)? < 0.97 * error {
            return Ok(true);
        }
    }
    Ok(false)
}

/// The part of the plane that is in shadow, where the recipe or the picture has it.
fn shadow_region(whole: &Evidence, recipe: &Recipe, drawn: &[Drawn]) -> Option<Region> {
    let dark = |rgb: [u8; 3]| rgb.into_iter().max().unwrap_or(0) < 12;
    let channel = recipe.channels()[0];
    let pixels = drawn.iter().zip(&whole.observed).enumerate();
    let shadow: Vec<usize> = pixels
        .filter(|(_, (pixel, observed))| {
            let in_picture = pixel.rgb[channel] > 40 && dark(**observed);
            pixel.object == Object::Plane && (!pixel.is_lit || in_picture)
        })
        .map(|(at, _)| at)
        .collect();
    super::fit::around(&shadow, whole.size.width())
}

fn overlap(a: Region, b: Region) -> bool {
    let apart = |a: u32, width: u32, b: u32, other: u32| a + width + 1 < b || b + other + 1 < a;
    !apart(a.left, a.width, b.left, b.width) && !apart(a.top, a.height, b.top, b.height)
}
