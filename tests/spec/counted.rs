//! A number that counts the operations done with it: what "stops at the first hit" is checked by.

use ombrage::{Float, Real, Triple};
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    static OPERATIONS: Cell<u64> = const { Cell::new(0) };
}

/// How many operations `work` does with counted numbers.
pub fn operations<T>(work: impl FnOnce() -> T) -> u64 {
    let before = OPERATIONS.get();
    work();
    OPERATIONS.get() - before
}

/// A float whose arithmetic is counted.
#[derive(Clone, Copy, Debug)]
pub struct Counted<F>(pub F);

fn count<F>(value: F) -> Counted<F> {
    OPERATIONS.set(OPERATIONS.get() + 1);
    Counted(value)
}

macro_rules! counted {
    ($($trait:ident $method:ident)*) => {
        $(impl<F: Float> $trait for Counted<F> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                count(self.0.$method(other.0))
            }
        })*
    };
}

counted! { Add add Sub sub Mul mul Div div }

impl<F: Float> Neg for Counted<F> {
    type Output = Self;

    fn neg(self) -> Self {
        Counted(-self.0)
    }
}

impl<F: Float> Real for Counted<F> {
    type Scalar = F;
    type Mask = bool;
    type Vector = Triple<Self>;
    type Token = ();

    fn token(self) {}

    fn splat((): (), value: F) -> Self {
        Counted(value)
    }

    fn never((): ()) -> bool {
        false
    }

    fn sqrt(self) -> Self {
        count(self.0.sqrt())
    }

    fn trunc(self) -> Self {
        count(self.0.trunc())
    }

    fn step(self, places: Self) -> Self {
        count(self.0.step(places.0))
    }

    fn binade(self) -> Self {
        count(self.0.binade())
    }

    fn each<const N: usize>(inputs: [Self; N], f: impl Fn([F; N]) -> F) -> Self {
        count(f(inputs.map(|input| input.0)))
    }

    fn lt(self, other: Self) -> bool {
        self.0.lt(other.0)
    }

    fn le(self, other: Self) -> bool {
        self.0.le(other.0)
    }

    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}
