//! `cargo xtask explain`: one pixel's way from ray to byte, step by step.

mod digits;
mod layout;
mod verdict;

use crate::case::{Case, direct};
use crate::error::{Error, Result};
use crate::output;
use ombrage::conformance::{Drawing, explain};
use ombrage::{FIGURES, Figure, Film, Integrator, Quality, Shadow, Size, lab};
use std::path::Path;
use std::process::ExitCode;

/// Explain one pixel: ray, hits, point, normal, light, every strategy's shadow ray, radiance and
/// byte, in f32, in f64 and in truth, and where digits are lost
///
/// The chain is the lab's, as the figure has it; of a scene file with textbook kernels, a clamp and
/// the shadow strategy ulp-offset. The truth is computed in double-double from the numbers as they
/// are written; in f32 they are rounded first.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask explain 3a 300 290                   why is this pixel of Figure 3(a) black?
  cargo xtask explain 2a 299 133                   where does the byte wrap?
  cargo xtask explain tests/scenes/planet.toml 150 120 --shadow error-bound
  cargo xtask explain 3c 0 399 --json              every number, for machines

o, d: the ray; t: where it meets each object; p, n: hit point and normal; l, distance, E: the light
sample; cos: n·l; L: the radiance; ulp: units in the last place from the truth; bits: leading bits
that agree with it, of 24 in f32 and 53 in f64; a letter marks where digits are lost, and the line
of that letter says why. Of the strategies, acne: the surface blocks its own light; by: another
object does; !: that is not the truth.

Exit status: 0 explained; 2 bad input.")]
pub struct Args {
    /// A figure (1, 2a, 2b, 3a, 3b, 3c) or a scene file that ends in .toml
    #[arg(value_name = "FIGURE|SCENE.toml")]
    scene: String,

    /// The column of the pixel, from 0 at the left
    #[arg(value_name = "X", allow_hyphen_values = true)]
    x: String,

    /// The row of the pixel, from 0 at the top
    #[arg(value_name = "Y", allow_hyphen_values = true)]
    y: String,

    /// The strategy that decides the radiance
    #[arg(long, value_name = "NAME", value_parser = shadow)]
    shadow: Option<Shadow>,

    /// The light, where there are several, from 0
    #[arg(long, value_name = "N", default_value = "0")]
    light: usize,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

fn shadow(name: &str) -> std::result::Result<Shadow, String> {
    let names = Shadow::ALL.map(Shadow::name).join(", ");
    Shadow::named(name).ok_or_else(|| format!("choose one of {names}"))
}

/// What is explained, and how it is drawn.
struct Subject {
    case: Case,
    integrator: Integrator,
    film: Film,
    /// Where a pixel of the figure comes from, if it is not the pixel itself.
    figure: Option<&'static Figure>,
}

/// Runs the command.
///
/// # Errors
/// If there is no such figure, scene, pixel or light.
pub fn run(args: &Args) -> Result<ExitCode> {
    let subject = subject(args)?;
    let case = &subject.case;
    let pixel = [
        coordinate("X", "column", &args.x, case.size.width())?,
        coordinate("Y", "row", &args.y, case.size.height())?,
    ];
    let drawing = Drawing {
        size: case.size,
        pixel: source(&subject, pixel),
        integrator: subject.integrator,
        film: subject.film,
    };
    let lights = case.scene.lights().len();
    if args.light > 0 && args.light >= lights {
        return Err(Error::new(format!(
            "--light {} is not in the scene: it has {lights}, numbered from 0",
            args.light
        )));
    }
    let explanation = explain(&case.scene, &case.view, &drawing)?;
    let shadows = verdict::all(case, &explanation, &drawing, args.light)?;
    let told = layout::Told {
        title: title(&subject, args, pixel, &drawing),
        explanation: &explanation,
        steps: explanation.steps(args.light),
        shadows,
        shadow: match subject.integrator {
            Integrator::RayCast(_) => None,
            Integrator::DirectLighting(direct) => direct.shadow.map(Shadow::name),
        },
        light: args.light,
        lights,
        size: case.size,
        pixel: drawing.pixel,
    };
    output::print(&if args.json { told.json()? } else { told.text() })?;
    Ok(ExitCode::SUCCESS)
}

fn subject(args: &Args) -> Result<Subject> {
    let figure = Figure::named(&args.scene);
    let mut subject = if let Some(figure) = figure {
        Subject {
            case: Case {
                name: format!("Figure {}", figure.name),
                scene: lab::scene()?,
                view: lab::view(),
                size: Size::LAB,
            },
            integrator: figure.integrator,
            film: figure.film,
            figure: Some(figure),
        }
    } else {
        let path = Path::new(&args.scene);
        if path.extension().is_none_or(|extension| extension != "toml") {
            return Err(Error::new(format!(
                "{:?} is no figure: choose one of {}, or give a scene file that ends in .toml",
                args.scene,
                FIGURES.map(|figure| figure.name).join(", ")
            )));
        }
        Subject {
            case: Case::read(path)?,
            integrator: direct(Quality::Textbook, Some(Shadow::UlpOffset)),
            film: Film::Clamp,
            figure: None,
        }
    };
    match (&mut subject.integrator, args.shadow) {
        (Integrator::RayCast(_), Some(_)) => Err(Error::new(format!(
            "{} casts no shadow rays: leave --shadow out",
            subject.case.name
        ))),
        (Integrator::DirectLighting(direct), Some(shadow)) => {
            direct.shadow = Some(shadow);
            Ok(subject)
        }
        (_, None) => Ok(subject),
    }
}

fn coordinate(name: &str, what: &str, text: &str, count: u32) -> Result<u32> {
    let number = text.parse().ok().filter(|number| *number < count);
    let last = count - 1;
    let advice =
        || format!("{name} is {text:?}: write the {what} as a whole number from 0 to {last}");
    number.ok_or_else(|| Error::new(advice()))
}

/// The pixel of the whole picture that an enlarged figure shows at this one.
fn source(subject: &Subject, [x, y]: [u32; 2]) -> [u32; 2] {
    match subject.figure.and_then(|figure| figure.detail) {
        Some(detail) => {
            let [left, top, ..] = detail.region(subject.case.size);
            [left + x / detail.factor, top + y / detail.factor]
        }
        None => [x, y],
    }
}

fn title(subject: &Subject, args: &Args, [x, y]: [u32; 2], drawing: &Drawing) -> String {
    let (width, height) = (drawing.size.width(), drawing.size.height());
    let how = match subject.integrator {
        Integrator::RayCast(quality) => format!("{}, the light at the eye", quality.name()),
        Integrator::DirectLighting(direct) => {
            let shadow = direct.shadow.map_or("no shadows".into(), Shadow::name);
            format!("{}, {shadow}", direct.quality.name())
        }
    };
    let film = match subject.film {
        Film::Clamp => "clamp",
        Film::Wrap => "wrap",
    };
    let mut title = format!(
        "{}, pixel ({x}, {y}) of {width} x {height}; {how}, {film}",
        subject.case.name
    );
    if drawing.pixel != [x, y] {
        title += &format!(
            "; enlarged from ({}, {})",
            drawing.pixel[0], drawing.pixel[1]
        );
    }
    if drawing.pixel == [x, y] && args.light > 0 {
        title += &format!("; light {}", args.light);
    }
    title
}
