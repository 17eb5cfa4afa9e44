//! The parts of the diagnosis, each by itself.

#[path = "../../../tests/support/naive.rs"]
mod naive;

mod acne;
mod changes;
mod clauses;
mod drawing;
mod evidence;
mod fit;
mod measure;
mod numbers;
mod recipe;
mod shadow;
mod speckle;
mod verdict;
mod words;

use super::evidence::Evidence;
use super::loss::{Loss, Lossless};
use super::recipe::Recipe;
use super::surface::Region;
use super::{Code, Diagnosis, diagnose};
use crate::figure::Figure;
use crate::lab;
use crate::picture::{Picture, Size};

/// The recipe of a figure.
fn right(figure: &str) -> Recipe {
    let figure = Figure::named(figure).expect("a figure");
    Recipe::of(figure, &lab::scene().expect("the lab's scene"))
}

fn size(width: u32, height: u32) -> Size {
    Size::new(width, height).expect("a size")
}

/// A recipe turned into another.
fn turned(recipe: &Recipe, turn: impl Fn(&mut Recipe)) -> Recipe {
    let mut turned = *recipe;
    turn(&mut turned);
    turned
}

fn everything(size: Size) -> Region {
    let (width, height) = (size.width(), size.height());
    Region {
        left: 0,
        top: 0,
        width,
        height,
    }
}

/// All of a picture.
fn whole<'a>(picture: &Picture, loss: &'a dyn Loss) -> Evidence<'a> {
    Evidence::new(picture, vec![everything(picture.size())], loss)
}

/// The picture that a recipe draws.
fn picture(recipe: &Recipe, size: Size) -> Picture {
    let drawn = whole(&Picture::black(size), &Lossless).drawn(recipe);
    let drawn = drawn.expect("a viewpoint").into_iter();
    Picture::from_pixels(size, drawn.map(|pixel| pixel.rgb).collect()).expect("all pixels")
}

/// A picture with other pixels at some places.
fn changed(picture: &Picture, change: impl Fn(usize, [u8; 3]) -> [u8; 3]) -> Picture {
    let pixels = picture.bytes().as_chunks::<3>().0.iter().enumerate();
    let pixels = pixels.map(|(at, &rgb)| change(at, rgb)).collect();
    Picture::from_pixels(picture.size(), pixels).expect("all pixels")
}

/// Numbers from 0 to 1 that look random, the same in every run.
fn random(seed: u32) -> impl FnMut() -> f64 {
    let mut state = u64::from(seed) ^ 0x9e37_79b9_7f4a_7c15;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// What is said of a picture of a figure.
fn judged(picture: &Picture, figure: &str) -> Diagnosis {
    let figure = Figure::named(figure).expect("a figure");
    diagnose(picture, figure, &[]).expect("a size that is judged")
}

/// A picture that a file has taken something from.
fn lossy(picture: &Picture, loss: &dyn Loss) -> Picture {
    let size = picture.size();
    let mut pixels = picture.bytes().as_chunks::<3>().0.to_vec();
    loss.degrade(size.width(), size.height(), &mut pixels);
    Picture::from_pixels(size, pixels).expect("all pixels")
}

/// What is said of a picture of Figure 3(c) of which a file has taken this.
fn judged_with(picture: &Picture, loss: &dyn Loss) -> Diagnosis {
    let figure = Figure::named("3c").expect("a figure");
    diagnose(&lossy(picture, loss), figure, &[loss]).expect("a size that is judged")
}

/// A picture of which a part of the pixels, here and there, is another's.
fn mixed(picture: &Picture, other: &Picture, part: f64, seed: u32) -> Picture {
    let mut random = random(seed);
    let pixels = other.bytes().as_chunks::<3>().0;
    let is_other: Vec<bool> = pixels.iter().map(|_| random() < part).collect();
    changed(
        picture,
        |at, rgb| if is_other[at] { pixels[at] } else { rgb },
    )
}

fn is_near(found: f64, drawn: f64, tolerance: f64) {
    assert!(
        (found - drawn).abs() <= tolerance,
        "{found}, but {drawn} was drawn"
    );
}

/// The faults that are named.
fn codes(diagnosis: &Diagnosis) -> Vec<Code> {
    diagnosis.findings.iter().map(|found| found.code).collect()
}

/// A loss that leaves of each byte its upper part.
struct Coarse(u8);

impl Loss for Coarse {
    fn degrade(&self, _: u32, _: u32, pixels: &mut [[u8; 3]]) {
        for pixel in pixels {
            *pixel = pixel.map(|byte| byte / self.0 * self.0);
        }
    }

    fn tolerance(&self) -> u8 {
        self.0
    }
}
