//! From the recipe that was found to a verdict.

use super::acne::Speckle;
use super::best::{Best, HOPELESS};
use super::clauses::{Said, said};
use super::evidence::{Evidence, distance};
use super::finding::{self, Finding};
use super::fit::{Fit, around, difference};
use super::loss::Loss;
use super::recipe::Recipe;
use super::refine::factor;
use super::search::{Candidate, finely, in_its_conventions, search};
use super::shade::Drawn;
use super::surface::{Object, Region};
use super::{Code, Conventions, Diagnosis, Margin, Verdict, palette, shadow};
use crate::error::Invalid;
use crate::figure::Figure;
use crate::film::Film;
use crate::picture::Picture;

/// Candidates that are compared on the whole picture.
const FINALISTS: usize = 3;

/// Judges a picture.
pub(super) fn reach(
    picture: &Picture,
    figure: &'static Figure,
    expected: &Recipe,
    losses: &[&dyn Loss],
) -> Result<Diagnosis, Invalid> {
    let (candidates, fine, number) = search(picture, expected, losses)?;
    let candidates = finely(&fine, candidates, expected)?;
    let size = picture.size();
    let everything = Region {
        left: 0,
        top: 0,
        width: size.width(),
        height: size.height(),
    };
    let whole = Evidence::new(picture, vec![everything], fine.loss);
    let mut finalists = vec![];
    for candidate in candidates.iter().take(FINALISTS) {
        let recipe = with_acne(&whole, candidate.recipe, expected)?;
        finalists.push(Candidate {
            recipe,
            error: whole.error(&recipe)?,
            knobs: recipe.knobs(expected),
        });
    }
    finalists.sort_by(|a, b| a.rank().total_cmp(&b.rank()));
    let best = finalists.first().map_or(*expected, |best| best.recipe);
    let is_near = finalists.first().is_some_and(|best| best.error <= HOPELESS);
    let best = if is_near {
        let drawn = whole.drawn(&best)?;
        let best = shadow::displaced(picture, &whole, &best, &drawn)?;
        necessary(&whole, with_acne(&whole, best, expected)?, expected)?
    } else {
        best
    };
    Case {
        picture,
        figure,
        expected,
        sample: fine,
        whole,
        candidates,
        loss: number,
    }
    .conclude(best)
}

/// The recipe with acne on the objects that are speckled, and on no other.
///
/// Where acne averages out, a colour or a power that was fitted to what is left of the light says
/// nothing; there the expected ones hold.
fn with_acne(whole: &Evidence, mut recipe: Recipe, expected: &Recipe) -> Result<Recipe, Invalid> {
    recipe.acne = [false; 2];
    if recipe.viewpoint.shadow.is_none() {
        return Ok(recipe);
    }
    let mut bright = recipe;
    (bright.power, bright.colors) = (expected.power, expected.colors);
    let tolerance = whole.loss.tolerance();
    let (drawn, bright_drawn) = (whole.predicted(&recipe)?, whole.predicted(&bright)?);
    for object in [Object::Sphere, Object::Plane] {
        let Some(index) = object.index() else {
            continue;
        };
        let speckle = Speckle::of(whole, &bright, &bright_drawn, object);
        if speckle.is_acne(tolerance) && (tolerance > 0 || speckle.is_averaged()) {
            let mut darkened = recipe;
            darkened.acne[index] = true;
            (darkened.power, darkened.colors[index]) = (bright.power, bright.colors[index]);
            // A darker colour of the same hue would not be speckled.
            let is_darker = recipe.power == expected.power
                && factor(recipe.colors[index], expected.colors[index], tolerance)
                    .is_some_and(|x| x < 1.0);
            if is_darker || whole.error(&darkened)? <= whole.error(&recipe)? {
                recipe = darkened;
                continue;
            }
        }
        let speckle = Speckle::of(whole, &recipe, &drawn, object);
        recipe.acne[index] = speckle.is_acne(tolerance);
    }
    Ok(recipe)
}

