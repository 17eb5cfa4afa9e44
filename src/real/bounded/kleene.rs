//! Three-valued answers: certainly true, certainly false, or either.

use crate::real::Mask;
use std::ops::{BitAnd, BitOr, Not};

/// An answer in Kleene's strong logic (Introduction to Metamathematics, section 64): a combination
/// of answers is certain where it is the same whatever the open ones turn out to be.
#[derive(Clone, Copy, Debug)]
pub struct Kleene<M> {
    /// Where it is certainly true.
    pub certain: M,
    /// Where it is not certainly false.
    pub possible: M,
}

impl<M: Mask> Kleene<M> {
    /// Where it is certainly true or certainly false.
    #[inline(always)]
    pub fn decided(self) -> M {
        self.certain | !self.possible
    }
}

impl<M: BitAnd<Output = M>> BitAnd for Kleene<M> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self {
            certain: self.certain & other.certain,
            possible: self.possible & other.possible,
        }
    }
}

impl<M: BitOr<Output = M>> BitOr for Kleene<M> {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self {
            certain: self.certain | other.certain,
            possible: self.possible | other.possible,
        }
    }
}

impl<M: Not<Output = M>> Not for Kleene<M> {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        Self {
            certain: !self.possible,
            possible: !self.certain,
        }
    }
}

impl<M: Mask> Mask for Kleene<M> {
    /// Whether it may be true in any lane: nothing is left out that may count.
    #[inline(always)]
    fn any(self) -> bool {
        self.possible.any()
    }
}
