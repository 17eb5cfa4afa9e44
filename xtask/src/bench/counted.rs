//! Numbers that count what is done to them.

use ombrage::{Mask, Real, Scalar, Triple};
use std::array;
use std::cell::Cell;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// How often each operation was done, for all lanes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Additions, subtractions and multiplications.
    pub add_mul: u64,
    /// Comparisons and selections.
    pub compare_select: u64,
    /// Divisions.
    pub divide: u64,
    /// Square roots.
    pub sqrt: u64,
}

thread_local! {
    static COUNTS: Cell<Counts> = const {
        Cell::new(Counts { add_mul: 0, compare_select: 0, divide: 0, sqrt: 0 })
    };
}

/// What this thread has counted since it last asked.
pub fn take() -> Counts {
    COUNTS.take()
}

fn note(count: impl FnOnce(&mut Counts)) {
    let mut counts = COUNTS.get();
    count(&mut counts);
    COUNTS.set(counts);
}

/// `N` numbers side by side, as a packet has them. Negations, roundings to whole numbers and moves
/// by units in the last place are not counted: they are no arithmetic.
#[derive(Clone, Copy, Debug)]
pub struct Counted<S, const N: usize>(pub [S; N]);

/// The answers of a comparison.
#[derive(Clone, Copy, Debug)]
pub struct CountedMask<const N: usize>([bool; N]);

impl<S: Scalar, const N: usize> Counted<S, N> {
    fn map(self, f: impl Fn(S) -> S) -> Self {
        Self(self.0.map(f))
    }

    fn zip<A>(self, other: Self, f: impl Fn(S, S) -> A) -> [A; N] {
        array::from_fn(|i| f(self.0[i], other.0[i]))
    }
}

macro_rules! counted {
    ($($trait:ident $method:ident $count:ident),*) => { $(
        impl<S: Scalar, const N: usize> $trait for Counted<S, N> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                note(|counts| counts.$count += N as u64);
                Self(self.zip(other, S::$method))
            }
        }
    )* };
}

counted!(Add add add_mul, Sub sub add_mul, Mul mul add_mul, Div div divide);

impl<S: Scalar, const N: usize> Neg for Counted<S, N> {
    type Output = Self;

    fn neg(self) -> Self {
        self.map(S::neg)
    }
}

macro_rules! logic {
    ($($trait:ident $method:ident),*) => { $(
        impl<const N: usize> $trait for CountedMask<N> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self(array::from_fn(|i| self.0[i].$method(other.0[i])))
            }
        }
    )* };
}

logic!(BitAnd bitand, BitOr bitor);

impl<const N: usize> Not for CountedMask<N> {
    type Output = Self;

    fn not(self) -> Self {
        Self(self.0.map(bool::not))
    }
}

impl<const N: usize> Mask for CountedMask<N> {
    fn any(self) -> bool {
        self.0.contains(&true)
    }
}

impl<S: Scalar, const N: usize> Real for Counted<S, N> {
    type Scalar = S;
    type Mask = CountedMask<N>;
    type Vector = Triple<Self>;
    type Token = ();

    fn token(self) {}

    fn splat((): (), value: S) -> Self {
        Self([value; N])
    }

    fn never((): ()) -> CountedMask<N> {
        CountedMask([false; N])
    }

    fn sqrt(self) -> Self {
        note(|counts| counts.sqrt += N as u64);
        self.map(S::sqrt)
    }

    fn trunc(self) -> Self {
        self.map(S::trunc)
    }

    fn step(self, count: Self) -> Self {
        Self(self.zip(count, S::step))
    }

    fn binade(self) -> Self {
        self.map(S::binade)
    }

    fn lt(self, other: Self) -> CountedMask<N> {
        note(|counts| counts.compare_select += N as u64);
        CountedMask(self.zip(other, Real::lt))
    }

    fn le(self, other: Self) -> CountedMask<N> {
        note(|counts| counts.compare_select += N as u64);
        CountedMask(self.zip(other, Real::le))
    }

    fn select(mask: CountedMask<N>, yes: Self, no: Self) -> Self {
        note(|counts| counts.compare_select += N as u64);
        Self(array::from_fn(|i| S::select(mask.0[i], yes.0[i], no.0[i])))
    }

    fn each<const M: usize>(inputs: [Self; M], f: impl Fn([S; M]) -> S) -> Self {
        Self(array::from_fn(|i| f(inputs.map(|packet| packet.0[i]))))
    }

    fn abs(self) -> Self {
        self.map(S::abs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombrage::Vector;

    type Four = Counted<f64, 4>;

    #[test]
    fn counts_every_operation_once_a_lane() {
        take();
        let vector = Triple::<Four>::constant((), [3.0, 4.0, 12.0]);
        let length = vector.dot(vector).sqrt();
        assert_eq!(length.0, [13.0; 4]);
        let half = length / length.constant(2.0);
        let smaller = Four::select(half.lt(length), half, length);
        assert_eq!(smaller.0, [6.5; 4]);
        let expected = Counts {
            add_mul: 4 * 5,
            compare_select: 4 * 2,
            divide: 4,
            sqrt: 4,
        };
        assert_eq!(take(), expected);
        assert_eq!(take(), Counts::default());
    }
}
