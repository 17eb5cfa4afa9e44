//! What is digested, and that every level and number of threads computes the same of it.

use super::{digest, failed};
use crate::case::{self, Case};
use crate::error::{Error, Result};
use crate::{parallel, precision};
use ombrage::{
    Chain, Engine, FIGURES, Figure, Film, Float, LabChain, Level, Lighting, Quality, Relative,
    Shadow, Size, Vector, lab,
};
use ombrage_oracle::case::KINDS;
use ombrage_oracle::families::write_jsonl;
use std::num::NonZero;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

/// The widest pictures that scenes are digested in.
const WIDTH: u32 = 120;

/// A row of the document.
pub struct Subject {
    /// What it is.
    pub name: String,
    /// Its digests: in `f32` and `f64`, or one that belongs to no format.
    pub digests: Vec<String>,
}

/// All subjects, and what differs between engines.
pub fn all() -> Result<(Vec<Subject>, Vec<String>)> {
    let engines = engines()?;
    let (mut subjects, mut differences) = (vec![], vec![]);
    let mut add = |(subject, found): (Subject, Vec<String>)| {
        subjects.push(subject);
        differences.extend(found);
    };
    let figures = parallel::map(&FIGURES, |figure| figure_rows(figure, &engines))?;
    figures.into_iter().flatten().for_each(&mut add);
    for lighting in [Lighting::Eye, Lighting::Unshadowed, Lighting::Shadowed] {
        add(own_chain(lighting, &engines)?);
    }
    let cases = case::load(&[])?;
    let scenes = parallel::map(&cases, |case| scene_rows(&case.at_most(WIDTH)?, &engines))?;
    scenes.into_iter().flatten().for_each(&mut add);
    let texts = parallel::map(&KINDS, |kind| Ok((*kind, write_jsonl(kind))))?;
    let texts = texts
        .into_iter()
        .map(|(kind, text)| (format!("vectors: {kind}.jsonl"), text));
    let errors = (
        "docs/precision.md up to the costs".to_owned(),
        precision::errors()?,
    );
    for (name, text) in texts.chain([errors]) {
        add((
            Subject {
                name,
                digests: vec![digest(text), String::new()],
            },
            vec![],
        ));
    }
    for (name, bytes) in figure_files()? {
        let name = format!("figures: file {name}");
        add((
            Subject {
                name,
                digests: vec![digest(bytes), String::new()],
            },
            vec![],
        ));
    }
    Ok((subjects, differences))
}

/// Every level on one thread and on two; the scalar one on one thread is the first.
fn engines() -> Result<Vec<Engine>> {
    let mut engines = vec![];
    for level in Level::available() {
        for threads in [1, 2] {
            engines.push(Engine::new(level, NonZero::new(threads))?);
        }
    }
    Ok(engines)
}

/// The digest of what the first engine computes, and which engines compute something else.
fn by_every_engine(
    name: &str,
    engines: &[Engine],
    compute: impl Fn(Engine) -> Result<Option<Vec<u8>>>,
) -> Result<(String, Vec<String>)> {
    let (mut first, mut differences) = (None, vec![]);
    for &engine in engines {
        let found = compute(engine)?.map_or_else(|| "invalid".to_owned(), digest);
        let expected = first.get_or_insert_with(|| found.clone());
        if found != *expected {
            let threads = engine.threads(Size::LAB);
            differences.push(format!(
                "{name}: {found} at {} on {threads} threads, but {expected} for scalars on one",
                engine.level()
            ));
        }
    }
    Ok((first.unwrap_or_default(), differences))
}

/// A row in both formats.
fn both(
    name: String,
    engines: &[Engine],
    f32: impl Fn(Engine) -> Result<Option<Vec<u8>>>,
    f64: impl Fn(Engine) -> Result<Option<Vec<u8>>>,
) -> Result<(Subject, Vec<String>)> {
    let (single, mut differences) = by_every_engine(&format!("{name}, f32"), engines, f32)?;
    let (double, more) = by_every_engine(&format!("{name}, f64"), engines, f64)?;
    differences.extend(more);
    let digests = vec![single, double];
    Ok((Subject { name, digests }, differences))
}

fn figure_rows(figure: &Figure, engines: &[Engine]) -> Result<Vec<(Subject, Vec<String>)>> {
    fn draw<F: Float>(figure: &Figure, engine: Engine) -> Result<Option<Vec<u8>>> {
        let picture = figure.draw_with::<F>(Size::LAB, engine)?;
        Ok(Some(picture.bytes().to_vec()))
    }
    fn count<F: Float>(figure: &Figure) -> Result<Option<Vec<u8>>> {
        let counts = figure.survey::<F>(Size::LAB)?.counts();
        Ok(Some(format!("{counts:?}").into_bytes()))
    }
    let pixels = both(
        format!("figure {}: picture", figure.name),
        engines,
        |engine| draw::<f32>(figure, engine),
        |engine| draw::<f64>(figure, engine),
    )?;
    // Counting takes one pixel at a time, whatever the engine.
    let counts = both(
        format!("figure {}: counts", figure.name),
        &engines[..1],
        |_| count::<f32>(figure),
        |_| count::<f64>(figure),
    )?;
    Ok(vec![pixels, counts])
}

