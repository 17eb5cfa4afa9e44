//! One fault of a picture.

use super::acne::Speckle;
use super::recipe::{Cosine, POWER, Recipe, ShadowRay, Transfer};
use super::surface::Region;
use super::{Code, Severity};

/// One fault: what, where, how much.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What is wrong.
    pub code: Code,
    /// Another code that the same picture may have; one picture cannot tell the two apart.
    pub or: Option<Code>,
    /// How many pixels show it.
    pub pixels: usize,
    /// The smallest rectangle around them.
    pub region: Option<Region>,
    /// The pixels, each by its place in the picture, row-major.
    pub places: Vec<usize>,
    /// What was found, and what to look for, in a sentence or two.
    pub message: String,
    /// What was measured.
    pub estimates: Vec<(&'static str, Estimate)>,
}

/// A measured quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Estimate {
    /// A number: a length in scene units, an angle in degrees, a power, a part of the whole.
    Number(f64),
    /// Several of them: a colour, a displacement along x and z.
    Numbers(Vec<f64>),
    /// A choice: a curve, an object, a figure.
    Name(&'static str),
}

impl Finding {
    /// How much it matters.
    pub fn severity(&self) -> Severity {
        self.code.severity()
    }

    /// The clause that does not hold.
    pub fn clause(&self) -> &'static str {
        self.code.clause()
    }
}

/// The objects that can be named.
const OBJECTS: [&str; 2] = ["sphere", "plane"];

fn objects(which: [bool; 2]) -> &'static str {
    match which {
        [true, true] => "sphere and plane",
        [true, false] => OBJECTS[0],
        _ => OBJECTS[1],
    }
}

/// A number with as many digits as its measurement is worth.
fn rounded(x: f64) -> f64 {
    let digits = 3 - x.abs().max(1e-9).log10().floor() as i32 - 1;
    let unit = 10_f64.powi(digits);
    (x * unit).round() / unit
}

/// A colour in words.
fn triple([red, green, blue]: [f64; 3]) -> String {
    format!("({red}, {green}, {blue})")
}

/// What a fault's knobs say in numbers, and the sentence about them.
pub(super) fn described(
    code: Code,
    recipe: &Recipe,
    expected: &Recipe,
) -> (String, Vec<(&'static str, Estimate)>) {
    let ShadowRay {
        offset,
        shift,
        light,
    } = recipe.viewpoint.shadow.unwrap_or_default();
    let one = |name, value| vec![(name, Estimate::Number(rounded(value)))];
    match code {
        Code::OtherFigure => {
            let figure = figure_of(recipe);
            let words = format!("it is drawn as Figure {figure} is");
            (words, vec![("figure", Estimate::Name(figure))])
        }
        Code::OffsetTooLarge => {
            let words = format!(
                "the shadow's edge is that of an offset of {}",
                rounded(offset)
            );
            (words, one("offset", offset))
        }
        Code::ShadowShifted => {
            let by_light = light != [0.0; 2];
            let by = if by_light { light } else { shift };
            let what = if by_light {
                "the light of shadow rays"
            } else {
                "their origin"
            };
            let [x, z] = by.map(rounded);
            let name = if by_light { "light_shift" } else { "shift" };
            let words =
                format!("the shadow lies as if {what} were off by {x} along x, {z} along z");
            (words, vec![(name, Estimate::Numbers(vec![x, z]))])
        }
        Code::CosineUnclamped => {
            let (words, kind) = match recipe.cosine {
                Cosine::Absolute => ("surfaces are lit from behind", "absolute"),
                _ => ("surfaces that face away have negative radiance", "signed"),
            };
            (words.to_owned(), vec![("cosine", Estimate::Name(kind))])
        }
        Code::WrongPower if recipe.light_at_eye => {
            let words = format!("everything is {} times as bright", rounded(recipe.power));
            (words, one("factor", recipe.power))
        }
        Code::WrongPower => {
            let power = recipe.power * POWER;
            let words = format!("the light shines with a power of {}", rounded(power));
            (words, one("power", power))
        }
        Code::NormalFlipped => {
            let which = objects(recipe.flipped);
            let words = format!("the normals of {which} show away from the camera");
            (words, vec![("object", Estimate::Name(which))])
        }
        Code::Gamma => {
            let (words, kind) = match recipe.transfer {
                Transfer::Srgb => ("bytes are sRGB-encoded", "srgb"),
                _ => ("bytes are encoded with a gamma of 2.2", "2.2"),
            };
            (words.to_owned(), vec![("gamma", Estimate::Name(kind))])
        }
        Code::WrongColour => {
            let differs = [0, 1].map(|i| recipe.colors[i] != expected.colors[i]);
            let which = objects(differs);
            let mut estimates = vec![("object", Estimate::Name(which))];
            let mut words = vec![];
            for index in [0, 1].into_iter().filter(|&i| differs[i]) {
                let color = recipe.colors[index].map(rounded);
                words.push(format!("the {} is {}", OBJECTS[index], triple(color)));
                estimates.push((OBJECTS[index], Estimate::Numbers(color.to_vec())));
            }
            (words.join(" and "), estimates)
        }
        Code::WrongBackground => {
            let color = recipe.background.map(rounded);
            let words = format!("the background is {}", triple(color));
            (
                words,
                vec![("background", Estimate::Numbers(color.to_vec()))],
            )
        }
        Code::WrongFov => {
            let fov = recipe.viewpoint.fov;
            let words = format!("the field of view is {} degrees high", rounded(fov));
            (words, one("fov", fov))
        }
        _ => (code.fact().to_owned(), vec![]),
    }
}

/// The figure that a recipe of another figure is.
fn figure_of(recipe: &Recipe) -> &'static str {
    match (recipe.light_at_eye, recipe.viewpoint.shadow, recipe.film) {
        (true, ..) => "1",
        (_, Some(_), _) => "3c",
        (_, None, crate::film::Film::Wrap) => "2a",
        (_, None, crate::film::Film::Clamp) => "2b",
    }
}

/// Acne in words and numbers; of each object that has it. Whether its pixels may be averages.
pub(super) fn acne(
    found: [Option<Speckle>; 2],
    may_average: bool,
) -> (String, Vec<(&'static str, Estimate)>) {
    let which = objects([found[0].is_some(), found[1].is_some()]);
    let mut estimates = vec![("object", Estimate::Name(which))];
    let mut words = vec![];
    for (name, speckle) in OBJECTS.into_iter().zip(found) {
        let Some(speckle) = speckle else { continue };
        let rate = 1.0 - speckle.mean;
        let percent = (100.0 * rate * 10.0).round() / 10.0;
        let averaged = may_average && speckle.is_averaged();
        words.push(if averaged {
            format!(
                "averaging over a pixel turns it into noise: the {name} has lost {percent} % of \
                 its light"
            )
        } else {
            format!("{percent} % of the lit pixels of the {name} are falsely black")
        });
        estimates.push((name, Estimate::Number(rounded(rate))));
        if averaged {
            estimates.push(("averaged", Estimate::Name(name)));
        }
    }
    (words.join("; "), estimates)
}
