//! Which contenders run, and on which pictures.

use super::way::{Contender, LAB, Way};
use crate::case::Case;
use crate::error::Result;
use ombrage::{Level, Plane, PointLight, Quality, Scene, Shadow, ShadowQuery, Size, Sphere, lab};

/// What a run measures.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The sizes at which Figure 3(c) is computed in every way; at sizes other than the first, in
    /// both chains and proven only.
    pub sizes: Vec<Size>,
    /// The sizes between which the growth with pixels is measured.
    pub growing_sizes: Vec<Size>,
    /// The numbers of spheres for the growth with spheres, rising.
    pub spheres: Vec<usize>,
    /// About how many seconds each picture is measured in each format, at least.
    pub seconds: f64,
}

impl Plan {
    /// Everything, in about a minute.
    ///
    /// # Errors
    /// None: all sizes are valid.
    pub fn full() -> Result<Self> {
        let size = |width, height| Size::new(width, height);
        Ok(Self {
            sizes: vec![Size::LAB, size(3840, 2400)?],
            growing_sizes: vec![
                size(60, 40)?,
                size(150, 100)?,
                Size::LAB,
                size(1200, 800)?,
                size(2400, 1600)?,
            ],
            spheres: vec![1, 2, 4, 8, 16, 32, 64, 256, 1024, 4096, 10_000],
            seconds: 1.0,
        })
    }

    /// A first look, in a few seconds: one size, few spheres.
    ///
    /// # Errors
    /// None: all sizes are valid.
    pub fn quick() -> Result<Self> {
        Ok(Self {
            sizes: vec![Size::LAB],
            growing_sizes: vec![Size::new(150, 100)?, Size::LAB],
            spheres: vec![1, 8, 64],
            seconds: 0.2,
        })
    }
}

/// The baseline, and both chains and the proof at every level and on two threads.
pub fn levels() -> Vec<Contender> {
    let mut contenders = vec![baseline()];
    for way in [LAB, Way::Relative, Way::Proven] {
        contenders.extend(Level::available().map(|level| Contender::new(way, level)));
        contenders.push(Contender::new(way, Level::best()).on_two_threads());
    }
    contenders
}

/// The lab's chain in other qualities, with other questions and with other strategies.
pub fn variants() -> Vec<Contender> {
    let (ulp, textbook, any) = (Shadow::UlpOffset, Quality::Textbook, ShadowQuery::Any);
    let best = Level::best();
    let mut contenders = vec![];
    for quality in [Quality::Stable, Quality::Wide] {
        contenders.push(Contender::new(Way::Lab(ulp, quality, any), best));
    }
    for level in [Level::Scalar, best] {
        let nearest = Way::Lab(ulp, textbook, ShadowQuery::Nearest);
        contenders.push(Contender::new(nearest, level));
    }
    for shadow in Shadow::ALL.into_iter().filter(|shadow| *shadow != ulp) {
        contenders.push(Contender::new(Way::Lab(shadow, textbook, any), best));
    }
    contenders
}

/// Both chains one by one and at the best level; where there are many spheres the hierarchy too,
/// else the default on two threads.
pub fn growth(with_spheres: bool) -> Vec<Contender> {
    let mut contenders = vec![baseline()];
    for level in [Level::Scalar, Level::best()] {
        contenders.push(Contender::new(LAB, level));
        if with_spheres {
            contenders.push(Contender::new(Way::Hierarchy, level));
            let nearest = Way::Lab(Shadow::UlpOffset, Quality::Textbook, ShadowQuery::Nearest);
            contenders.push(Contender::new(nearest, level));
        }
        contenders.push(Contender::new(Way::Relative, level));
    }
    if !with_spheres {
        contenders.push(Contender::new(Way::Relative, Level::best()).on_two_threads());
    }
    contenders.dedup();
    contenders
}

fn baseline() -> Contender {
    Contender::new(Way::Baseline, Level::Scalar)
}

/// Figure 3(c) at a size.
///
/// # Errors
/// None: the lab's scene is valid.
pub fn figure(size: Size) -> Result<Case> {
    Ok(Case {
        name: "3c".into(),
        scene: lab::scene()?,
        view: lab::view(),
        size,
    })
}

/// The lab's plane under so many spheres, which share a box and become smaller the more they are.
/// Every number is one of `f32`.
///
/// # Errors
/// None: every part is valid.
pub fn spheres(count: usize) -> Result<Case> {
    let vector = glam::DVec3::new;
    let rounded = |x: f64| (x * 1024.0).round() / 1024.0;
    let radius = rounded((count as f64).cbrt().recip());
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    // Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8 (2003).
    let mut within = |low: f64, high: f64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        rounded(low + (high - low) * (state >> 11) as f64 / (1u64 << 53) as f64)
    };
    let lab = lab::scene::<f64>()?;
    let mut scene = Scene::new(lab.background(), lab.t_max())?;
    for _ in 0..count {
        let center = vector(within(-4.0, 4.0), within(-1.75, 2.5), within(2.0, 10.0));
        let color = vector(within(0.0, 1.0), within(0.0, 1.0), within(0.0, 1.0));
        scene = scene.with_sphere(Sphere::new(center, radius)?, color)?;
    }
    let plane = Plane::new(vector(0.0, -2.0, 0.0), vector(0.0, 1.0, 0.0))?;
    let light = PointLight::new(vector(1.0, 10.0, 1.0), vector(1.0, 1.0, 1.0), 100.0)?;
    Ok(Case {
        name: "spheres".into(),
        scene: scene
            .with_plane(plane, vector(1.0, 0.0, 0.0))?
            .with_light(light),
        view: lab::view(),
        size: Size::new(64, 48)?,
    })
}
