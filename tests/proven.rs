//! Proven pictures: complete, the same on every machine, and false as soon as a bound is too small.

mod support {
    pub mod snapshot;
}

use glam::{DVec3, dvec3};
use ombrage::{
    Engine, FIGURES, Figure, Film, Invalid, Level, Lighting, Plane, PointLight, Proof, Proven,
    Prover, Relative, Rigorous, Rung, Scene, Size, Sphere, View, lab, render, render_proven,
};
use std::num::NonZero;
use support::snapshot;

fn size(width: u32, height: u32) -> Size {
    Size::new(width, height).expect("a size")
}

fn figure(name: &str, size: Size) -> Proven {
    let figure = Figure::named(name).expect("a figure");
    let proven = figure.prove_with(size, Engine::default());
    proven
        .expect("valid")
        .expect("a figure without errors of rounding")
}

#[test]
fn every_byte_of_the_figures_is_proven() {
    for name in FIGURES
        .iter()
        .filter(|f| f.lighting().is_some())
        .map(|f| f.name)
    {
        let proven = figure(name, Size::LAB);
        assert_eq!(proven.undecided(), [], "figure {name}");
        assert!(proven.count(Rung::F32) > 239_000, "figure {name}");
    }
    assert!(Figure::named("3a").is_some_and(|figure| figure.lighting().is_none()));
}

/// The accepted pictures: of these, no byte may ever change.
#[test]
fn the_proven_figures_are_the_accepted_pictures() {
    for name in ["1", "2a", "2b", "3c"] {
        let file = format!("figure-{name}-proven.png");
        let picture = figure(name, Size::LAB).into_picture();
        snapshot::picture_settings(&file).bind(|| {
            insta::assert_binary_snapshot!(&file, snapshot::png(&picture));
        });
    }
}

/// The middle rows and columns of these pictures look exactly past the sphere, or at its middle.
#[test]
fn exact_ties_are_decided() {
    for (width, height) in [(9, 9), (801, 801), (1, 1), (3, 1), (1, 7)] {
        for name in ["1", "2a", "2b", "3c"] {
            let proven = figure(name, size(width, height));
            assert_eq!(proven.undecided(), [], "figure {name} at {width}x{height}");
        }
    }
    assert!(
        figure("3c", size(9, 9)).count(Rung::Exact) > 0,
        "no tie in 9x9"
    );
    assert!(
        figure("3c", size(801, 801)).count(Rung::Exact) > 0,
        "no tie in 801x801"
    );
}

/// More lights than a bound in f32 may add up are left to f64; the picture is the same.
#[test]
fn many_lights_are_not_added_up_in_f32() -> Result<(), Invalid> {
    for (count, in_single) in [(1000, true), (1001, false)] {
        let mut scene = Scene::new(DVec3::ZERO, f64::INFINITY)?
            .with_plane(Plane::new(dvec3(0.0, 0.0, 5.0), -DVec3::Z)?, DVec3::ONE)?;
        for i in 0..count {
            let place = dvec3(f64::from(i % 40) - 20.0, f64::from(i / 40) - 12.0, -1.0);
            scene = scene.with_light(PointLight::new(place, DVec3::ONE, 0.03)?);
        }
        let view = View {
            position: DVec3::ZERO,
            look_at: DVec3::Z,
            up: DVec3::Y,
            fov: 60.0,
        };
        let (size, lighting) = (size(7, 5), Lighting::Unshadowed);
        let proven = render_proven(&scene, &view, size, lighting, Film::Clamp)?;
        assert_eq!(proven.undecided(), []);
        assert_eq!(proven.count(Rung::F32) > 0, in_single, "{count} lights");
        let all: usize = Rung::ALL.map(|rung| proven.count(rung)).into_iter().sum();
        assert_eq!(all, size.pixels());
        let chain = Relative::<f64>::new(&scene, &view, size, lighting)?;
        assert!(*proven.picture() == render(&chain, size, Film::Clamp));
    }
    Ok(())
}

