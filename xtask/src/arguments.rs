//! Options that several commands have.

use crate::error::Result;
use clap::ValueEnum;
use ombrage::{Engine, Level, Size};
use std::num::NonZero;
use std::path::PathBuf;
use std::thread;

/// The format that a picture is computed in.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Format {
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}

impl Format {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Format::F32 => "f32",
            Format::F64 => "f64",
        }
    }
}

/// What to compute with. No choice changes a pixel.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct Machine {
    /// Compute at this processor level: auto, scalar, fallback, sse2, sse4.2, avx2, avx512, neon
    #[arg(long, value_name = "LEVEL", default_value = "auto")]
    level: Level,

    /// Compute on so many threads, at most 1024 [default: what machine and picture are worth]
    #[arg(long, value_name = "N", value_parser = parse_threads)]
    threads: Option<NonZero<usize>>,
}

impl Machine {
    /// The engine; for long work with all threads of the machine, unless told otherwise.
    ///
    /// # Errors
    /// If this processor does not have the level.
    pub fn engine(self, long: bool) -> Result<Engine> {
        let all = || thread::available_parallelism().ok().filter(|_| long);
        Ok(Engine::new(self.level, self.threads.or_else(all))?)
    }
}

/// Reads the name of a PNG file to be written.
///
/// # Errors
/// If it does not end in `.png`.
pub fn parse_png(text: &str) -> std::result::Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let is_png = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    let advice = || "pictures are PNG files: write a name that ends in .png".to_owned();
    is_png.then_some(path).ok_or_else(advice)
}

/// Reads `600x400`.
///
/// # Errors
/// If it is anything else, or no size that a picture can have.
pub fn parse_size(text: &str) -> std::result::Result<Size, String> {
    let advice = "write width x height, such as 600x400";
    let (width, height) = text.split_once('x').ok_or(advice)?;
    let number = |side: &str| side.parse::<u32>().map_err(|_| advice);
    Size::new(number(width)?, number(height)?).map_err(|invalid| invalid.to_string())
}

fn parse_threads(text: &str) -> std::result::Result<NonZero<usize>, String> {
    let threads = text
        .parse()
        .ok()
        .filter(|threads: &NonZero<usize>| threads.get() <= 1024);
    threads.ok_or_else(|| "write a whole number from 1 to 1024".to_owned())
}
