//! Proven pictures of the figures and of every scene, against a reference of 256 bits by another
//! formulation.
//!
//! `OMBRAGE_REFERENCE_PIXELS` sets how many random pixels of each picture are judged: 6 of small
//! ones if it is not set, `all` for every pixel, which is meant for the figures.
//! `OMBRAGE_REFERENCE_SCENES` names the scenes, separated by commas, where it is not to be all.

#[path = "proven/reference.rs"]
mod reference;

use ombrage::{FIGURES, Figure, Film, Lighting, Proven, Rung, Size, lab, render_proven};
use reference::Reference;
use xtask::case::{self, Case};
use xtask::error::Error;
use xtask::parallel;

/// How many pixels are judged.
#[derive(Clone, Copy)]
enum Samples {
    /// A few random ones of small pictures.
    Few,
    /// So many random ones.
    Random(usize),
    All,
}

/// What was judged.
#[derive(Default)]
struct Judged {
    pixels: usize,
    /// Neither black nor of the background.
    lit: usize,
    /// What only exact arithmetic decides, and otherwise than the reference, whose camera is rounded.
    ties: usize,
    wrong: Vec<String>,
}

fn samples() -> Samples {
    match std::env::var("OMBRAGE_REFERENCE_PIXELS").as_deref() {
        Err(_) => Samples::Few,
        Ok("all") => Samples::All,
        Ok(text) => Samples::Random(
            text.parse()
                .expect("OMBRAGE_REFERENCE_PIXELS: a number or all"),
        ),
    }
}

/// The indices of the pixels to judge, the same in every run.
fn places(size: Size) -> Vec<usize> {
    let count = match samples() {
        Samples::All => return (0..size.pixels()).collect(),
        Samples::Few => 6,
        Samples::Random(count) => count,
    };
    // Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8 (2003).
    let mut random = 0x9e37_79b9_7f4a_7c15_u64;
    let places = (0..count).map(|_| {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random >> 33) as usize % size.pixels()
    });
    places.collect()
}

fn judge(proven: &Proven, reference: &Reference, places: &[usize]) -> Judged {
    let (width, rungs) = (proven.picture().size().width() as usize, proven.rungs());
    let judge = |places: &&[usize]| -> Result<Judged, Error> {
        let mut judged = Judged::default();
        for &place in *places {
            let (column, row) = ((place % width) as u32, (place / width) as u32);
            let found = proven.picture().pixel(column, row);
            let expected = reference.pixel(column, row);
            let is_tie = rungs[place] == Rung::Exact && found != expected;
            let Some(expected) = expected.filter(|_| !is_tie) else {
                judged.ties += 1;
                continue;
            };
            judged.pixels += 1;
            judged.lit += usize::from(expected != [0; 3] && expected != [127; 3]);
            if found != Some(expected) {
                let what = format!("column {column}, row {row}: {found:?}, not {expected:?}");
                judged.wrong.push(what);
            }
        }
        Ok(judged)
    };
    let parts: Vec<&[usize]> = places.chunks(256).collect();
    let parts = parallel::map(&parts, judge).expect("nothing fails");
    parts.into_iter().fold(Judged::default(), |mut sum, part| {
        sum.pixels += part.pixels;
        sum.lit += part.lit;
        sum.ties += part.ties;
        sum.wrong.extend(part.wrong);
        sum
    })
}

/// Judges a picture; none of its bytes may be wrong.
fn check(case: &Case, lighting: Lighting, film: Film) -> Judged {
    let proven = render_proven(&case.scene, &case.view, case.size, lighting, film).expect("valid");
    assert_eq!(proven.undecided(), [], "{}", case.name);
    let judged = judge(
        &proven,
        &Reference::new(case, lighting, film),
        &places(case.size),
    );
    let Judged {
        pixels,
        lit,
        ties,
        wrong,
    } = &judged;
    println!(
        "{}: {pixels} pixels, {lit} lit, {ties} ties, {} wrong",
        case.name,
        wrong.len()
    );
    assert_eq!(wrong, &Vec::<String>::new(), "{}", case.name);
    judged
}

fn figure(name: &str) {
    let figure = Figure::named(name).expect("a figure");
    let case = Case {
        name: format!("figure {name}"),
        scene: lab::scene().expect("valid"),
        view: lab::view(),
        size: Size::LAB,
    };
    let lighting = figure
        .lighting()
        .expect("a figure without errors of rounding");
    let judged = check(&case, lighting, figure.film);
    assert!(judged.pixels > 0 && judged.ties == 0);
}

#[test]
fn pixels_of_figure_1_are_those_of_the_reference() {
    figure("1");
}

#[test]
fn pixels_of_figure_2a_are_those_of_the_reference() {
    figure("2a");
}

#[test]
fn pixels_of_figure_2b_are_those_of_the_reference() {
    figure("2b");
}

#[test]
fn pixels_of_figure_3c_are_those_of_the_reference() {
    figure("3c");
}

#[test]
fn every_figure_without_errors_of_rounding_has_its_test() {
    let named = FIGURES.iter().filter(|figure| figure.lighting().is_some());
    let named: Vec<_> = named.map(|figure| figure.name).collect();
    assert_eq!(named, ["1", "2a", "2b", "3c"]);
}

/// The case, or a small picture of it where few pixels are judged.
fn sized(case: &Case, width: u32) -> Case {
    match samples() {
        Samples::Few => case.at_most(width).expect("valid"),
        _ => case.clone(),
    }
}

#[test]
fn pixels_of_every_scene_are_those_of_the_reference() {
    let names = std::env::var("OMBRAGE_REFERENCE_SCENES").unwrap_or_default();
    let names = names.split(',').filter(|name| !name.is_empty());
    let names: Vec<String> = names.map(str::to_owned).collect();
    let cases = case::load(&names).expect("scenes");
    let mut sum = Judged::default();
    for case in &cases {
        let judged = check(&sized(case, 60), Lighting::Shadowed, Film::Clamp);
        sum.pixels += judged.pixels;
        sum.lit += judged.lit;
    }
    let (pixels, lit) = (sum.pixels, sum.lit);
    println!("all scenes: {pixels} pixels, {lit} lit");
    assert!(pixels > 5 * cases.len(), "{pixels} judged");
    assert!(lit > 30 || !names.is_empty(), "{lit} lit");
}

/// The pixels that f32 cannot prove are the ones that are easy to get wrong.
#[test]
fn what_was_hard_to_prove_is_right() {
    for name in ["base", "base_moved_1e7", "three_lights"] {
        let case = sized(&case::load(&[name.into()]).expect("a scene")[0], 150);
        let (lighting, film) = (Lighting::Shadowed, Film::Clamp);
        let proven = render_proven(&case.scene, &case.view, case.size, lighting, film);
        let proven = proven.expect("valid");
        let rungs = proven.rungs();
        let hard = (0..rungs.len()).filter(|&i| rungs[i] != Rung::F32);
        let hard: Vec<usize> = match samples() {
            Samples::Few => hard.take(60).collect(),
            _ => hard.collect(),
        };
        let judged = judge(&proven, &Reference::new(&case, lighting, film), &hard);
        assert_eq!(judged.wrong, Vec::<String>::new(), "{name}");
        assert!(judged.pixels > 0, "{name}");
        println!("{name}: {} hard pixels", judged.pixels);
    }
}
