//! Pictures from scenes: one primary ray a pixel, row by row, in packets and threads.

mod frame;

pub use frame::{Develop, Draw, Frame, Linear};

use crate::chain::Chain;
use crate::film::Film;
use crate::level::{Level, NoSuchLevel};
use crate::picture::{Picture, Size};
use crate::real::Scalar;
use crate::vector::Vector;
use std::num::NonZero;
use std::ops::Range;
use std::sync::{LazyLock, Mutex, PoisonError};
use std::thread;

/// Renders to bytes: width x height x 3, row-major, as fast as the machine can.
pub fn render<S: Scalar>(chain: &impl Chain<S>, size: Size, film: Film) -> Picture {
    Engine::default().render(chain, size, film)
}

/// Renders to linear radiance, pixel by pixel, row-major, upper left first.
pub fn render_radiance<S: Scalar>(chain: &impl Chain<S>, size: Size) -> Vec<S::Vector> {
    Engine::default().render_radiance(chain, size)
}

/// What a picture is computed with. Every engine gives the same bits; they differ in speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Engine {
    level: Level,
    threads: Option<NonZero<usize>>,
}

/// The machine's threads; asking the system costs more than a small picture.
static THREADS: LazyLock<usize> =
    LazyLock::new(|| thread::available_parallelism().map_or(1, NonZero::get));

/// Pixels of the lab's scene that are worth another thread, which costs about 0.1 ms to begin.
const PIXELS_PER_THREAD: usize = 1 << 18;

/// In how many parts a thread's share is taken: many, since rows differ in work, but no more, since
/// each part begins by placing its columns.
const PARTS_PER_THREAD: usize = 32;

/// Rows that a thread takes at least at a time.
const FEWEST_ROWS: usize = 8;

impl Default for Engine {
    /// The best level, and as many threads as the machine and the picture's size are worth.
    fn default() -> Self {
        Self {
            level: Level::best(),
            threads: None,
        }
    }
}

impl Engine {
    /// An engine of this level with this many threads; `None`: as many as the machine and the
    /// picture's size are worth.
    ///
    /// # Errors
    /// If the processor does not have the level.
    pub fn new(level: Level, threads: Option<NonZero<usize>>) -> Result<Self, NoSuchLevel> {
        if level.is_available() {
            Ok(Self { level, threads })
        } else {
            Err(NoSuchLevel(level.name().to_owned()))
        }
    }

    /// Its level.
    pub fn level(self) -> Level {
        self.level
    }

    /// How many threads it takes for a picture of this size.
    pub fn threads(self, size: Size) -> usize {
        let worth = || THREADS.min(size.pixels().div_ceil(PIXELS_PER_THREAD));
        self.threads.map_or_else(worth, NonZero::get)
    }

    /// Renders to bytes, like [`render`].
    pub fn render<S: Scalar>(self, chain: &impl Chain<S>, size: Size, film: Film) -> Picture {
        let mut picture = Picture::black(size);
        self.render_into(chain, film, &mut picture);
        picture
    }

    /// Renders over a picture, at its size: frame after frame in the same memory. New memory for a
    /// picture of 3840 x 2400 costs as much time as to compute it.
    pub fn render_into<S: Scalar>(self, chain: &impl Chain<S>, film: Film, picture: &mut Picture) {
        let size = picture.size();
        let frame = Frame::new(chain, size);
        let pixels = picture.pixels_mut();
        self.share(size, 0..size.height(), pixels, |rows, pixels| {
            S::draw(&frame, self.level, film, rows, pixels);
        });
    }

    /// Renders some rows of the picture that [`render`] renders, pixel by pixel.
    pub fn render_rows<S: Scalar>(
        self,
        chain: &impl Chain<S>,
        size: Size,
        film: Film,
        rows: Range<u32>,
    ) -> Vec<[u8; 3]> {
        let frame = Frame::new(chain, size);
        let mut pixels = vec![[0; 3]; rows.len() * size.width() as usize];
        self.share(size, rows, &mut pixels, |rows, pixels| {
            S::draw(&frame, self.level, film, rows, pixels);
        });
        pixels
    }

    /// Renders to linear radiance, like [`render_radiance`].
    pub fn render_radiance<S: Scalar>(self, chain: &impl Chain<S>, size: Size) -> Vec<S::Vector> {
        let frame = Frame::new(chain, size);
        let mut pixels = vec![S::Vector::constant((), [0.0; 3]); size.pixels()];
        self.share(size, 0..size.height(), &mut pixels, |rows, pixels| {
            S::expose(&frame, self.level, rows, pixels);
        });
        pixels
    }

    /// Draws rows of a picture, a part of them at a time on each thread: `draw(rows, pixels)` writes
    /// theirs.
    pub(crate) fn share<P: Send>(
        self,
        size: Size,
        rows: Range<u32>,
        pixels: &mut [P],
        draw: impl Fn(Range<u32>, &mut [P]) + Sync,
    ) {
        let width = size.width() as usize;
        let threads = self.threads(size);
        if threads == 1 {
            draw(rows, pixels);
            return;
        }
        let rows_at_a_time = rows_at_a_time(rows.len(), threads);
        let parts = pixels.chunks_mut(rows_at_a_time * width);
        let parts = Mutex::new(rows.step_by(rows_at_a_time).zip(parts));
        let next = || parts.lock().unwrap_or_else(PoisonError::into_inner).next();
        let work = || {
            while let Some((first, part)) = next() {
                draw(first..first + (part.len() / width) as u32, part);
            }
        };
        thread::scope(|scope| {
            for _ in 1..threads {
                // A thread that the system refuses leaves its share to the others.
                let _ = thread::Builder::new().spawn_scoped(scope, work);
            }
            work();
        });
    }
}

/// How many rows are a part.
fn rows_at_a_time(rows: usize, threads: usize) -> usize {
    (rows / (threads * PARTS_PER_THREAD)).max(FEWEST_ROWS)
}
