//! Where the shadow's edge lies: at full resolution, and only there.

use super::best::Best;
use super::evidence::{Evidence, tiles_of};
use super::fit::around;
use super::recipe::{Recipe, ShadowRay};
use super::shade::Drawn;
use super::surface::{Object, Region};
use crate::error::Invalid;
use crate::picture::{Picture, Size};

/// What a displacement must gain, in levels of all pixels together: a dozen pixels that turn from
/// shadow to light in a picture as wide as the lab's; fewer in one whose shadow has fewer.
pub(super) fn least_gain(size: Size) -> f64 {
    let wide = f64::from(size.width()) / f64::from(Size::LAB.width());
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
    let tiles = tiles_of(picture.size()).map(|(.., tile)| tile);
    let regions = tiles.filter(|tile| tile.meets(around)).collect();
    let evidence = Evidence::new(picture, regions, whole.loss);
    let pixels = evidence.observed.len() as f64;
    let mut exact = *recipe;
    exact.viewpoint.shadow = Some(ShadowRay::default());
    let error = evidence.error(&exact)?;
    let is_enough = |gain: f64| gain * pixels > least_gain(picture.size());
    if !is_enough(error) || !is_worth_a_walk(&evidence, exact)? {
        return Ok(exact);
    }
    let [offset, shift, light] = shadow_rays(&evidence, exact)?;
    // Where both explain it, the origin is off: that is the simpler mistake.
    let is_light = light.error < 0.9 * shift.error;
    let beside = if is_light { light } else { shift };
    let is_offset = offset.error <= 1.2 * beside.error + 0.02;
    let found = if is_offset { offset } else { beside };
    let is_better = found.error < 0.8 * error && is_enough(error - found.error);
    Ok(match is_better {
        true => found.recipe,
        false => exact,
    })
}

/// Moves a number of a shadow ray by a step.
type Turn = fn(&mut ShadowRay, f64);

fn turn_offset(ray: &mut ShadowRay, step: f64) {
    ray.offset = (ray.offset + step).max(0.0);
}

fn turn_shift_x(ray: &mut ShadowRay, step: f64) {
    ray.shift[0] += step;
}

fn turn_shift_z(ray: &mut ShadowRay, step: f64) {
    ray.shift[1] += step;
}

fn turn_light_x(ray: &mut ShadowRay, step: f64) {
    ray.light[0] += step;
}

fn turn_light_z(ray: &mut ShadowRay, step: f64) {
    ray.light[1] += step;
}

/// The same for a recipe.
fn of_recipe(turn: Turn) -> impl Fn(&mut Recipe, f64) {
    move |recipe, step| {
        if let Some(ray) = &mut recipe.viewpoint.shadow {
            turn(ray, step);
        }
    }
}

/// Whether some displacement of the origin brings the shadow nearer. Offsets of less than half of the
/// least that is tried, in scene units, move no shadow that one could see.
pub(super) fn is_worth_a_walk(evidence: &Evidence, exact: Recipe) -> Result<bool, Invalid> {
    let mut best = Best::of(evidence, exact)?;
    let enough = 0.97 * best.error;
    for by in [0.02, 0.1, 0.4] {
        for turn in [turn_offset, turn_shift_x, turn_shift_z] {
            for step in [by, -by] {
                let mut tried = exact;
                of_recipe(turn)(&mut tried, step);
                best.consider(tried)?;
            }
        }
    }
    Ok(best.error < enough)
}

/// The shadow rays that may explain where the shadow's edge is, each the best of its kind: an offset
/// along the normal, a shift of the origin, another place of the light.
pub(super) fn shadow_rays<'a>(
    evidence: &'a Evidence<'a>,
    exact: Recipe,
) -> Result<[Best<'a>; 3], Invalid> {
    let walk = |turns: &[Turn], steps| {
        let turns: Vec<_> = turns.iter().map(|turn| of_recipe(*turn)).collect();
        let mut best = Best::of(evidence, exact)?;
        best.descend(&turns, steps)?;
        Ok(best)
    };
    Ok([
        walk(&[turn_offset], (0.512, 0.0005))?,
        walk(&[turn_shift_x, turn_shift_z], (0.512, 0.002))?,
        walk(&[turn_light_x, turn_light_z], (2.048, 0.01))?,
    ])
}

/// The part of the plane that is in shadow, where the recipe or the picture has it.
pub(super) fn shadow_region(whole: &Evidence, recipe: &Recipe, drawn: &[Drawn]) -> Option<Region> {
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
    around(&shadow, whole.size.width())
}
