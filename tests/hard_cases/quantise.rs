//! The byte of every f32 there is, or of every 65,537th.

use ombrage::Film;
use ombrage_oracle::Format;
use ombrage_oracle::quantise::quantise;
use std::env;
use std::thread;

/// `floor(255 x)` of the exact product: in f64 it has 32 bits and is not rounded.
fn byte(x: f32) -> u8 {
    (255.0 * f64::from(x)) as u8
}

/// How many of these bit patterns give another byte than the exact product.
fn wrong(bits: impl Iterator<Item = u32>) -> (u64, Option<f32>) {
    bits.map(f32::from_bits)
        .fold((0, None), |(wrong, first), x| {
            let right = Film::Clamp.byte(x) as u8 == byte(x);
            (wrong + u64::from(!right), first.or((!right).then_some(x)))
        })
}

/// All 2^32 with `OMBRAGE_EXHAUSTIVE=1`.
#[test]
fn every_f32() {
    let exhaustive = env::var_os("OMBRAGE_EXHAUSTIVE").is_some_and(|value| value == "1");
    let step = if exhaustive { 1 } else { 65_537 };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let found: Vec<_> = thread::scope(|scope| {
        let part = |start: usize| {
            move || {
                let bits = (start..1 << 32).step_by(step * threads);
                wrong(bits.map(|bits| bits as u32))
            }
        };
        let running: Vec<_> = (0..threads).map(|n| scope.spawn(part(n * step))).collect();
        running
            .into_iter()
            .map(thread::ScopedJoinHandle::join)
            .collect()
    });
    for part in found {
        let (wrong, first) = part.expect("a thread that counts does not panic");
        assert_eq!(wrong, 0, "the first: {first:?}");
    }
}

/// What the test above compares with is the oracle's answer.
#[test]
fn the_short_truth_is_the_oracles() {
    for bits in (0..=u32::MAX).step_by(655_357) {
        let x = f32::from_bits(bits);
        let truth = quantise(f64::from(x), Format::F32).floor;
        assert_eq!(byte(x), truth, "{x:e} {bits:08x}");
    }
}