/// Radiance at the border of two bytes, or below it by 2^-104, which no double-double tells.
#[test]
fn borders_of_bytes_are_decided() -> Result<(), Invalid> {
    let tiny = f64::EPSILON;
    for (color, power, clamped, wrapped) in [
        ([2.0, 1.0, 0.5], 1.0, [255, 255, 127], [254, 255, 127]),
        (
            [1.0 - tiny, 0.0, 1.0],
            1.0 + tiny,
            [254, 0, 255],
            [254, 0, 255],
        ),
        (
            [2.0 - 2.0 * tiny, 4.0, 1.0],
            1.0 + tiny,
            [255, 255, 255],
            [253, 252, 255],
        ),
    ] {
        // The middle ray and the light meet the plane at a right angle, the light at distance 1.
        let scene = Scene::new(DVec3::ZERO, f64::INFINITY)?
            .with_plane(Plane::new(dvec3(0.0, 0.0, 5.0), -DVec3::Z)?, color.into())?
            .with_light(PointLight::new(dvec3(0.0, 0.0, 4.0), DVec3::ONE, power)?);
        let view = View {
            position: DVec3::ZERO,
            look_at: DVec3::Z,
            up: DVec3::Y,
            fov: 90.0,
        };
        for (film, bytes) in [(Film::Clamp, clamped), (Film::Wrap, wrapped)] {
            let lighting = Lighting::Unshadowed;
            let proven = render_proven(&scene, &view, size(1, 1), lighting, film)?;
            assert_eq!(proven.undecided(), [], "{film:?} {color:?}");
            assert_eq!(
                proven.picture().pixel(0, 0),
                Some(bytes),
                "{film:?} {color:?}"
            );
            let is_exact = proven.count(Rung::Exact) == 1;
            assert!(is_exact || film == Film::Clamp, "{color:?}");
        }
    }
    Ok(())
}

/// Looking along the edges of a cube, every pixel is a number of a few square roots.
#[test]
fn ties_of_other_angles() -> Result<(), Invalid> {
    let scene = Scene::new(DVec3::splat(0.25), f64::INFINITY)?
        .with_sphere(Sphere::new(dvec3(0.0, 0.0, 5.0), 3.0)?, DVec3::ONE)?
        .with_plane(Plane::new(dvec3(0.0, -1.0, 0.0), DVec3::Y)?, DVec3::ONE)?
        .with_light(PointLight::new(dvec3(0.0, 4.0, 0.0), DVec3::ONE, 16.0)?);
    // A right angle: the middle of the right edge is at 45 degrees. 3-4-5: tangent at 3/4.
    for (fov, side) in [(90.0, 9), (60.0, 5), (30.0, 5), (120.0, 7), (73.7, 5)] {
        let (position, look_at) = (DVec3::ZERO, DVec3::Z);
        let view = View {
            position,
            look_at,
            up: DVec3::Y,
            fov,
        };
        let proven = render_proven(
            &scene,
            &view,
            size(side, side),
            Lighting::Shadowed,
            Film::Clamp,
        )?;
        assert_eq!(proven.undecided(), [], "{fov} degrees");
    }
    Ok(())
}

/// From its middle, all of a sphere is hit at a right angle: by the eye's light every byte is at its border.
/// The tangent of an angle that is no simple number is known by its bounds alone, which do not tell.
#[test]
fn what_nothing_decides_is_named() -> Result<(), Invalid> {
    let sphere = Sphere::new(DVec3::ZERO, 2.0)?;
    let scene = Scene::new(DVec3::ZERO, f64::INFINITY)?.with_sphere(sphere, DVec3::ONE)?;
    let view = View {
        position: DVec3::ZERO,
        look_at: DVec3::Z,
        up: DVec3::Y,
        fov: 77.0,
    };
    let proven = render_proven(&scene, &view, size(3, 1), Lighting::Eye, Film::Clamp)?;
    let places: Vec<(u32, u32)> = proven
        .undecided()
        .iter()
        .map(|pixel| (pixel.column, pixel.row))
        .collect();
    assert_eq!(places, [(0, 0), (2, 0)]);
    assert_eq!(
        proven.rungs(),
        [Rung::Undecided, Rung::Exact, Rung::Undecided]
    );
    assert_eq!(proven.picture().pixel(0, 0), Some([0; 3]));
    assert_eq!(proven.picture().pixel(1, 0), Some([255; 3]));
    Ok(())
}

