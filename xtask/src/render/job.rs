//! One picture: drawn a few rows at a time, and timed.

use crate::arguments::Machine;
use crate::case::direct;
use crate::error::{Error, Result};
use crate::progress;
use crate::proof::Proof;
use crate::scene_file::SceneFile;
use ombrage::{
    Chain, Engine, Film, Invalid, LabChain, Lighting, PerspectiveCamera, Picture, Quality,
    Relative, Scalar, Shadow, Size,
};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// How radiance is computed.
#[derive(Clone, Copy)]
pub enum Method {
    /// By the kit's own chain.
    Relative,
    /// By the same, every byte proven.
    Proven,
    /// By the lab's chain.
    Lab {
        /// How shadow rays leave their surface.
        shadow: Shadow,
        /// How well its kernels compute.
        quality: Quality,
    },
}

/// A picture to draw.
pub struct Job<'a> {
    /// The scene file, for messages.
    pub path: &'a Path,
    /// What it holds.
    pub content: &'a SceneFile,
    /// How to draw it.
    pub method: Method,
    /// The size of the picture.
    pub size: Size,
    /// What to compute with.
    pub machine: Machine,
}

/// What the table says of the picture.
#[derive(Debug, Serialize)]
pub struct Row {
    name: String,
    width: u32,
    height: u32,
    float: &'static str,
    shadow: String,
    /// None for the kit's own chain, which has one.
    quality: Option<&'static str>,
    level: &'static str,
    threads: usize,
    /// How long it took to draw, without reading and writing files.
    ms: f64,
    ns_per_pixel: f64,
    file: PathBuf,
    /// What proved the pixels, where the picture is proven.
    #[serde(flatten)]
    pub proof: Option<Proof>,
}

/// Pairs of a pixel and an object that take about a second.
const LONG: usize = 1 << 29;

/// Pairs of a pixel and an object between two steps of the progress bar.
const STEP: usize = 1 << 26;

impl Job<'_> {
    /// Draws the picture that is to be in the file `out`.
    ///
    /// # Errors
    /// If the scene does not fit the format, or the processor does not have the level.
    pub fn draw<S: Scalar>(&self, out: &Path) -> Result<(Picture, Row)> {
        let SceneFile { scene, view, .. } = self.content;
        let engine = self.machine.engine(self.pairs() > LONG)?;
        let start = Instant::now();
        let mut proof = None;
        let picture = match self.method {
            Method::Proven => {
                let proven =
                    engine.render_proven(scene, view, self.size, Lighting::Shadowed, Film::Clamp);
                let proven = proven.map_err(|invalid| self.misfit::<S>(&invalid))?;
                proof = Some(Proof::of(&proven));
                proven.into_picture()
            }
            Method::Relative => {
                let chain = Relative::<S>::new(scene, view, self.size, Lighting::Shadowed);
                self.rows(
                    &chain.map_err(|invalid| self.misfit::<S>(&invalid))?,
                    engine,
                )?
            }
            Method::Lab { shadow, quality } => {
                let misfit = |invalid| self.misfit::<S>(&invalid);
                let scene = scene.cast::<S>().map_err(misfit)?;
                let aspect = S::from_f64(self.size.aspect());
                let camera = PerspectiveCamera::new(&view.cast::<S>(), aspect).map_err(misfit)?;
                let chain = LabChain {
                    scene: &scene,
                    camera: &camera,
                    integrator: direct(quality, Some(shadow)),
                };
                self.rows(&chain, engine)?
            }
        };
        let row = self.row::<S>(start.elapsed().as_secs_f64(), engine, out);
        Ok((picture, Row { proof, ..row }))
    }

    /// How many pairs of a pixel and an object there are: what the time grows with.
    fn pairs(&self) -> usize {
        let scene = &self.content.scene;
        let objects = 1 + scene.spheres().len() + scene.planes().len();
        self.size.pixels().saturating_mul(objects)
    }

    /// All rows of the picture, with a progress bar where they are long work.
    fn rows<S: Scalar>(&self, chain: &impl Chain<S>, engine: Engine) -> Result<Picture> {
        let bar = progress::bar(u64::from(self.size.height()), self.pairs() > LONG);
        bar.set_message(self.content.name.clone());
        let height = self.size.height();
        let steps = (self.pairs() / STEP).clamp(1, height as usize);
        let rows = height.div_ceil(steps as u32);
        let mut pixels = Vec::with_capacity(self.size.pixels());
        for first in (0..height).step_by(rows as usize) {
            let rows = first..first.saturating_add(rows).min(height);
            bar.inc(u64::from(rows.end - rows.start));
            pixels.extend(engine.render_rows(chain, self.size, Film::Clamp, rows));
        }
        bar.finish_and_clear();
        Ok(Picture::from_pixels(self.size, pixels)?)
    }

    /// A scene or camera that is valid in `f64` but not in this format.
    fn misfit<S: Scalar>(&self, invalid: &Invalid) -> Error {
        let (path, float) = (self.path.display(), S::NAME);
        let advice = match float {
            "f32" => "change it, or compute with --float f64",
            _ => "change it",
        };
        Error::new(format!("{path}: in {float}, {invalid}: {advice}"))
    }

    fn row<S: Scalar>(&self, seconds: f64, engine: Engine, out: &Path) -> Row {
        let (shadow, quality) = match self.method {
            Method::Relative | Method::Proven => ("relative".to_owned(), None),
            Method::Lab { shadow, quality } => (shadow.name(), Some(quality.name())),
        };
        Row {
            name: self.content.name.clone(),
            width: self.size.width(),
            height: self.size.height(),
            float: match self.method {
                Method::Proven => "proven",
                _ => S::NAME,
            },
            shadow,
            quality,
            level: engine.level().name(),
            threads: engine.threads(self.size),
            ms: seconds * 1e3,
            ns_per_pixel: seconds * 1e9 / self.size.pixels() as f64,
            file: out.to_path_buf(),
            proof: None,
        }
    }
}

impl Row {
    /// The heads of the table's columns.
    pub const HEADS: [&str; 9] = [
        "scene", "size", "float", "shadow", "level", "threads", "ms", "ns/pixel", "file",
    ];

    /// The cells of the table's row.
    pub fn cells(&self) -> Vec<String> {
        let shadow = match self.quality {
            None => self.shadow.clone(),
            Some(quality) => format!("{}, {quality}", self.shadow),
        };
        let mut cells = vec![
            self.name.clone(),
            format!("{}x{}", self.width, self.height),
            self.float.to_owned(),
            shadow,
            self.level.to_owned(),
            self.threads.to_string(),
            format!("{:.2}", self.ms),
            format!("{:.1}", self.ns_per_pixel),
            self.file.display().to_string(),
        ];
        cells.extend(self.proof.iter().flat_map(Proof::cells));
        cells
    }
}