/// The recipe without the faults that explain no more than their absence does; with the other
/// film, if that explains the few pixels in which it shows.
fn necessary(whole: &Evidence, mut recipe: Recipe, expected: &Recipe) -> Result<Recipe, Invalid> {
    let mut other = recipe;
    other.film = match recipe.film {
        Film::Clamp => Film::Wrap,
        Film::Wrap => Film::Clamp,
    };
    if is_better(whole, &other, &recipe)? {
        recipe = other;
    }
    for code in recipe.faults(expected) {
        if matches!(code, Code::Acne | Code::OtherFigure) {
            continue;
        }
        let without = recipe.without(code, expected);
        if !is_better(whole, &recipe, &without)? {
            recipe = without;
        }
    }
    Ok(recipe)
}

/// Whether a recipe explains the pixels in which the two differ clearly better than the other.
pub(super) fn is_better(
    whole: &Evidence,
    recipe: &Recipe,
    other: &Recipe,
) -> Result<bool, Invalid> {
    let (drawn, other_drawn) = (whole.predicted(recipe)?, whole.predicted(other)?);
    let (places, _) = difference(&drawn, &other_drawn, whole.size.width(), 1);
    let error = |recipe: &Recipe, drawn: &[Drawn]| -> f64 {
        let off = |&at: &usize| whole.pixel_error(recipe, &drawn[at], whole.observed[at]);
        places.iter().map(off).sum()
    };
    Ok(error(recipe, &drawn) <= 0.8 * error(other, &other_drawn) && !places.is_empty())
}

/// A picture and everything found out about it on the way to the verdict.
struct Case<'a> {
    picture: &'a Picture,
    figure: &'static Figure,
    expected: &'a Recipe,
    sample: Evidence<'a>,
    whole: Evidence<'a>,
    candidates: Vec<Candidate>,
    loss: usize,
}

impl Case<'_> {
    /// The diagnosis, where this recipe is the nearest.
    fn conclude(&self, best: Recipe) -> Result<Diagnosis, Invalid> {
        let (whole, expected) = (&self.whole, self.expected);
        let best = in_its_conventions(&self.sample, best)?;
        let (best, shows_t_max) = with_t_max(whole, best)?;
        let fit = Fit::of(whole, &best, &whole.predicted(&best)?);
        let mut diagnosis = Diagnosis {
            figure: self.figure.name,
            verdict: Verdict::Unknown,
            conventions: Conventions {
                sampling: best.viewpoint.sampling,
                rounding: best.rounding,
                loss: self.loss,
                t_max: shows_t_max.then_some(best.viewpoint.t_max),
            },
            findings: vec![],
            shown: vec![],
            not_shown: vec![],
            invisible: vec![],
            margin: margin(&self.sample, &best, expected, &self.candidates)?,
        };
        let is_blank = palette::is_blank(self.picture);
        if !fit.is_good(whole, &best) || is_blank {
            if !is_blank && palette::is_the_labs(self.picture, whole.loss) {
                diagnosis.verdict = Verdict::Faults;
                diagnosis.findings.push(other_scene(self.picture));
            }
            return Ok(diagnosis);
        }
        for code in best.faults(expected) {
            let finding = finding(whole, &best, expected, code)?;
            diagnosis.findings.extend(finding);
        }
        diagnosis
            .findings
            .sort_by_key(|finding| std::cmp::Reverse(finding.pixels));
        diagnosis.verdict = if diagnosis.findings.is_empty() {
            Verdict::Conforms
        } else {
            Verdict::Faults
        };
        let Said {
            shown,
            not_shown,
            invisible,
        } = said(&self.sample, &best, expected, shows_t_max)?;
        (diagnosis.shown, diagnosis.not_shown) = (shown, not_shown);
        diagnosis.invisible = invisible;
        Ok(diagnosis)
    }
}

