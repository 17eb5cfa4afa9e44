//! The exact numbers that occur in answers, and Ziv's strategy to round them.
//!
//! A number that is not rational is enclosed between rationals, closer and closer, until the rounding of both ends is the
//! same. Rounding breaks only at rationals, so the loop ends; rational numbers never enter it.

use crate::decimal::decimal;
use crate::exact::{Rational, magnitude, sign};
use crate::format::Format;
use crate::surd::{Surd, exact_root};
use dashu_int::ops::{BitTest, SquareRootRem};
use dashu_int::{IBig, UBig};

/// An exact real number.
#[derive(Clone, Debug, PartialEq)]
pub enum Real {
    /// A rational.
    Rational(Rational),
    /// An irrational `a + b√D`.
    Surd(Surd),
    /// An irrational `±√(a + b√D)`.
    Root {
        /// Whether it is the negative root.
        negative: bool,
        /// The number under the root.
        square: Surd,
    },
}

impl Real {
    /// `sign · √square`, for `square ≥ 0`; 0 if `sign` is 0.
    pub fn root(sign: i8, square: Surd) -> Real {
        let negative = sign < 0;
        match square.as_rational() {
            _ if sign == 0 => Real::Rational(Rational::ZERO),
            Some(rational) => match exact_root(rational) {
                Some(root) => Real::Rational(if negative { -root } else { root }),
                None => Real::Root { negative, square },
            },
            None => Real::Root { negative, square },
        }
    }

    /// -1, 0 or 1.
    pub fn sign(&self) -> i8 {
        match self {
            Real::Rational(x) => sign(x),
            Real::Surd(x) => x.sign(),
            Real::Root { negative: true, .. } => -1,
            Real::Root {
                negative: false, ..
            } => 1,
        }
    }

    /// The value of `format` nearest to the number; see [`Format::round`].
    pub fn round(&self, format: Format) -> f64 {
        self.decide(|x| format.round(x))
    }

    /// The number in decimal; see [`decimal`].
    pub fn decimal(&self) -> String {
        self.decide(decimal)
    }

    /// `step` of the number, for a function that is constant between rational breaking points: roundings, floors, signs.
    /// It must not take the same value on both sides of an interval where it takes another (piecewise monotone
    /// functions do not, if they also return the piece).
    pub fn decide<T: PartialEq>(&self, step: impl Fn(&Rational) -> T) -> T {
        if let Real::Rational(x) = self {
            return step(x);
        }
        let mut bits = 192;
        loop {
            let (low, high) = self.enclose(bits);
            let answer = step(&low);
            if answer == step(&high) {
                return answer;
            }
            bits *= 2;
        }
    }

    /// Rationals on both sides of the number, close to `2^-bits` of its largest term apart.
    fn enclose(&self, bits: usize) -> (Rational, Rational) {
        match self {
            Real::Rational(x) => (x.clone(), x.clone()),
            Real::Surd(x) => enclose_surd(x, bits),
            Real::Root { negative, square } => {
                let (low, high) = enclose_surd(square, bits);
                let low = root_between(&low.max(Rational::ZERO), bits).0;
                let high = root_between(&high, bits).1;
                if *negative {
                    (-high, -low)
                } else {
                    (low, high)
                }
            }
        }
    }
}

impl From<Rational> for Real {
    fn from(x: Rational) -> Real {
        Real::Rational(x)
    }
}

impl From<Surd> for Real {
    fn from(x: Surd) -> Real {
        match x.as_rational() {
            Some(rational) => Real::Rational(rational.clone()),
            None => Real::Surd(x),
        }
    }
}

fn enclose_surd(x: &Surd, bits: usize) -> (Rational, Rational) {
    let (low, high) = root_between(x.radicand(), bits);
    let (low, high) = (x.a() + x.b() * low, x.a() + x.b() * high);
    if low < high { (low, high) } else { (high, low) }
}

/// Rationals on both sides of `√x`, for `x ≥ 0`, within `2^(1-bits) √x` of each other.
pub(crate) fn root_between(x: &Rational, bits: usize) -> (Rational, Rational) {
    let product = magnitude(x) * x.denominator();
    let shift = (bits + 1).saturating_sub(product.bit_len() / 2);
    let (root, rest) = (product << (2 * shift)).sqrt_rem();
    let over = |n: UBig| Rational::from_parts(IBig::from(n), x.denominator() << shift);
    if rest.is_zero() {
        let exact = over(root);
        return (exact.clone(), exact);
    }
    (over(root.clone()), over(root + UBig::ONE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::power_of_two;

    #[test]
    fn square_root_of_two() {
        let root = Real::from(Surd::root(2.into()));
        assert_eq!(root.round(Format::F64), std::f64::consts::SQRT_2);
        assert_eq!(root.round(Format::F32), f64::from(std::f32::consts::SQRT_2));
        assert_eq!(
            root.decimal(),
            "1.4142135623730950488016887242096980785697e+00"
        );
    }

    #[test]
    fn nested_roots() {
        // √(3 + 2√2) = 1 + √2, and √(3 - 2√2) = √2 - 1.
        let nested = |b: i32| Real::root(-1, Surd::new(3.into(), b.into(), 2.into()));
        assert_eq!(
            nested(2).decimal(),
            "-2.4142135623730950488016887242096980785697e+00"
        );
        assert_eq!(
            nested(-2).decimal(),
            "-4.1421356237309504880168872420969807856967e-01"
        );
        assert_eq!(
            Real::root(-1, Surd::from(Rational::from(9))),
            Real::Rational(Rational::from(-3))
        );
    }

    #[test]
    fn a_rounding_that_needs_many_digits() {
        // Just above the tie 1 + 2^-24: √((1 + 2^-24)² + 2^-900).
        let tie = Rational::ONE + power_of_two(-24);
        let above = Real::from(Surd::root(&tie * &tie + power_of_two(-900)));
        assert_eq!(Format::F32.hex(above.round(Format::F32)), "3f800001");
        let below = Real::from(Surd::root(&tie * &tie - power_of_two(-900)));
        assert_eq!(Format::F32.hex(below.round(Format::F32)), "3f800000");
    }

    #[test]
    fn cancellation_does_not_hurt() {
        let tiny = Real::from(Surd::new(
            Rational::from(-1),
            Rational::ONE,
            Rational::ONE + power_of_two(-2000),
        ));
        assert_eq!(tiny.sign(), 1);
        assert!(tiny.decimal().ends_with("e-603"));
    }
}
