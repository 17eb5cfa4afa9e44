//! Rows of a picture, as many pixels at a time as there are lanes.

use crate::chain::{Chain, ChainKind};
use crate::film::Film;
use crate::level::Level;
use crate::picture::Size;
use crate::real::{DoubleDouble, Job, Lanes, Real, Scalar, in_packets};
use crate::vector::Vector;
use std::ops::Range;

/// A picture to be: everything its rows have in common.
#[derive(Clone, Debug)]
pub struct Frame<'a, S: Scalar> {
    chain: ChainKind<'a, S>,
    gains_from_packets: bool,
    size: Size,
    /// Where each column is; the last is repeated to fill the widest packet.
    columns: Vec<S>,
}

/// What radiance becomes before it is stored.
pub trait Develop<S: Scalar> {
    /// What is stored for a pixel.
    type Pixel: Copy;
    /// How many pixels [`store`](Develop::store) may write beyond its own.
    const SPILL: usize;

    /// A pixel to be overwritten.
    fn blank() -> Self::Pixel;
    /// The components to be stored.
    fn develop<R: Lanes<Scalar = S>>(&self, radiance: R::Vector) -> [R; 3];
    /// Writes the lanes' pixels to the start of a slice that has room for them and the spill.
    fn store<R: Lanes<Scalar = S>>(components: [R; 3], pixels: &mut [Self::Pixel]);
}

impl<S: Scalar> Develop<S> for Film {
    type Pixel = [u8; 3];
    const SPILL: usize = 4;

    fn blank() -> [u8; 3] {
        [0; 3]
    }

    #[inline(always)]
    fn develop<R: Lanes<Scalar = S>>(&self, radiance: R::Vector) -> [R; 3] {
        let [red, green, blue] = radiance.to_array();
        [self.byte(red), self.byte(green), self.byte(blue)]
    }

    #[inline(always)]
    fn store<R: Lanes<Scalar = S>>(rgb: [R; 3], pixels: &mut [[u8; 3]]) {
        R::store_rgb(rgb, pixels.as_flattened_mut());
    }
}

/// Radiance as it is.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

impl<S: Scalar> Develop<S> for Linear {
    type Pixel = S::Vector;
    const SPILL: usize = 0;

    fn blank() -> S::Vector {
        S::Vector::constant((), [0.0; 3])
    }

    #[inline(always)]
    fn develop<R: Lanes<Scalar = S>>(&self, radiance: R::Vector) -> [R; 3] {
        radiance.to_array()
    }

    #[inline(always)]
    fn store<R: Lanes<Scalar = S>>(components: [R; 3], pixels: &mut [S::Vector]) {
        let mut lanes = [[S::default(); 32]; 3];
        for (lanes, component) in lanes.iter_mut().zip(components) {
            component.store(lanes);
        }
        for (i, pixel) in pixels[..R::LANES].iter_mut().enumerate() {
            *pixel = S::Vector::new(lanes[0][i], lanes[1][i], lanes[2][i]);
        }
    }
}

impl<'a, S: Scalar> Frame<'a, S> {
    /// The picture of a chain.
    pub fn new<C: Chain<S>>(chain: &'a C, size: Size) -> Self {
        let width = size.width();
        let columns =
            (0..width.next_multiple_of(32)).map(|i| C::coordinate(i.min(width - 1), width));
        Self {
            chain: chain.kind(),
            gains_from_packets: chain.gains_from_packets(),
            size,
            columns: columns.collect(),
        }
    }

    /// Computes rows, `R::LANES` pixels at a time, and writes them to `pixels`, row-major,
    /// of which there must be as many.
    #[inline(always)]
    pub fn rows<R: Lanes<Scalar = S>, D: Develop<S>>(
        &self,
        token: R::Token,
        develop: &D,
        rows: Range<u32>,
        pixels: &mut [D::Pixel],
    ) {
        match self.chain {
            ChainKind::Lab(chain) => {
                self.rows_of::<R, _, D>(chain, token, develop, rows, pixels);
            }
            ChainKind::Relative(chain) => {
                self.rows_of::<R, _, D>(chain, token, develop, rows, pixels);
            }
        }
    }

