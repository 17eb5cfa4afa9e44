//! Pictures that ways to compute them are judged by.

use crate::error::{Error, Result};
use crate::scene_file::{self, SceneFile};
use crate::workspace;
use ombrage::{
    Chain, DirectLighting, Film, Integrator, Invalid, Lighting, PerspectiveCamera, Picture, Plane,
    PointLight, Quality, Scalar, Scene, Shadow, ShadowQuery, Size, Sphere, View, render_proven,
};
use std::fs;
use std::path::{Path, PathBuf};

/// A scene, how it is seen, and how large its picture is.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// What there is to see.
    pub scene: Scene<f64>,
    /// From where.
    pub view: View<f64>,
    /// In how many pixels.
    pub size: Size,
}

/// The scenes of these names, each one of tests/scenes or the path of a scene file; all of
/// tests/scenes, sorted, where none is named.
///
/// # Errors
/// If there is no such scene, or it is not valid.
pub fn load(names: &[String]) -> Result<Vec<Case>> {
    let known = workspace::root().map(|root| root.join("tests").join("scenes"));
    let paths = if names.is_empty() {
        scene_files(&known?)?
    } else {
        let known = known.unwrap_or_default();
        let path = |name: &String| match Path::new(name).extension() {
            Some(extension) if extension == "toml" => PathBuf::from(name),
            _ => known.join(format!("{name}.toml")),
        };
        names.iter().map(path).collect()
    };
    paths.iter().map(|path| Case::read(path)).collect()
}

/// The scene files of a directory, sorted.
pub(crate) fn scene_files(directory: &Path) -> Result<Vec<PathBuf>> {
    let failed = |error: std::io::Error| {
        let path = directory.display();
        Error::new(format!(
            "cannot read {path}: {error}; name a scene file instead"
        ))
    };
    let mut paths = vec![];
    for entry in fs::read_dir(directory).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

/// The lab's integrator with a strategy for its shadow rays, or none.
pub fn direct(quality: Quality, shadow: Option<Shadow>) -> Integrator {
    Integrator::DirectLighting(DirectLighting {
        quality,
        shadow,
        query: ShadowQuery::Any,
    })
}

impl Case {
    /// The case of a scene file.
    ///
    /// # Errors
    /// If the file cannot be read or is not a valid scene.
    pub fn read(path: &Path) -> Result<Self> {
        let SceneFile {
            name,
            scene,
            view,
            size,
        } = scene_file::load(path)?;
        Ok(Self {
            name,
            scene,
            view,
            size,
        })
    }

    /// The same case with every number rounded to a format. It is the only scene a chain in that
    /// format can be given, so its truth is what the chain is judged by.
    ///
    /// # Errors
    /// If a number is valid here but not there.
    pub fn held_in<S: Scalar>(&self) -> Result<Self> {
        let scalar = |x: f64| S::from_f64(x).to_f64();
        let vector = |v: glam::DVec3| v.map(scalar);
        let scene = &self.scene;
        let mut held = Scene::new(vector(scene.background()), scalar(scene.t_max()))?;
        for sphere in scene.spheres() {
            let (center, radius) = (sphere.shape.center(), sphere.shape.radius());
            let shape = Sphere::new(vector(center), scalar(radius))?;
            held = held.with_sphere(shape, vector(sphere.color()))?;
        }
        for plane in scene.planes() {
            let (point, normal) = (plane.shape.point(), plane.shape.normal());
            let shape = Plane::new(vector(point), vector(normal))?;
            held = held.with_plane(shape, vector(plane.color()))?;
        }
        for light in scene.lights() {
            let (position, color) = (vector(light.position()), vector(light.color()));
            held = held.with_light(PointLight::new(position, color, scalar(light.power()))?);
        }
        let View {
            position,
            look_at,
            up,
            fov,
        } = self.view;
        let view = View {
            position: vector(position),
            look_at: vector(look_at),
            up: vector(up),
            fov: scalar(fov),
        };
        Ok(Self {
            name: self.name.clone(),
            scene: held,
            view,
            size: self.size,
        })
    }

    /// The scene with only its `index`-th light, so that shadows are judged one light at a time.
    ///
    /// # Errors
    /// None: every part is valid already.
    pub fn with_light(&self, index: usize) -> Result<Self> {
        let scene = &self.scene;
        let mut alone = Scene::new(scene.background(), scene.t_max())?;
        for sphere in scene.spheres() {
            alone = alone.with_sphere(sphere.shape, sphere.color())?;
        }
        for plane in scene.planes() {
            alone = alone.with_plane(plane.shape, plane.color())?;
        }
        if let Some(&light) = scene.lights().get(index) {
            alone = alone.with_light(light);
        }
        Ok(Self {
            scene: alone,
            ..self.clone()
        })
    }

    /// The same scene and view in smaller pictures, at most `width` pixels wide.
    ///
    /// # Errors
    /// None: smaller sizes are valid where larger ones are.
    pub fn at_most(&self, width: u32) -> Result<Self> {
        let (columns, rows) = (self.size.width(), self.size.height());
        let width = width.min(columns);
        let height = (u64::from(rows) * u64::from(width) / u64::from(columns)).max(1) as u32;
        Ok(Self {
            size: Size::new(width, height)?,
            ..self.clone()
        })
    }

    /// The lab's camera for it, in a format.
    ///
    /// # Errors
    /// If the view is invalid in that format.
    pub fn camera<S: Scalar>(&self) -> std::result::Result<PerspectiveCamera<S>, Invalid> {
        let [width, height] = [self.size.width(), self.size.height()].map(f64::from);
        let aspect = S::from_f64(width) / S::from_f64(height);
        PerspectiveCamera::new(&self.view.cast(), aspect)
    }
}

/// The radiance of every pixel, row-major, computed one pixel at a time on one thread.
pub fn radiance<S: Scalar, C: Chain<S>>(chain: &C, size: Size) -> Vec<S::Vector> {
    let mut picture = Vec::with_capacity(size.pixels());
    let columns: Vec<S> = (0..size.width())
        .map(|column| C::coordinate(column, size.width()))
        .collect();
    for row in 0..size.height() {
        let down = C::coordinate(row, size.height());
        picture.extend(
            columns
                .iter()
                .map(|&across| chain.radiance::<S>(across, down)),
        );
    }
    picture
}

/// The picture of exact mathematics, byte by byte.
///
/// # Errors
/// If the view is invalid, or a pixel is a tie that nothing decides.
pub fn proven(case: &Case, lighting: Lighting, film: Film) -> Result<Picture> {
    let proven = render_proven(&case.scene, &case.view, case.size, lighting, film)?;
    match proven.undecided() {
        [] => Ok(proven.into_picture()),
        [first, ..] => Err(Error::new(format!(
            "{}: column {}, row {} cannot be proven: {}; change the scene or its size a little",
            case.name, first.column, first.row, first.reason
        ))),
    }
}