/// The lab's scene in the kit's own chain.
fn own_chain(lighting: Lighting, engines: &[Engine]) -> Result<(Subject, Vec<String>)> {
    fn draw<F: Float>(lighting: Lighting, engine: Engine) -> Result<Option<Vec<u8>>> {
        let chain = Relative::<F>::new(&lab::scene()?, &lab::view(), Size::LAB, lighting)?;
        let picture = engine.render(&chain, Size::LAB, Film::Clamp);
        Ok(Some(picture.bytes().to_vec()))
    }
    both(
        format!("the lab's scene in the kit's own chain, {lighting:?}: picture"),
        engines,
        |engine| draw::<f32>(lighting, engine),
        |engine| draw::<f64>(lighting, engine),
    )
}

fn scene_rows(case: &Case, engines: &[Engine]) -> Result<Vec<(Subject, Vec<String>)>> {
    let lab = both(
        format!("{}: radiance, the lab's chain", case.name),
        engines,
        |engine| Ok(lab_radiance::<f32>(case, engine)),
        |engine| Ok(lab_radiance::<f64>(case, engine)),
    )?;
    let own = both(
        format!("{}: radiance, the kit's own chain", case.name),
        engines,
        |engine| own_radiance::<f32>(case, engine),
        |engine| own_radiance::<f64>(case, engine),
    )?;
    Ok(vec![lab, own])
}

/// `None` where the scene does not fit the format.
fn lab_radiance<F: Float>(case: &Case, engine: Engine) -> Option<Vec<u8>> {
    let scene = case.scene.cast::<F>().ok()?;
    let camera = case.camera::<F>().ok()?;
    let chain = LabChain {
        scene: &scene,
        camera: &camera,
        integrator: case::direct(Quality::default(), Some(Shadow::UlpOffset)),
    };
    Some(bits(&chain, case.size, engine))
}

fn own_radiance<F: Float>(case: &Case, engine: Engine) -> Result<Option<Vec<u8>>> {
    let chain = Relative::<F>::new(&case.scene, &case.view, case.size, Lighting::Shadowed)?;
    Ok(Some(bits(&chain, case.size, engine)))
}

/// The bits of the radiance, with one pattern for all NaN: IEEE 754 leaves their sign and payload
/// open.
fn bits<F: Float>(chain: &impl Chain<F>, size: Size, engine: Engine) -> Vec<u8> {
    let radiance = engine.render_radiance(chain, size);
    let components = radiance.iter().flat_map(|colour| colour.to_array());
    let bits = components.map(|x| {
        if x.to_f64().is_nan() {
            u64::MAX
        } else {
            x.bits()
        }
    });
    bits.flat_map(u64::to_le_bytes).collect()
}

/// The files that `cargo xtask figures` writes, by name.
fn figure_files() -> Result<Vec<(String, Vec<u8>)>> {
    let directory = tempfile::tempdir().map_err(|error| failed("make a directory", &error))?;
    let program = env::current_exe().map_err(|error| failed("find this program", &error))?;
    let mut command = Command::new(program);
    let command = command.arg("figures").arg("--out").arg(directory.path());
    let done = command
        .output()
        .map_err(|error| failed("start this program", &error))?;
    if !done.status.success() {
        return Err(Error::new(String::from_utf8_lossy(&done.stderr)));
    }
    let mut files = vec![];
    for folder in ["", "annotated"] {
        let inside = directory.path().join(folder);
        let entries = fs::read_dir(&inside).map_err(|error| failed("read the figures", &error))?;
        for path in entries
            .flatten()
            .map(|entry| entry.path())
            .filter(|path| path.is_file())
        {
            let name = Path::new(folder).join(path.file_name().unwrap_or_default());
            let bytes = fs::read(&path).map_err(|error| failed("read a figure", &error))?;
            files.push((name.to_string_lossy().replace('\\', "/"), bytes));
        }
    }
    files.sort();
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_engine_that_computes_something_else_is_named() {
        let engines = engines().unwrap();
        let last = engines[engines.len() - 1];
        let same = |_| Ok(Some(vec![1]));
        assert_eq!(by_every_engine("it", &engines, same).unwrap().1, [""; 0]);
        let other = |engine| Ok(Some(vec![u8::from(engine == last)]));
        let (first, differences) = by_every_engine("it", &engines, other).unwrap();
        assert_eq!(first, digest([0]));
        assert_eq!(differences.len(), 1);
        let named = format!("it: {} at {} on 2 threads", digest([1]), last.level());
        assert!(differences[0].starts_with(&named), "{differences:?}");
    }
}