#[test]
fn every_engine_gives_the_same_proof() {
    let (scene, view) = (lab::scene().expect("valid"), lab::view());
    let size = size(331, 77);
    let prove = |engine: Engine| {
        engine
            .render_proven(&scene, &view, size, Lighting::Shadowed, Film::Clamp)
            .expect("valid")
    };
    let expected = prove(Engine::new(Level::Scalar, NonZero::new(1)).expect("always there"));
    for level in Level::available() {
        for threads in [1, 3] {
            let engine = Engine::new(level, NonZero::new(threads)).expect("available");
            assert!(prove(engine) == expected, "{level} on {threads} threads");
        }
    }
}

/// Plain pictures in double-double err by about 1e-30, so they are the proven ones but for ties.
#[test]
fn the_proven_picture_is_that_of_double_double() {
    let (scene, view) = (lab::scene().expect("valid"), lab::view());
    let size = size(120, 80);
    for (lighting, film) in [
        (Lighting::Eye, Film::Clamp),
        (Lighting::Unshadowed, Film::Wrap),
        (Lighting::Shadowed, Film::Clamp),
    ] {
        let proven = render_proven(&scene, &view, size, lighting, film).expect("valid");
        let chain = Relative::<ombrage::DoubleDouble>::new(&scene, &view, size, lighting);
        let plain = render(&chain.expect("valid"), size, film);
        let rungs = proven.rungs();
        let exact = |i: usize| rungs[i / 3] == Rung::Exact;
        let bytes = proven
            .picture()
            .bytes()
            .iter()
            .zip(plain.bytes())
            .enumerate();
        let wrong = bytes.filter(|&(i, (a, b))| a != b && !exact(i)).count();
        assert_eq!(wrong, 0, "{lighting:?}");
    }
}

#[derive(Clone, Copy, Debug)]
struct SmallBounds;
impl Proof for SmallBounds {
    const SUM: f64 = 1.0 / 16.0;
    const PRODUCT: f64 = 1.0 / 16.0;
    const QUOTIENT: f64 = 1.0 / 16.0;
    const ROOT: f64 = 1.0 / 16.0;
}

#[derive(Clone, Copy, Debug)]
struct EarlyComparisons;
impl Proof for EarlyComparisons {
    const COMPARES_VALUES: bool = true;
}

#[derive(Clone, Copy, Debug)]
struct EarlyChoices;
impl Proof for EarlyChoices {
    const CHOOSES_POSSIBLE: bool = true;
}

/// How many pixels of Figure 3(c) moved off the grid are proven in `f32`, and how many of them
/// wrongly.
fn wrongly_proven<P: Proof>() -> [usize; 2] {
    let (scene, view) = (lab::scene().expect("valid"), lab::view());
    let (mut proven, mut wrong) = (0, 0);
    for size in [size(600, 400), size(801, 801)] {
        let (lighting, film) = (Lighting::Shadowed, Film::Clamp);
        let truth = render_proven(&scene, &view, size, lighting, film).expect("valid");
        let prover = Prover::<f32, P>::new(&scene, &view, size, lighting, film).expect("valid");
        for row in 0..size.height() {
            for column in 0..size.width() {
                if let Some(bytes) = prover.pixel(column, row) {
                    proven += 1;
                    wrong += usize::from(truth.picture().pixel(column, row) != Some(bytes));
                }
            }
        }
    }
    [proven, wrong]
}

#[test]
fn a_proof_that_proves_too_much_is_found_out() {
    let [proven, wrong] = wrongly_proven::<Rigorous>();
    assert!(proven > 880_000 && wrong == 0, "{wrong} of {proven} wrong");
    for [proven, wrong] in [
        wrongly_proven::<SmallBounds>(),
        wrongly_proven::<EarlyComparisons>(),
        wrongly_proven::<EarlyChoices>(),
    ] {
        assert!(wrong > 0, "none of {proven} wrong");
    }
}
