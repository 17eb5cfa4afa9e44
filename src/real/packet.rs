//! SIMD lanes that speak the kernels' words: the native vector of a processor level.

use super::{Job, Lanes, Mask, Pair, Real};
use crate::float::Float;
use crate::level::Level;
use crate::vector::Triple;
use fearless_simd::{
    Bytes, ExtractToken, Select, Simd, SimdBase, SimdCvtTruncate, SimdFloat, SimdFloatElement,
    SimdMask, SimdNarrow, dispatch,
};
use std::fmt;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// `f32` or `f64`, seen as one lane of a SIMD vector.
pub trait Lane: Float + SimdFloatElement {
    /// The whole numbers of a vector, 0 to 2^24, as the first lanes of a vector of `u32`.
    fn to_u32s<L: Simd>(lanes: Self::Native<L>) -> L::u32s;
}

impl Lane for f32 {
    #[inline(always)]
    fn to_u32s<L: Simd>(lanes: L::f32s) -> L::u32s {
        L::i32s::truncate_from(lanes).bitcast()
    }
}

impl Lane for f64 {
    #[inline(always)]
    fn to_u32s<L: Simd>(lanes: L::f64s) -> L::u32s {
        f32::to_u32s::<L>(lanes.narrow(lanes))
    }
}

/// As many numbers side by side as a register of level `L` holds: 2 to 16.
///
/// Every lane has the bits that the scalar would have: the vocabulary is made of operations that
/// IEEE 754 defines exactly. No kernel asks for a NaN's sign or payload, which it leaves open.
#[derive(Clone, Copy, Debug)]
pub struct Packet<L: Simd, E: Lane>(E::Native<L>);

/// The answers of a comparison of two packets.
#[derive(Clone, Copy)]
pub struct PacketMask<L: Simd, E: Lane>(MaskOf<L, E>);

type MaskOf<L, E> = <<E as SimdFloatElement>::Native<L> as SimdBase<L>>::Mask;
type BitsOf<L, E> = <<E as SimdFloatElement>::Native<L> as SimdFloat<L>>::Bits;

macro_rules! operator {
    ($type:ident: $($trait:ident $method:ident($($other:ident)?)),*) => { $(
        impl<L: Simd, E: Lane> $trait for $type<L, E> {
            type Output = Self;

            #[inline(always)]
            fn $method(self $(, $other: Self)?) -> Self {
                $type(self.0.$method($($other.0)?))
            }
        }
    )* };
}

operator!(Packet: Add add(other), Sub sub(other), Mul mul(other), Div div(other), Neg neg());
operator!(PacketMask: BitAnd bitand(other), BitOr bitor(other), Not not());

impl<L: Simd, E: Lane> fmt::Debug for PacketMask<L, E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "PacketMask({:#b})", self.0.to_bitmask())
    }
}

impl<L: Simd, E: Lane> Mask for PacketMask<L, E> {
    #[inline(always)]
    fn any(self) -> bool {
        self.0.any_true()
    }
}

impl<L: Simd, E: Lane> Real for Packet<L, E> {
    type Scalar = E;
    type Mask = PacketMask<L, E>;
    type Vector = Triple<Self>;
    type Token = L;

    #[inline(always)]
    fn token(self) -> L {
        self.0.token()
    }

    #[inline(always)]
    fn splat(token: L, value: E) -> Self {
        Packet(SimdBase::splat(token, value))
    }

    #[inline(always)]
    fn never(token: L) -> Self::Mask {
        PacketMask(SimdMask::splat(token, false))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Packet(self.0.sqrt())
    }

    #[inline(always)]
    fn trunc(self) -> Self {
        Packet(self.0.trunc())
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Packet(self.0.abs())
    }

    /// Beside 1.5 * 2^(precision - 1) one place is 1, so a count added to that number is the
    /// difference of its bits, and no conversion to integers is needed.
    #[inline(always)]
    fn step(self, count: Self) -> Self {
        let zero = self.constant(0.0);
        let counts = count.abs().le(self.constant(0.5 / E::EPSILON));
        let places = Self::select(self.lt(zero), -count, count).trunc();
        let places = Self::select(counts, places, zero);
        let one_is_a_place = self.constant(1.5 / E::EPSILON);
        let bits = |x: Self| -> BitsOf<L, E> { x.0.bitcast() };
        let moved = bits(self) + (bits(places + one_is_a_place) - bits(one_is_a_place));
        Packet(moved.bitcast())
    }

    #[inline(always)]
    fn binade(self) -> Self {
        let exponent = self.constant(f64::INFINITY);
        let bits = |x: Self| -> BitsOf<L, E> { x.0.bitcast() };
        Packet((bits(self) & bits(exponent)).bitcast())
    }

    #[inline(always)]
    fn each<const N: usize>(inputs: [Self; N], f: impl Fn([E; N]) -> E) -> Self {
        let lane = |i: usize| f(inputs.map(|packet| packet.0.as_slice()[i]));
        Packet(SimdBase::from_fn(inputs[0].token(), lane))
    }

    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        PacketMask(self.0.simd_lt(other.0))
    }

    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        PacketMask(self.0.simd_le(other.0))
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Packet(mask.0.select(yes.0, no.0))
    }
}

impl<L: Simd, E: Lane> Lanes for Packet<L, E> {
    const LANES: usize = <E::Native<L> as SimdBase<L>>::LEN;

    #[inline(always)]
    fn load(token: L, lanes: &[E]) -> Self {
        Packet(SimdBase::from_slice(token, &lanes[..Self::LANES]))
    }

    #[inline(always)]
    fn store(self, lanes: &mut [E]) {
        self.0.store_slice(&mut lanes[..Self::LANES]);
    }

    /// Three bytes make a whole number below 2^24, exact in either format; a shuffle within each
    /// block of four pixels then drops its fourth byte.
    #[inline(always)]
    fn store_rgb([red, green, blue]: [Self; 3], bytes: &mut [u8]) {
        const DROP: [u8; 16] = [0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15];
        let rgb = red + green * red.constant(256.0) + blue * red.constant(65536.0);
        let drop = <L::u8s as SimdBase<L>>::Block::from_slice(red.token(), &DROP);
        let packed: L::u8s = E::to_u32s::<L>(rgb.0).bitcast();
        let packed = packed.swizzle_dyn_within_blocks(L::u8s::block_splat(drop));
        let blocks = packed.as_slice().chunks_exact(16);
        for (k, block) in blocks.take(Self::LANES.div_ceil(4)).enumerate() {
            bytes[12 * k..12 * k + 16].copy_from_slice(block);
        }
    }
}

/// Does a job with two packets in flight, at the level's width; one by one where it has none.
pub(crate) fn in_packets<E: Lane>(level: Level, job: impl Job<E>) {
    match level.simd().filter(|_| job.gains_from_packets()) {
        None => job.run::<E>(()),
        Some(level) => dispatch!(level, simd => in_pairs(simd, job)),
    }
}

#[inline(always)]
fn in_pairs<L: Simd, E: Lane>(simd: L, job: impl Job<E>) {
    job.run::<Pair<Packet<L, E>>>(simd);
}

/// Does a job with one packet at a time: for jobs that fill the registers with one.
pub(crate) fn in_single_packets<E: Lane>(level: Level, job: impl Job<E>) {
    match level.simd() {
        None => job.run::<E>(()),
        Some(level) => dispatch!(level, simd => in_single(simd, job)),
    }
}

#[inline(always)]
fn in_single<L: Simd, E: Lane>(simd: L, job: impl Job<E>) {
    job.run::<Packet<L, E>>(simd);
}
