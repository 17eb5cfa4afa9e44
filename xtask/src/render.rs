//! `cargo xtask render`: the picture of a scene file.

mod job;

use crate::arguments::{Format, Machine, parse_png, parse_size};
use crate::error::{Error, Result};
use crate::output;
use crate::picture_file;
use crate::proof::Proof;
use crate::scene_file;
use crate::table::Table;
use crate::whole_file::WholeFile;
use job::{Job, Method, Row};
use ombrage::{Quality, Shadow, Size};
use std::path::PathBuf;
use std::process::ExitCode;

/// Draw the picture of a scene file (docs/scenes.md) as PNG
///
/// The kit's own chain works relative to the camera and needs no offset for shadow rays. With
/// --shadow it is the lab's chain instead, whose shadow rays leave their surface in the way named.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask render tests/scenes/base.toml --out base.png
  cargo xtask render tests/scenes/base.toml --shadow self-hitting --float f32 --out acne.png
  cargo xtask render tests/scenes/many125.toml --size 1920x1280 --json --out many.png
  cargo xtask render tests/scenes/planet.toml --proven --out planet.png

The ways of --shadow: relative (the kit's own chain, the default), self-hitting, half-open,
t-min=LENGTH, offset=LENGTH, ulp-offset, error-bound, reprojection, skip-self.

f64 is the default because it holds the numbers of the file as they are. f32 is faster; the kit's own
chain then changes a few bytes by 1.

Exit status: 0 done; 1 --proven pixels are undecided; 2 bad input.")]
pub struct Args {
    /// The scene file
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,

    /// Compute in this format
    #[arg(long, value_enum, default_value_t = Format::F64)]
    float: Format,

    /// How shadow rays leave their surface
    #[arg(long, value_name = "NAME", default_value = "relative", value_parser = parse_shadow)]
    shadow: Choice,

    /// How well the lab's chain computes: textbook, stable or wide [default: textbook]
    #[arg(long, value_name = "NAME", value_parser = parse_quality)]
    quality: Option<Quality>,

    /// Prove every byte to be that of exact mathematics; the table says in which precision (see
    /// docs/proven.md)
    #[arg(long, conflicts_with = "float")]
    proven: bool,

    /// Width and height in pixels, at most 2^28 pixels in all [default: the file's]
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<Size>,

    #[command(flatten)]
    machine: Machine,

    /// Print the table as JSON
    #[arg(long)]
    json: bool,

    /// Write the picture to this file, whose name ends in .png
    #[arg(long, value_name = "FILE.png", value_parser = parse_png)]
    out: PathBuf,
}

/// The way that `--shadow` names.
#[derive(Clone, Copy)]
enum Choice {
    Relative,
    Lab(Shadow),
}

/// Runs the command.
///
/// # Errors
/// If the scene file is bad, an option does not fit, or the picture cannot be written.
pub fn run(args: &Args) -> Result<ExitCode> {
    let method = match (args.shadow, args.quality) {
        (Choice::Relative, None) if args.proven => Method::Proven,
        _ if args.proven => {
            let what = "--proven is for the kit's own chain: leave out --shadow and --quality";
            return Err(Error::new(what));
        }
        (Choice::Relative, None) => Method::Relative,
        (Choice::Relative, Some(_)) => {
            let what = "--quality is for the lab's chain: give --shadow ulp-offset or another too";
            return Err(Error::new(what));
        }
        (Choice::Lab(shadow), quality) => Method::Lab {
            shadow,
            quality: quality.unwrap_or(Quality::Textbook),
        },
    };
    let content = scene_file::load(&args.scene)?;
    let size = args.size.unwrap_or(content.size);
    let job = Job {
        path: &args.scene,
        content: &content,
        method,
        size,
        machine: args.machine,
    };
    let mut file = WholeFile::create(&args.out)?;
    let (picture, row) = match args.float {
        Format::F32 => job.draw::<f32>(&args.out)?,
        Format::F64 => job.draw::<f64>(&args.out)?,
    };
    file.write(|out| picture_file::write(&picture, out))?;
    file.keep()?;
    output::print(&report(&row, args.json)?)?;
    match row.proof {
        Some(proof) if !proof.is_complete() => {
            if !args.json {
                let list = proof.list(&content.name);
                output::print(&format!("not proven:\n{list}"))?;
            }
            Ok(ExitCode::FAILURE)
        }
        _ => Ok(ExitCode::SUCCESS),
    }
}

fn report(row: &Row, json: bool) -> Result<String> {
    if json {
        let mut text = serde_json::to_string_pretty(row)
            .map_err(|error| Error::new(format!("cannot write the table as JSON: {error}")))?;
        text += "\n";
        return Ok(text);
    }
    let mut heads = Row::HEADS.to_vec();
    if row.proof.is_some() {
        heads.extend(Proof::HEADS);
    }
    let mut table = Table::new(&heads);
    table.row(row.cells());
    Ok(table.render())
}

fn parse_shadow(text: &str) -> std::result::Result<Choice, String> {
    if text == "relative" {
        return Ok(Choice::Relative);
    }
    Shadow::named(text).map(Choice::Lab).ok_or_else(|| {
        let known = Shadow::ALL.map(Shadow::name).join(", ");
        format!("write relative, {known}, or t-min= or offset= with another length from 0 on")
    })
}

fn parse_quality(text: &str) -> std::result::Result<Quality, String> {
    Quality::named(text).ok_or_else(|| {
        let known = Quality::ALL.map(Quality::name).join(", ");
        format!("write one of {known}")
    })
}
