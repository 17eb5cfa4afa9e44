//! How numbers side by side go to memory and come from it.

use super::{Real, Scalar};

/// Numbers side by side that can be loaded from memory and stored there. A scalar is one lane.
pub trait Lanes: Real<Scalar: Scalar> {
    /// How many numbers there are.
    const LANES: usize;
    /// The most lanes any packet, or pair of packets, has.
    const MOST: usize = 32;
    /// How many pixels [`store_rgb`](Lanes::store_rgb) may write beyond its own.
    const SPILL: usize = 4;

    /// The first [`LANES`](Lanes::LANES) numbers of a slice that has as many, or more.
    fn load(token: Self::Token, lanes: &[Self::Scalar]) -> Self;
    /// Writes every lane to the start of a slice.
    fn store(self, lanes: &mut [Self::Scalar]);
    /// Writes three colours, whole numbers from 0 to 255, as bytes: three for each lane, and then
    /// bytes that mean nothing for up to [`SPILL`](Lanes::SPILL) pixels.
    fn store_rgb(rgb: [Self; 3], bytes: &mut [u8]);
}

/// Work that can be done in any number of lanes.
pub trait Job<S: Scalar> {
    /// Whether several lanes at a time are faster than one by one.
    fn gains_from_packets(&self) -> bool {
        true
    }

    /// Does it in lanes of type `R`. Must be `#[inline(always)]` down to the operations: only what
    /// is inlined into the dispatching function uses the instructions of its level.
    fn run<R: Lanes<Scalar = S>>(self, token: R::Token);
}

impl<S: Scalar> Lanes for S {
    const LANES: usize = 1;

    #[inline(always)]
    fn load((): (), lanes: &[S]) -> S {
        lanes[0]
    }

    #[inline(always)]
    fn store(self, lanes: &mut [S]) {
        lanes[0] = self;
    }

    #[inline(always)]
    fn store_rgb(rgb: [S; 3], bytes: &mut [u8]) {
        bytes[..3].copy_from_slice(&rgb.map(|x| x.to_f64() as u8));
    }
}
