//! A scene in front of its camera, where contenders run and show their pictures.

use super::hierarchy::{Hierarchical, InPackets};
use super::lab_way::Program;
use super::result::Row;
use super::way::{Contender, Way};
use crate::case::{self, Case};
use crate::clock::{laps, median};
use crate::compare::differing;
use crate::error::Result;
use ombrage::{
    DirectLighting, Engine, Film, Integrator, LabChain, Level, Lighting, PerspectiveCamera,
    Picture, Relative, Scene, Size,
};
use std::cell::RefCell;
use std::hint::black_box;
use std::mem;
use std::num::NonZero;
use std::time::Instant;

/// A case in a format, ready for every way, and its true picture.
pub struct Stage<'a, F: InPackets> {
    picture: &'static str,
    case: &'a Case,
    truth: &'a Picture,
    scene: Scene<F>,
    camera: PerspectiveCamera<F>,
    lab_way: Program<F>,
    hierarchical: Hierarchical<F>,
}

/// Of so many pixels, the baseline may differ in one byte from the lab's chain: its operations have
/// another order, and round otherwise.
const PIXELS_PER_OTHER_BYTE: usize = 24_000;

/// The same where there are many spheres, and an edge in most pixels.
const PIXELS_PER_OTHER_BYTE_AT_EDGES: usize = 32;

/// The fewest and the most rounds of timing.
const ROUNDS: [usize; 2] = [3, 101];

/// The true picture of a case, every byte proven.
///
/// # Errors
/// If the view is invalid, or a pixel is a tie that nothing decides.
pub fn truth(case: &Case) -> Result<Picture> {
    case::proven(case, Lighting::Shadowed, Film::Clamp)
}

impl<'a, F: InPackets> Stage<'a, F> {
    /// Sets a case up. `picture` is what its rows are called; `truth` its true picture.
    ///
    /// # Errors
    /// If the case is invalid in this format.
    pub fn new(picture: &'static str, case: &'a Case, truth: &'a Picture) -> Result<Self> {
        let (scene, camera) = (case.scene.cast()?, case.camera()?);
        Ok(Self {
            picture,
            case,
            truth,
            lab_way: Program::new(&case.scene, &case.view, case.size),
            hierarchical: Hierarchical::new(&scene, &camera),
            scene,
            camera,
        })
    }

    /// The picture that a contender computes.
    ///
    /// # Errors
    /// If the case is invalid in this format, or the processor does not have the level.
    pub fn draw(&self, contender: Contender) -> Result<Picture> {
        let mut picture = Picture::black(self.case.size);
        self.draw_over(contender, &mut picture)?;
        Ok(picture)
    }

    /// The same over a picture of the case's size: where time is measured, that of new memory is not.
    ///
    /// # Errors
    /// Those of [`draw`](Self::draw).
    pub fn draw_over(&self, contender: Contender, picture: &mut Picture) -> Result<()> {
        let Case {
            scene, view, size, ..
        } = self.case;
        let engine = Engine::new(contender.level, Some(contender.threads))?;
        match contender.way {
            Way::Baseline => *picture = self.lab_way.render(*size)?,
            Way::Lab(shadow, quality, query) => {
                let chain = LabChain {
                    scene: &self.scene,
                    camera: &self.camera,
                    integrator: Integrator::DirectLighting(DirectLighting {
                        quality,
                        shadow: Some(shadow),
                        query,
                    }),
                };
                engine.render_into(&chain, Film::Clamp, picture);
            }
            Way::Hierarchy => *picture = self.hierarchical.render(contender.level, *size)?,
            Way::Relative => {
                let chain = Relative::<F>::new(scene, view, *size, Lighting::Shadowed)?;
                engine.render_into(&chain, Film::Clamp, picture);
            }
            Way::Proven => {
                let (lighting, film) = (Lighting::Shadowed, Film::Clamp);
                let canvas = mem::replace(picture, Picture::black(Size::new(1, 1)?));
                let proven = engine.render_proven_over(scene, view, lighting, film, canvas)?;
                *picture = proven.into_picture();
            }
        }
        Ok(())
    }

    /// Lets contenders run in turns, for about so many seconds. The first must be the baseline.
    /// Pictures that are not what they must be go to `wrong_pictures`.
    ///
    /// # Errors
    /// If the case is invalid in this format, or the processor does not have a level.
    pub fn run(
        &self,
        contenders: &[Contender],
        seconds: f64,
        wrong_pictures: &mut Vec<String>,
    ) -> Result<Vec<Row>> {
        let runs = |contender: &&Contender| contender.way.runs_in::<F>();
        let contenders: Vec<Contender> = contenders.iter().filter(runs).copied().collect();
        let mut references: Vec<(Way, Picture)> = vec![];
        let mut wrong_bytes = vec![];
        let mut round = 0.0;
        for &contender in &contenders {
            let start = Instant::now();
            let picture = self.draw(contender)?;
            round += start.elapsed().as_secs_f64();
            let way = contender.way.reference();
            let known = references.iter().position(|(known, _)| *known == way);
            let known = match known {
                Some(known) => known,
                None => {
                    let reference = self.draw(Contender::new(way, Level::Scalar))?;
                    references.push((way, reference));
                    references.len() - 1
                }
            };
            wrong_pictures.extend(self.complaint(contender, &picture, &references[known].1));
            wrong_bytes.push(differing(picture.bytes(), self.truth.bytes()));
        }
        let canvas = RefCell::new(Picture::black(self.case.size));
        let mut tasks: Vec<Box<dyn FnMut() + '_>> = vec![];
        for &contender in &contenders {
            let canvas = &canvas;
            tasks.push(Box::new(move || {
                let mut canvas = canvas.borrow_mut();
                // It succeeded above, and nothing has changed.
                let _ = self.draw_over(black_box(contender), &mut canvas);
                black_box(canvas.bytes());
            }));
        }
        let rounds = ((seconds / round) as usize).clamp(ROUNDS[0], ROUNDS[1]);
        let laps = laps(rounds, &mut tasks);
        let row = |((&contender, own), wrong): ((&Contender, &Vec<f64>), usize)| {
            let way = Way::Relative;
            let plain = Contender { way, ..contender };
            let plain = contenders.iter().position(|other| *other == plain);
            let plain = plain.filter(|_| contender.way == Way::Proven);
            Row {
                ratio_to_plain: plain.map(|plain| ratio(own, &laps[plain])),
                ..self.row(contender, own, &laps[0], wrong)
            }
        };
        let rows = contenders.iter().zip(&laps).zip(wrong_bytes).map(row);
        Ok(rows.collect())
    }