    /// The rows of one of the two chains.
    ///
    /// Each row is computed in a buffer of its own, where the last packet and a film's spill may
    /// write beyond its end. That also tells the compiler that no pixel is part of the scene.
    #[inline(always)]
    fn rows_of<R: Lanes<Scalar = S>, C: Chain<S>, D: Develop<S>>(
        &self,
        chain: &C,
        token: R::Token,
        develop: &D,
        rows: Range<u32>,
        pixels: &mut [D::Pixel],
    ) {
        let width = self.size.width() as usize;
        let mut buffer = vec![D::blank(); width.next_multiple_of(R::LANES) + D::SPILL];
        let packets = width.div_ceil(R::LANES);
        let mut columns = Vec::with_capacity(packets);
        for lanes in self.columns.chunks_exact(R::LANES).take(packets) {
            columns.push(chain.across::<R>(R::load(token, lanes)));
        }
        let background = R::Vector::splat(token, &chain.background());
        let blank = develop.develop::<R>(background);
        for (row, target) in rows.zip(pixels.chunks_exact_mut(width)) {
            let down = chain.down(R::splat(token, C::coordinate(row, self.size.height())));
            for (&across, start) in columns.iter().zip((0..).step_by(R::LANES)) {
                let packet = &mut buffer[start..][..R::LANES + D::SPILL];
                let components = match chain.reflected::<R>(across + down) {
                    None => blank,
                    Some((mask, reflected)) => {
                        develop.develop::<R>(R::Vector::select(mask, reflected, background))
                    }
                };
                D::store::<R>(components, packet);
            }
            target.copy_from_slice(&buffer[..width]);
        }
    }
}

/// Numbers that pictures can be drawn in. Not generic over chain and film, so that the loops over
/// packets are compiled here, once, and not in every crate that draws.
pub trait Draw: Sized {
    /// Computes rows to bytes, and writes them to `pixels`, row-major, of which there must be as many.
    fn draw(
        frame: &Frame<'_, Self>,
        level: Level,
        film: Film,
        rows: Range<u32>,
        pixels: &mut [[u8; 3]],
    ) where
        Self: Scalar;

    /// The same to linear radiance.
    fn expose(frame: &Frame<'_, Self>, level: Level, rows: Range<u32>, pixels: &mut [Self::Vector])
    where
        Self: Scalar;
}

macro_rules! draw {
    ($scalar:ty: $in_lanes:expr) => {
        impl Draw for $scalar {
            fn draw(
                frame: &Frame<'_, Self>,
                level: Level,
                film: Film,
                rows: Range<u32>,
                pixels: &mut [[u8; 3]],
            ) {
                $in_lanes(
                    level,
                    Rows {
                        frame,
                        develop: &film,
                        rows,
                        pixels,
                    },
                );
            }

            fn expose(
                frame: &Frame<'_, Self>,
                level: Level,
                rows: Range<u32>,
                pixels: &mut [<Self as Real>::Vector],
            ) {
                $in_lanes(
                    level,
                    Rows {
                        frame,
                        develop: &Linear,
                        rows,
                        pixels,
                    },
                );
            }
        }
    };
}

draw!(f32: in_packets);
draw!(f64: in_packets);
draw!(DoubleDouble: one_by_one);

/// Does a job without packets.
fn one_by_one<S: Scalar>(_: Level, job: impl Job<S>) {
    job.run::<S>(());
}

/// Rows of a picture to compute, in lanes yet to be chosen.
struct Rows<'a, S: Scalar, D: Develop<S>> {
    frame: &'a Frame<'a, S>,
    develop: &'a D,
    rows: Range<u32>,
    pixels: &'a mut [D::Pixel],
}

impl<S: Scalar, D: Develop<S>> Job<S> for Rows<'_, S, D> {
    fn gains_from_packets(&self) -> bool {
        self.frame.gains_from_packets
    }

    #[inline(always)]
    fn run<R: Lanes<Scalar = S>>(self, token: R::Token) {
        self.frame
            .rows::<R, D>(token, self.develop, self.rows, self.pixels);
    }
}
