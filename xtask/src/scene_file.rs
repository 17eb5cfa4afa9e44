//! Scene files: a scene, a camera and a picture size in TOML. `docs/scenes.md` describes them.

mod section;
mod source;

use crate::error::{Error, Result};
use ombrage::{PerspectiveCamera, Plane, PointLight, Scene, Size, Sphere, View};
use section::{Key, Kind, Section};
use source::Source;
use std::path::Path;

/// A scene file's content.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// What the scene is called.
    pub name: String,
    /// Objects, lights and background; lengths in scene units, colours linear.
    pub scene: Scene<f64>,
    /// The camera.
    pub view: View<f64>,
    /// The size of the picture in pixels.
    pub size: Size,
}

const fn key(name: &'static str, example: &'static str) -> Key {
    Key { name, example }
}

const FILE: Kind = Kind {
    header: "the file",
    word: "",
    keys: &[
        key("name", "\"base\""),
        key("background", "[0.5, 0.5, 0.5]"),
        key("t_max", "1000"),
    ],
    sections: &["camera", "image", "sphere", "plane", "light"],
};

const CAMERA: Kind = Kind {
    header: "[camera]",
    word: "camera",
    keys: &[
        key("position", "[0, 0, -2]"),
        key("look_at", "[0, 0, 79]"),
        key("up", "[0, 1, 0]"),
        key("fov", "60"),
    ],
    sections: &[],
};

const IMAGE: Kind = Kind {
    header: "[image]",
    word: "image",
    keys: &[key("width", "600"), key("height", "400")],
    sections: &[],
};

const SPHERE: Kind = Kind {
    header: "[[sphere]]",
    word: "sphere",
    keys: &[
        key("center", "[0, 0, 3]"),
        key("radius", "1"),
        key("color", "[0, 0, 1]"),
    ],
    sections: &[],
};

const PLANE: Kind = Kind {
    header: "[[plane]]",
    word: "plane",
    keys: &[
        key("point", "[0, -2, 0]"),
        key("normal", "[0, 1, 0]"),
        key("color", "[1, 0, 0]"),
    ],
    sections: &[],
};

const LIGHT: Kind = Kind {
    header: "[[light]]",
    word: "light",
    keys: &[
        key("position", "[1, 10, 1]"),
        key("color", "[1, 1, 1]"),
        key("power", "100"),
    ],
    sections: &[],
};

/// Reads a scene file.
///
/// # Errors
/// If the file cannot be read, is larger than 128 MiB, is not TOML, lacks a key or has one too
/// many, or a value is not what its key takes. The message names the file, the line, the key, and
/// what to write.
pub fn load(path: &Path) -> Result<SceneFile> {
    parse(path, source::read(path)?)
}

/// The scene file with these bytes; `path` is for messages.
///
/// # Errors
/// As [`load`], but for reading the file.
pub fn parse(path: &Path, bytes: Vec<u8>) -> Result<SceneFile> {
    let source = Source::new(path, bytes)?;
    let document = source.parse()?;
    let file = Section::whole(&source, &document, &FILE)?;
    let name = file.text("name")?;
    let (view, size) = (view(&file)?, size(&file)?);
    let scene = scene(&file)?;
    Ok(SceneFile {
        name,
        scene,
        view,
        size,
    })
}

fn view(file: &Section) -> Result<View<f64>> {
    let camera = file.section("camera", &CAMERA)?;
    let view = View {
        position: camera.vector("position")?,
        look_at: camera.vector("look_at")?,
        up: camera.vector("up")?,
        fov: camera.number("fov")?,
    };
    PerspectiveCamera::new(&view, 1.0).map_err(|invalid| camera.invalid(&invalid))?;
    Ok(view)
}

fn size(file: &Section) -> Result<Size> {
    let image = file.section("image", &IMAGE)?;
    let (width, height) = (image.count("width")?, image.count("height")?);
    Size::new(width, height).map_err(|invalid| image.invalid(&invalid))
}

fn scene(file: &Section) -> Result<Scene<f64>> {
    let (background, t_max) = (file.vector("background")?, file.number("t_max")?);
    let mut scene = Scene::new(background, t_max).map_err(|invalid| file.invalid(&invalid))?;
    for sphere in file.sections("sphere", &SPHERE)? {
        let sphere = sphere?;
        let (center, radius) = (sphere.vector("center")?, sphere.number("radius")?);
        let color = sphere.vector("color")?;
        scene = Sphere::new(center, radius)
            .and_then(|shape| scene.with_sphere(shape, color))
            .map_err(|invalid| sphere.invalid(&invalid))?;
    }
    for plane in file.sections("plane", &PLANE)? {
        let plane = plane?;
        let (point, normal) = (plane.vector("point")?, plane.vector("normal")?);
        let color = plane.vector("color")?;
        scene = Plane::new(point, normal)
            .and_then(|shape| scene.with_plane(shape, color))
            .map_err(|invalid| plane.invalid(&invalid))?;
    }
    for light in file.sections("light", &LIGHT)? {
        let light = light?;
        let (position, color) = (light.vector("position")?, light.vector("color")?);
        let light = PointLight::new(position, color, light.number("power")?)
            .map_err(|invalid| light.invalid(&invalid))?;
        scene = scene.with_light(light);
    }
    Ok(scene)
}

/// A message about a place in a file.
fn at(path: &Path, line: usize, what: &str) -> Error {
    Error::new(format!("{}:{line}: {what}", path.display()))
}
