//! What shadow rays cost.

use super::strategy::{Hits, Strategy, draw};
use crate::case::{self, Case};
use crate::clock;
use crate::error::Result;
use ombrage::{Lighting, Quality, Scalar, Shadow};
use serde::{Deserialize, Serialize};

/// The times of all strategies on a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Times {
    /// The scene.
    pub scene: String,
    /// The format.
    pub float: String,
    /// Nanoseconds a shadow ray, in the order of [`Strategy::all`]. Of the lab's chain: to make the
    /// ray from a known hit, and to ask the scene. Of sidedness, where a light has no ray of its
    /// own: the time of the picture less that of the picture without shadows.
    pub ns_per_ray: Vec<f64>,
    /// Milliseconds of a whole picture with the offset by units in the last place.
    pub ms_ulp_offset: f64,
    /// Milliseconds of a whole picture of the ray-relative chain.
    pub ms_sidedness: f64,
    /// The latter over the former.
    pub sidedness_over_ulp_offset: f64,
}

/// Pictures of more objects than this are timed small.
const MANY: usize = 16;

/// Takes the time on one thread, one pixel at a time.
///
/// # Errors
/// If the case is invalid in this format.
pub fn take<S: Scalar>(case: &Case, quality: Quality, rounds: usize) -> Result<Times> {
    let objects = case.scene.spheres().len() + case.scene.planes().len();
    let case = case.at_most(if objects > MANY { 75 } else { u32::MAX })?;
    let case = case.held_in::<S>()?;
    let hits = Hits::<S>::new(&case, quality)?;
    let ulp_offset = case::direct(quality, Some(Shadow::UlpOffset));
    let mut tasks = vec![
        draw::<S>(&case, Some(ulp_offset), Lighting::Shadowed)?,
        draw::<S>(&case, None, Lighting::Shadowed)?,
        draw::<S>(&case, None, Lighting::Unshadowed)?,
    ];
    let mut rays = 0;
    for strategy in Strategy::all() {
        if let Strategy::Lab(shadow) = strategy {
            let (task, count) = hits.cast(shadow);
            tasks.push(task);
            rays = count;
        }
    }
    let seconds = clock::interleaved(rounds, &mut tasks);
    let [ulp_offset, sidedness, unshadowed] = [seconds[0], seconds[1], seconds[2]];
    let ns = |seconds: f64| seconds * 1e9 / rays as f64;
    let mut casts = seconds[3..].iter();
    let ns_per_ray = Strategy::all().into_iter().map(|strategy| match strategy {
        Strategy::Lab(_) => ns(casts.next().copied().unwrap_or(f64::NAN)),
        Strategy::Sidedness => ns(sidedness - unshadowed),
    });
    Ok(Times {
        scene: case.name.clone(),
        float: S::NAME.into(),
        ns_per_ray: ns_per_ray.collect(),
        ms_ulp_offset: ulp_offset * 1e3,
        ms_sidedness: sidedness * 1e3,
        sidedness_over_ulp_offset: sidedness / ulp_offset,
    })
}
