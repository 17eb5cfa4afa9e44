//! Scene files: those of the project draw the same picture however they are computed.

use ombrage::{
    Engine, Film, LabChain, Level, Lighting, PerspectiveCamera, Picture, Quality, Relative, Scalar,
    Shadow, Size,
};
use std::fs;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use xtask::case::direct;
use xtask::scene_file::{self, SceneFile};

/// The scene files of the project, sorted.
fn paths() -> Vec<PathBuf> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/scenes");
    let entries = directory.read_dir().expect("a directory");
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    paths
}

fn load(path: &Path) -> SceneFile {
    scene_file::load(path).unwrap_or_else(|error| panic!("{error}"))
}

fn named(name: &str) -> SceneFile {
    let files = paths();
    let path = files
        .iter()
        .find(|path| path.file_stem() == Some(name.as_ref()));
    load(path.expect("a scene"))
}

fn relative<S: Scalar>(file: &SceneFile, size: Size, engine: Engine) -> Picture {
    let chain = Relative::<S>::new(&file.scene, &file.view, size, Lighting::Shadowed);
    engine.render(&chain.expect("a chain"), size, Film::Clamp)
}

/// `None` where the scene does not fit the format.
fn lab<S: Scalar>(
    file: &SceneFile,
    size: Size,
    engine: Engine,
    (quality, shadow): (Quality, Shadow),
) -> Option<Picture> {
    let scene = file.scene.cast::<S>().ok()?;
    let aspect = S::from_f64(size.aspect());
    let camera = PerspectiveCamera::new(&file.view.cast::<S>(), aspect).ok()?;
    let chain = LabChain {
        scene: &scene,
        camera: &camera,
        integrator: direct(quality, Some(shadow)),
    };
    Some(engine.render(&chain, size, Film::Clamp))
}

fn engines() -> Vec<Engine> {
    let threads = [1, 3].map(NonZero::new);
    let with = |level| threads.map(|threads| Engine::new(level, threads).expect("a level"));
    Level::available().flat_map(with).collect()
}

/// How many bytes of two pictures differ by more than `by`.
fn differing(a: &Picture, b: &Picture, by: u8) -> usize {
    assert_eq!(a.size(), b.size());
    let pairs = a.bytes().iter().zip(b.bytes());
    pairs.filter(|(a, b)| a.abs_diff(**b) > by).count()
}

#[test]
fn every_scene_loads_under_its_name() {
    assert!(paths().len() >= 23);
    for path in paths() {
        let stem = path.file_stem().unwrap_or_default();
        assert_eq!(stem, load(&path).name.as_str());
    }
}

#[test]
fn the_documented_example_is_the_scene_of_the_lab() {
    let text = include_str!("../../docs/scenes.md");
    let example = text.split("```").nth(1).expect("an example");
    let directory = tempfile::tempdir().expect("a directory");
    let path = directory.path().join("example.toml");
    fs::write(&path, example.trim_start_matches("toml")).expect("a file");
    for file in [load(&path), named("base")] {
        assert_eq!(file.scene, ombrage::lab::scene().expect("a scene"));
        assert_eq!(file.view, ombrage::lab::view());
        assert_eq!(file.size, Size::LAB);
    }
}

fn bits_are_the_same<S: Scalar>() {
    let size = Size::new(37, 23).expect("a size");
    let scalar = Engine::new(Level::Scalar, NonZero::new(1)).expect("a level");
    let ways = Shadow::ALL.map(|shadow| (Quality::Stable, shadow));
    let figure = (Quality::Textbook, Shadow::UlpOffset);
    for path in paths() {
        let file = load(&path);
        let expected = relative::<S>(&file, size, scalar);
        for engine in engines() {
            let found = relative::<S>(&file, size, engine);
            assert!(found == expected, "{} {engine:?} {}", file.name, S::NAME);
        }
        for way in ways.into_iter().chain([figure]) {
            let expected = lab::<S>(&file, size, scalar, way).expect("a chain");
            for engine in engines() {
                let found = lab::<S>(&file, size, engine, way).expect("a chain");
                let context = format!("{} {engine:?} {} {way:?}", file.name, S::NAME);
                assert!(found == expected, "{context}");
            }
        }
    }
}

#[test]
fn every_level_and_thread_count_draws_the_same_bytes() {
    bits_are_the_same::<f32>();
    bits_are_the_same::<f64>();
}

/// Scenes in which a surface passes through the camera or a light: the lab's closed interval counts
/// hits there, the kit's own chain does not.
const ON_A_SURFACE: [&str; 5] = [
    "camera_on_plane",
    "camera_on_sphere",
    "camera_on_sphere_out",
    "light_on_plane",
    "light_on_sphere",
];

#[test]
fn both_chains_draw_the_same_picture_in_f64() {
    let way = (Quality::Wide, Shadow::ErrorBound);
    for path in paths() {
        let file = load(&path);
        let engine = Engine::default();
        let own = relative::<f64>(&file, file.size, engine);
        let lab = lab::<f64>(&file, file.size, engine, way).expect("a chain");
        let differ = differing(&own, &lab, 0);
        let on_a_surface = ON_A_SURFACE.contains(&file.name.as_str());
        assert_eq!(
            differ > 0,
            on_a_surface,
            "{}: {differ} bytes differ",
            file.name
        );
    }
}

#[test]
fn the_own_chain_draws_the_same_picture_in_f32() {
    for path in paths() {
        let file = load(&path);
        let [exact, rounded] = [relative::<f64>, relative::<f32>]
            .map(|draw| draw(&file, file.size, Engine::default()));
        let differ = differing(&exact, &rounded, 1);
        assert_eq!(
            differ, 0,
            "{}: {differ} bytes differ by more than 1",
            file.name
        );
    }
}

#[test]
fn a_camera_without_end_sees_the_plane_up_to_the_horizon() {
    let [infinite, finite] = ["infinite", "base"].map(named);
    let is_background = |file: &SceneFile, row| {
        let picture = relative::<f64>(file, Size::LAB, Engine::default());
        let mut columns = 0..Size::LAB.width();
        columns.any(|column| picture.pixel(column, row) == Some([127; 3]))
    };
    let horizon = Size::LAB.height() / 2;
    assert!(is_background(&infinite, horizon - 1));
    assert!(!is_background(&infinite, horizon));
    assert!(is_background(&finite, horizon));
}
