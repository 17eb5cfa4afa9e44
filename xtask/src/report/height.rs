//! Acne against the height of the plane: how much of it there is, is a matter of luck.

use crate::case::Case;
use crate::error::Result;
use crate::parallel;
use crate::shadows::Hits;
use glam::DVec3;
use ombrage::{Pixel, Plane, Quality, Scalar, Scene, Shadow, Size, lab};
use serde::{Deserialize, Serialize};

/// The lab's scene with its plane at another height, in pictures of 300 x 200 pixels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Height {
    /// The y of the plane.
    pub y: f64,
    /// How much of it is acne in `f32`.
    pub f32: Acne,
    /// The same in `f64`.
    pub f64: Acne,
}

/// How many pixels of the plane are lit in truth, and how many of those are falsely black.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Acne {
    /// Pixels of the plane that the light reaches.
    pub lit: usize,
    /// Falsely black where hits count from 0 on, 0 included.
    pub closed: usize,
    /// Falsely black where hits count from 0 on, 0 excluded.
    pub open: usize,
}

/// The heights: from -1.1, just below the sphere, to -4 in steps of a tenth.
fn heights() -> Vec<f64> {
    (11..=40).map(|tenths| -f64::from(tenths) / 10.0).collect()
}

/// Measures all heights.
///
/// # Errors
/// None: the scene is valid with a plane at any height.
pub fn measure() -> Result<Vec<Height>> {
    parallel::map(&heights(), |&y| measure_at(y))
}

/// Measures one height.
///
/// # Errors
/// None: the scene is valid with a plane at any height.
pub fn measure_at(y: f64) -> Result<Height> {
    let case = lab_with_plane_at(y)?;
    Ok(Height {
        y,
        f32: acne::<f32>(&case)?,
        f64: acne::<f64>(&case)?,
    })
}

fn acne<S: Scalar>(case: &Case) -> Result<Acne> {
    let hits = Hits::<S>::new(case, Quality::Textbook)?;
    let count = |shadow| {
        let pixels = hits.verdicts(Some(shadow)).filter(Pixel::on_plane);
        pixels.fold((0, 0), |(lit, acne), pixel| {
            let is_acne = pixel.faces_light && pixel.is_acne();
            (
                lit + usize::from(pixel.is_lit()),
                acne + usize::from(is_acne),
            )
        })
    };
    let (lit, closed) = count(Shadow::SelfHitting);
    let (_, open) = count(Shadow::HalfOpen);
    Ok(Acne { lit, closed, open })
}

fn lab_with_plane_at(y: f64) -> Result<Case> {
    let lab = lab::scene::<f64>()?;
    let mut scene = Scene::new(lab.background(), lab.t_max())?;
    for sphere in lab.spheres() {
        scene = scene.with_sphere(sphere.shape, sphere.color())?;
    }
    for plane in lab.planes() {
        let shape = Plane::new(DVec3::new(0.0, y, 0.0), plane.shape.normal())?;
        scene = scene.with_plane(shape, plane.color())?;
    }
    for &light in lab.lights() {
        scene = scene.with_light(light);
    }
    Ok(Case {
        name: format!("plane at {y}"),
        scene,
        view: lab::view(),
        size: Size::new(300, 200)?,
    })
}