/// A fault of the recipe, with the pixels that show it; `None` where none does.
fn finding(
    whole: &Evidence,
    best: &Recipe,
    expected: &Recipe,
    code: Code,
) -> Result<Option<Finding>, Invalid> {
    let drawn = whole.drawn(best)?;
    let (places, words, estimates) = if code == Code::Acne {
        let drawn = whole.predicted(best)?;
        let found = [Object::Sphere, Object::Plane].map(|object| {
            let speckle = Speckle::of(whole, best, &drawn, object);
            object.index().filter(|&i| best.acne[i]).map(|_| speckle)
        });
        // Loss makes averages too: only a sampling that averages says where they come from.
        let lossless = whole.loss.tolerance() == 0;
        let may_average = lossless || best.viewpoint.sampling.is_average();
        let (words, estimates) = finding::acne(found, may_average);
        (dark_pixels(whole, best, &drawn), words, estimates)
    } else {
        let without = whole.drawn(&best.without(code, expected))?;
        let (mut places, _) = difference(&drawn, &without, whole.size.width(), 2);
        if code == Code::OtherFigure && places.is_empty() {
            // Only the acne is missing, which may be wherever there is light.
            places = (0..drawn.len()).filter(|&at| drawn[at].is_lit).collect();
        }
        let (words, estimates) = finding::described(code, best, expected);
        (places, words, estimates)
    };
    if places.is_empty() {
        return Ok(None);
    }
    Ok(Some(Finding {
        code,
        or: (code == Code::Clamped).then_some(Code::Saturated),
        pixels: places.len(),
        region: around(&places, whole.size.width()),
        places,
        message: format!("{words}: {}", code.advice()),
        estimates,
    }))
}

/// The pixels that acne darkens.
fn dark_pixels(whole: &Evidence, recipe: &Recipe, drawn: &[Drawn]) -> Vec<usize> {
    let tolerance = 2 + whole.loss.tolerance();
    let is_dark = |pixel: &Drawn, observed: [u8; 3]| {
        let channel = super::acne::brightest(pixel.rgb);
        let may = pixel.object.index().is_some_and(|index| recipe.acne[index]) && pixel.is_lit;
        may && distance(pixel.rgb, observed) > tolerance && observed[channel] < pixel.rgb[channel]
    };
    let pixels = drawn.iter().zip(&whole.observed).enumerate();
    pixels
        .filter(|(_, (pixel, observed))| is_dark(pixel, **observed))
        .map(|(at, _)| at)
        .collect()
}

fn other_scene(picture: &Picture) -> Finding {
    let size = picture.size();
    Finding {
        code: Code::OtherScene,
        or: None,
        pixels: size.pixels(),
        region: Some(Region {
            left: 0,
            top: 0,
            width: size.width(),
            height: size.height(),
        }),
        places: vec![],
        message: format!("{}: {}", Code::OtherScene.fact(), Code::OtherScene.advice()),
        estimates: vec![],
    }
}

/// The recipe with the `t_max` that fits best, and whether the picture shows which. It shows in a row
/// at the horizon or nowhere, so only the whole picture tells.
pub(super) fn with_t_max(whole: &Evidence, best: Recipe) -> Result<(Recipe, bool), Invalid> {
    let other = best.with_other_t_max();
    let shows = whole.drawn(&best)? != whole.drawn(&other)?;
    let mut best = Best::of(whole, best)?;
    if shows {
        best.consider(other)?;
    }
    Ok((best.recipe, shows))
}

/// The nearest explanation that lacks one of the faults found, or adds a visible one to none.
fn margin(
    sample: &Evidence,
    best: &Recipe,
    expected: &Recipe,
    candidates: &[Candidate],
) -> Result<Margin, Invalid> {
    let faults = best.faults(expected);
    let drawn = sample.drawn(best)?;
    let mut runner_up: Option<Best> = None;
    let without = faults.iter().map(|code| best.without(*code, expected));
    let others = candidates.iter().map(|candidate| candidate.recipe);
    for recipe in without.chain(others) {
        let its_faults = recipe.faults(expected);
        let adds_only = faults.iter().all(|fault| its_faults.contains(fault));
        let is_the_same = its_faults == faults;
        if is_the_same || (adds_only && !faults.is_empty()) || sample.drawn(&recipe)? == drawn {
            continue;
        }
        match &mut runner_up {
            Some(runner_up) => drop(runner_up.consider(recipe)?),
            None => runner_up = Some(Best::of(sample, recipe)?),
        }
    }
    let (runner_up, runner_up_error) = runner_up.map_or((vec![], 255.0), |other| {
        (other.recipe.faults(expected), other.error)
    });
    Ok(Margin {
        error: sample.error(best)?,
        runner_up,
        runner_up_error,
    })
}
