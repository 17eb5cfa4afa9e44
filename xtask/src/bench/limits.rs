//! How fast this machine computes and writes at best.

use super::result::{Limit, Store};
use fearless_simd::{Simd, dispatch};
use ombrage::{Lane, Lanes, Level, Packet, Real, Size};
use std::hint::black_box;
use std::time::Instant;

/// Numbers that depend on nothing but themselves, so that no operation waits for another: enough
/// to fill the arithmetic units, and not too many for the registers.
const CHAINS: usize = 12;

/// How often each is computed anew in a measurement.
const TURNS: usize = 8192;

/// Measurements; the fastest counts, since what disturbs only slows.
const REPEATS: usize = 15;

/// What is measured: the next number of a chain.
trait Step {
    /// How many operations it takes.
    const OPERATIONS: usize;
    fn step<R: Real>(x: R, a: R, b: R) -> R;
}

struct AddMul;
struct CompareSelect;
struct Divide;
struct Sqrt;

impl Step for AddMul {
    const OPERATIONS: usize = 2;

    #[inline(always)]
    fn step<R: Real>(x: R, a: R, b: R) -> R {
        x * a + b
    }
}

impl Step for CompareSelect {
    const OPERATIONS: usize = 2;

    #[inline(always)]
    fn step<R: Real>(x: R, a: R, b: R) -> R {
        R::select(x.lt(a), b, x)
    }
}

impl Step for Divide {
    const OPERATIONS: usize = 1;

    #[inline(always)]
    fn step<R: Real>(x: R, a: R, _: R) -> R {
        a / x
    }
}

impl Step for Sqrt {
    const OPERATIONS: usize = 1;

    /// The addition keeps the number from becoming 1; it waits for nothing but the root.
    #[inline(always)]
    fn step<R: Real>(x: R, a: R, _: R) -> R {
        (x + a).sqrt()
    }
}

/// The limits at every level that has packets, in a format.
pub fn measure<E: Lane>() -> Vec<Limit> {
    let levels = Level::available();
    let limit = |level: Level| {
        let simd = level.simd()?;
        Some(dispatch!(simd, token => at::<_, E>(level, token)))
    };
    levels.filter_map(limit).collect()
}

#[inline(always)]
fn at<L: Simd, E: Lane>(level: Level, token: L) -> Limit {
    Limit {
        float: E::NAME.into(),
        level: level.name().into(),
        lanes: Packet::<L, E>::LANES,
        add_mul_ns: time::<Packet<L, E>, AddMul>(token),
        compare_select_ns: time::<Packet<L, E>, CompareSelect>(token),
        divide_ns: time::<Packet<L, E>, Divide>(token),
        sqrt_ns: time::<Packet<L, E>, Sqrt>(token),
    }
}

/// Nanoseconds an operation.
#[inline(always)]
fn time<R: Lanes, O: Step>(token: R::Token) -> f64 {
    let number = |value: f64| R::splat(token, ombrage::Constant::from_f64(black_box(value)));
    let (a, b) = (number(0.75), number(0.625));
    let mut fastest = f64::INFINITY;
    for _ in 0..REPEATS {
        let mut chains = [a; CHAINS];
        let mut start = 1.25;
        for chain in &mut chains {
            *chain = number(start);
            start += 0.0625;
        }
        let clock = Instant::now();
        for _ in 0..TURNS {
            for chain in &mut chains {
                *chain = O::step(*chain, a, b);
            }
        }
        for chain in chains {
            black_box(chain);
        }
        fastest = fastest.min(clock.elapsed().as_secs_f64());
    }
    fastest * 1e9 / (TURNS * CHAINS * O::OPERATIONS) as f64
}

/// The time to fill a new picture.
pub fn store(size: Size) -> Store {
    let mut fastest = f64::INFINITY;
    for _ in 0..REPEATS {
        let clock = Instant::now();
        black_box(vec![black_box(127u8); 3 * size.pixels()]);
        fastest = fastest.min(clock.elapsed().as_secs_f64());
    }
    Store {
        width: size.width(),
        height: size.height(),
        ns_per_pixel: fastest * 1e9 / size.pixels() as f64,
    }
}