    fn row(&self, contender: Contender, own: &[f64], baseline: &[f64], wrong: usize) -> Row {
        let Contender {
            way,
            level,
            threads,
        } = contender;
        let size = self.case.size;
        Row {
            picture: self.picture.into(),
            spheres: self.scene.spheres().len(),
            width: size.width(),
            height: size.height(),
            float: F::NAME.into(),
            chain: way.chain().into(),
            shadow: way.shadow(),
            quality: way.quality().map(|quality| quality.name().into()),
            query: way.query().map(Into::into),
            level: level.name().into(),
            threads: NonZero::get(threads),
            ns_per_pixel: median(own.to_vec()) * 1e9 / size.pixels() as f64,
            ratio_to_lab_way: ratio(baseline, own),
            ratio_to_plain: None,
            wrong_bytes: wrong,
            share_of_limit: None,
        }
    }

    /// What is wrong with a contender's picture: it must have the scalar path's bytes, at every
    /// level, on any number of threads, and whatever shadow rays ask.
    fn complaint(
        &self,
        contender: Contender,
        picture: &Picture,
        reference: &Picture,
    ) -> Option<String> {
        let others = differing(picture.bytes(), reference.bytes());
        let size = self.case.size;
        let allowed = match (contender.way, self.scene.spheres().len()) {
            (Way::Baseline, 1) => size.pixels().div_ceil(PIXELS_PER_OTHER_BYTE),
            (Way::Baseline, _) => size.pixels().div_ceil(PIXELS_PER_OTHER_BYTE_AT_EDGES),
            _ => 0,
        };
        (others > allowed).then(|| {
            let Contender {
                way,
                level,
                threads,
            } = contender;
            format!(
                "{} with {} sphere(s), {}x{}, {}: {} ({}, {level}, {threads} thread(s)) differs from \
                 the scalar path in {others} bytes, and may in {allowed}",
                self.picture,
                self.scene.spheres().len(),
                size.width(),
                size.height(),
                F::NAME,
                way.chain(),
                way.shadow(),
            )
        })
    }
}

/// The median of the ratios of neighbouring times.
fn ratio(times: &[f64], to: &[f64]) -> f64 {
    median(times.iter().zip(to).map(|(a, b)| a / b).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::lists;
    use crate::bench::way::LAB;
    use ombrage::{DoubleDouble, Figure, render};

    /// The proof's truth against another: all pixels in double-double, which errs by about 1e-30.
    #[test]
    fn the_truth_is_that_of_double_double() {
        let size = Size::new(120, 80).expect("valid");
        for case in [lists::figure(size), lists::spheres(40)] {
            let Case {
                scene, view, size, ..
            } = &case.as_ref().expect("valid");
            let chain = Relative::<DoubleDouble>::new(scene, view, *size, Lighting::Shadowed);
            let expected = render(&chain.expect("valid"), *size, Film::Clamp);
            assert!(truth(&case.expect("valid")).expect("decided") == expected);
        }
    }

    /// Pictures of other figures, and pictures a byte off, are noticed.
    #[test]
    fn complains_of_wrong_pictures() {
        let case = lists::figure(Size::LAB).expect("valid");
        let truth = truth(&case).expect("valid");
        let stage = Stage::<f32>::new("3c", &case, &truth).expect("valid");
        let reference = stage
            .draw(Contender::new(LAB, Level::Scalar))
            .expect("a picture");
        let mut bytes = reference.bytes().to_vec();
        bytes[0] ^= 1;
        let off = Picture::new(Size::LAB, &bytes).expect("three bytes a pixel");
        let other = Figure::named("2b").expect("a figure");
        let other = other.draw::<f32>(Size::LAB).expect("valid");
        let complains = |way, picture| {
            let contender = Contender::new(way, Level::best());
            stage.complaint(contender, picture, &reference).is_some()
        };
        for way in [LAB, Way::Hierarchy, Way::Relative, Way::Proven] {
            assert!(!complains(way, &reference), "{way:?}");
            assert!(complains(way, &off), "{way:?}");
            assert!(complains(way, &other), "{way:?}");
        }
        assert!(!complains(Way::Baseline, &off));
        assert!(complains(Way::Baseline, &other));
    }
}
