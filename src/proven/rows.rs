//! The first rung: as many pixels at a time as there are lanes.

use super::prover::{Prover, develop};
use crate::picture::Size;
use crate::real::{Bounded, Job, Lanes, Mask, Real, Rigorous};
use crate::relative::coordinate;
use crate::vector::Triple;
use std::ops::Range;

/// Rows of a picture to prove.
pub(super) struct Rows<'a> {
    pub prover: &'a Prover<f32>,
    pub size: Size,
    pub rows: Range<u32>,
    /// Gets the rows' pixels.
    pub pixels: &'a mut [[u8; 3]],
    /// Gets the indices of the pixels that are not proven, in the order of `pixels`.
    pub open: &'a mut Vec<usize>,
}

type Number<R> = Bounded<R, Rigorous>;

impl Job<f32> for Rows<'_> {
    /// Each row is computed in a buffer of its own, as [`Frame`](crate::Frame) does.
    #[inline(always)]
    fn run<R: Lanes<Scalar = f32>>(self, token: R::Token) {
        let (width, chain) = (self.size.width() as usize, &self.prover.chain);
        let packets = width.div_ceil(R::LANES);
        let mut columns: Vec<Triple<Number<R>>> = Vec::with_capacity(packets);
        for start in (0..width).step_by(R::LANES) {
            let (mut values, mut errors) = ([0.0; 32], [0.0; 32]);
            for lane in 0..R::LANES {
                let place = coordinate::<Number<f32>>((start + lane) as u32, self.size.width());
                (values[lane], errors[lane]) = (place.value, place.error);
            }
            let place = Bounded::new(R::load(token, &values), R::load(token, &errors));
            columns.push(chain.across::<Number<R>>(place));
        }
        let blank = self.prover.background;
        let blank = blank.map(|level| R::splat(token, f32::from(level)));
        let [proven, open] = [0.0, 1.0].map(|flag| R::splat(token, flag));
        let mut buffer = vec![[0; 3]; packets * R::LANES + R::SPILL];
        let targets = self.pixels.chunks_exact_mut(width);
        for ((row, target), start_of_row) in self.rows.zip(targets).zip((0..).step_by(width)) {
            let down = coordinate::<Number<f32>>(row, self.size.height());
            let down = chain.down(Number::<R>::splat(token, down));
            for (&across, start) in columns.iter().zip((0..).step_by(R::LANES)) {
                let mut levels = blank;
                if let Some((hit, reflected)) = chain.reflected::<Number<R>>(across + down) {
                    let (bytes, certain) = develop(self.prover.film, hit.certain, reflected);
                    levels = select(hit.possible, bytes, blank);
                    let doubt = hit.possible & !certain;
                    if doubt.any() {
                        let mut flags = [0.0; 32];
                        R::select(doubt, open, proven).store(&mut flags);
                        let lanes = (start..width).zip(&flags[..R::LANES]);
                        let lanes = lanes.filter(|&(_, &flag)| flag > 0.0);
                        self.open
                            .extend(lanes.map(|(column, _)| start_of_row + column));
                    }
                }
                R::store_rgb(levels, buffer[start..].as_flattened_mut());
            }
            target.copy_from_slice(&buffer[..width]);
        }
    }
}

#[inline(always)]
fn select<R: Real>(mask: R::Mask, [a, b, c]: [R; 3], [x, y, z]: [R; 3]) -> [R; 3] {
    [
        R::select(mask, a, x),
        R::select(mask, b, y),
        R::select(mask, c, z),
    ]
}
