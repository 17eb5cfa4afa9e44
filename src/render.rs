//! Pictures from scenes: one primary ray a pixel, row by row.

use crate::camera::PerspectiveCamera;
use crate::film::Film;
use crate::integrator::Integrator;
use crate::picture::{Picture, Size};
use crate::quality::Quality;
use crate::real::Scalar;
use crate::scene::Scene;
use crate::vector::Vector;

/// Where on the viewport a pixel's ray goes, along one axis: `index / (count - 1)`, from 0 for the
/// first column or row to 1 for the last; the middle where there is only one.
#[inline(always)]
pub fn position<S: Scalar>(index: u32, count: u32) -> S {
    if count == 1 {
        S::from_f64(0.5)
    } else {
        S::from_f64(f64::from(index)) / S::from_f64(f64::from(count - 1))
    }
}

/// Renders a scene to bytes: width x height x 3, row-major.
pub fn render<S: Scalar>(
    scene: &Scene<S>,
    camera: &PerspectiveCamera<S>,
    size: Size,
    integrator: Integrator,
    film: Film,
) -> Picture {
    let mut bytes = Vec::with_capacity(3 * size.pixels());
    render_radiance(scene, camera, size, integrator, |radiance| {
        bytes.extend(radiance.to_array().map(|x| film.byte(x).to_f64() as u8));
    });
    Picture::from_rendering(size, bytes)
}

/// Renders a scene to linear radiance, pixel by pixel, row-major, upper left first.
pub fn render_radiance<S: Scalar>(
    scene: &Scene<S>,
    camera: &PerspectiveCamera<S>,
    size: Size,
    integrator: Integrator,
    pixel: impl FnMut(S::Vector),
) {
    let rows = |quality| (scene, camera, size, integrator.with_quality(quality));
    // A copy of the loop for each quality, so that the widest kernel does not slow down the others.
    match integrator.quality() {
        Quality::Textbook => render_rows(rows(Quality::Textbook), pixel),
        Quality::Stable => render_rows(rows(Quality::Stable), pixel),
        Quality::Wide => render_rows(rows(Quality::Wide), pixel),
    }
}

/// Every row of a picture, by an integrator whose quality the compiler knows.
#[inline(always)]
fn render_rows<S: Scalar>(
    (scene, camera, size, integrator): (&Scene<S>, &PerspectiveCamera<S>, Size, Integrator),
    mut pixel: impl FnMut(S::Vector),
) {
    let columns: Vec<S> = (0..size.width())
        .map(|i| position(i, size.width()))
        .collect();
    for row in 0..size.height() {
        let sy = position(row, size.height());
        for &sx in &columns {
            pixel(integrator.radiance(scene, &camera.ray(sx, sy)));
        }
    }
}
