//! The lab's scene, moved away from the origin: how many bytes of Figure 3(c) each way gets wrong.

use super::subject::develop;
use super::verdict::differing;
use crate::case::{self, Case};
use crate::error::Result;
use crate::parallel;
use crate::table::{Table, grouped};
use glam::DVec3;
use ombrage::{
    Film, Integrator, LabChain, Lighting, Picture, Plane, PointLight, Quality, Relative, Scalar,
    Scene, Shadow, Size, Sphere, View, lab,
};
use serde::{Deserialize, Serialize};

/// Moves along each axis: 10^0 to 10^8. The sum of two whole numbers below 2^53 is exact, so the
/// true picture is that of the scene at its place.
const EXPONENTS: std::ops::RangeInclusive<i32> = 0..=8;

/// Wrong bytes of a picture of 600 x 400 pixels, in the order of the table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// By how much the scene is moved along each axis.
    pub moved_by: f64,
    /// Bytes that differ from the truth, in `f32`.
    pub f32: Wrong,
    /// The same in `f64`.
    pub f64: Wrong,
}

/// Wrong bytes of each way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wrong {
    /// The lab's chain, textbook kernels, offset by units in the last place.
    pub lab: usize,
    /// The lab's chain, stable kernels, the same offset.
    pub stable: usize,
    /// The ray-relative chain.
    pub relative: usize,
}

/// Measures all moves.
///
/// # Errors
/// None: the scene is valid wherever it is.
pub fn measure() -> Result<Vec<Row>> {
    let truth = truth()?;
    let moves: Vec<f64> = EXPONENTS.map(|exponent| 10f64.powi(exponent)).collect();
    parallel::map(&moves, |&moved_by| measure_at(&truth, moved_by))
}

/// The true picture, wherever the scene is.
///
/// # Errors
/// None: the scene is valid.
pub fn truth() -> Result<Picture> {
    case::proven(&moved(0.0)?, Lighting::Shadowed, Film::Clamp)
}

/// Measures one move, a whole number below 2^50.
///
/// # Errors
/// None: the scene is valid wherever it is.
pub fn measure_at(truth: &Picture, moved_by: f64) -> Result<Row> {
    let case = moved(moved_by)?;
    Ok(Row {
        moved_by,
        f32: wrong::<f32>(truth, &case)?,
        f64: wrong::<f64>(truth, &case)?,
    })
}

fn wrong<S: Scalar>(truth: &Picture, case: &Case) -> Result<Wrong> {
    let count = |picture: Picture| differing(truth.bytes(), picture.bytes());
    let offset = |quality| case::direct(quality, Some(Shadow::UlpOffset));
    Ok(Wrong {
        lab: count(by_lab::<S>(case, offset(Quality::Textbook))?),
        stable: count(by_lab::<S>(case, offset(Quality::Stable))?),
        relative: count(relative::<S>(case)?),
    })
}

fn by_lab<S: Scalar>(case: &Case, integrator: Integrator) -> Result<Picture> {
    let (scene, camera) = (case.scene.cast::<S>()?, case.camera::<S>()?);
    let chain = LabChain {
        scene: &scene,
        camera: &camera,
        integrator,
    };
    Ok(develop::<S>(
        &case::radiance(&chain, case.size),
        case.size,
        Film::Clamp,
    ))
}

fn relative<S: Scalar>(case: &Case) -> Result<Picture> {
    let chain = Relative::<S>::new(&case.scene, &case.view, case.size, Lighting::Shadowed)?;
    Ok(develop::<S>(
        &case::radiance(&chain, case.size),
        case.size,
        Film::Clamp,
    ))
}

/// The lab's scene and its camera, moved along each axis.
fn moved(by: f64) -> Result<Case> {
    let by = DVec3::splat(by);
    let (lab, view) = (lab::scene::<f64>()?, lab::view::<f64>());
    let mut scene = Scene::new(lab.background(), lab.t_max())?;
    for sphere in lab.spheres() {
        let shape = Sphere::new(sphere.shape.center() + by, sphere.shape.radius())?;
        scene = scene.with_sphere(shape, sphere.color())?;
    }
    for plane in lab.planes() {
        let shape = Plane::new(plane.shape.point() + by, plane.shape.normal())?;
        scene = scene.with_plane(shape, plane.color())?;
    }
    for light in lab.lights() {
        let position = light.position() + by;
        scene = scene.with_light(PointLight::new(position, light.color(), light.power())?);
    }
    Ok(Case {
        name: format!("lab moved by {}", by.x),
        scene,
        view: View {
            position: view.position + by,
            look_at: view.look_at + by,
            ..view
        },
        size: Size::LAB,
    })
}

/// The table: a row for each move.
pub fn table(rows: &[Row]) -> String {
    let mut table = Table::new(&[
        "moved by",
        "lab f32",
        "stable f32",
        "relative f32",
        "lab f64",
        "stable f64",
        "relative f64",
    ]);
    for row in rows {
        let mut cells = vec![format!("{:.0e}", row.moved_by)];
        for wrong in [&row.f32, &row.f64] {
            let counts = [wrong.lab, wrong.stable, wrong.relative];
            cells.extend(counts.map(|count| grouped(count as u64)));
        }
        table.row(cells);
    }
    let pixels = grouped(Size::LAB.pixels() as u64);
    table.render() + &format!("bytes that differ from the truth, of {pixels} pixels\n")
}
