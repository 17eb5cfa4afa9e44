//! Two of a kind, side by side: while one waits for a division, the other computes.

use super::{Lanes, Mask, Real};
use crate::vector::Triple;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Two numbers, or two masks, that go through a kernel together.
#[derive(Clone, Copy, Debug)]
pub struct Pair<T>(pub T, pub T);

macro_rules! operator {
    ($($trait:ident $method:ident($($other:ident)?)),*) => { $(
        impl<T: $trait<Output = T>> $trait for Pair<T> {
            type Output = Self;

            #[inline(always)]
            fn $method(self $(, $other: Self)?) -> Self {
                Pair(self.0.$method($($other.0)?), self.1.$method($($other.1)?))
            }
        }
    )* };
}

operator!(Add add(other), Sub sub(other), Mul mul(other), Div div(other), Neg neg());
operator!(BitAnd bitand(other), BitOr bitor(other), Not not());

impl<M: Mask> Mask for Pair<M> {
    #[inline(always)]
    fn any(self) -> bool {
        (self.0 | self.1).any()
    }
}

impl<R: Real> Real for Pair<R> {
    type Scalar = R::Scalar;
    type Mask = Pair<R::Mask>;
    type Vector = Triple<Self>;
    type Token = R::Token;

    #[inline(always)]
    fn token(self) -> R::Token {
        self.0.token()
    }

    #[inline(always)]
    fn splat(token: R::Token, value: R::Scalar) -> Self {
        Pair(R::splat(token, value), R::splat(token, value))
    }

    #[inline(always)]
    fn never(token: R::Token) -> Self::Mask {
        Pair(R::never(token), R::never(token))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Pair(self.0.sqrt(), self.1.sqrt())
    }

    #[inline(always)]
    fn trunc(self) -> Self {
        Pair(self.0.trunc(), self.1.trunc())
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Pair(self.0.abs(), self.1.abs())
    }

    #[inline(always)]
    fn step(self, count: Self) -> Self {
        Pair(self.0.step(count.0), self.1.step(count.1))
    }

    #[inline(always)]
    fn binade(self) -> Self {
        Pair(self.0.binade(), self.1.binade())
    }

    #[inline(always)]
    fn each<const N: usize>(inputs: [Self; N], f: impl Fn([R::Scalar; N]) -> R::Scalar) -> Self {
        Pair(
            R::each(inputs.map(|pair| pair.0), &f),
            R::each(inputs.map(|pair| pair.1), &f),
        )
    }

    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        Pair(self.0.lt(other.0), self.1.lt(other.1))
    }

    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        Pair(self.0.le(other.0), self.1.le(other.1))
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Pair(
            R::select(mask.0, yes.0, no.0),
            R::select(mask.1, yes.1, no.1),
        )
    }
}

impl<R: Lanes> Lanes for Pair<R> {
    const LANES: usize = 2 * R::LANES;

    #[inline(always)]
    fn load(token: R::Token, lanes: &[R::Scalar]) -> Self {
        Pair(R::load(token, lanes), R::load(token, &lanes[R::LANES..]))
    }

    #[inline(always)]
    fn store(self, lanes: &mut [R::Scalar]) {
        self.0.store(lanes);
        self.1.store(&mut lanes[R::LANES..]);
    }

    #[inline(always)]
    fn store_rgb([red, green, blue]: [Self; 3], bytes: &mut [u8]) {
        R::store_rgb([red.0, green.0, blue.0], bytes);
        R::store_rgb([red.1, green.1, blue.1], &mut bytes[3 * R::LANES..]);
    }
}
