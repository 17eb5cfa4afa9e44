//! Numbers `a + b√D` with exact signs: the field in which a ray meets a sphere.

use crate::exact::{Rational, magnitude, sign};
use dashu_int::UBig;
use dashu_int::ops::SquareRootRem;
use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

/// `a + b√D` for rational `a`, `b` and `D ≥ 0`. If `√D` is rational or `b` is 0, the number is kept as a rational
/// (`b = D = 0`), so that two equal numbers over one `D` have equal parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Surd {
    a: Rational,
    b: Rational,
    radicand: Rational,
}

impl Surd {
    /// `a + b√radicand`, for `radicand ≥ 0`.
    pub fn new(a: Rational, b: Rational, radicand: Rational) -> Surd {
        if sign(&b) == 0 {
            return Surd::from(a);
        }
        match exact_root(&radicand) {
            Some(root) => Surd::from(a + b * root),
            None => Surd { a, b, radicand },
        }
    }

    /// `√radicand`, for `radicand ≥ 0`.
    pub fn root(radicand: Rational) -> Surd {
        Surd::new(Rational::ZERO, Rational::ONE, radicand)
    }

    /// The rational part.
    pub fn a(&self) -> &Rational {
        &self.a
    }

    /// The factor of the radical; 0 exactly if the number is rational.
    pub fn b(&self) -> &Rational {
        &self.b
    }

    /// What stands under the radical: 0, or no square of a rational.
    pub fn radicand(&self) -> &Rational {
        &self.radicand
    }

    /// The number itself, if it is rational.
    pub fn as_rational(&self) -> Option<&Rational> {
        (sign(&self.b) == 0).then_some(&self.a)
    }

    /// -1, 0 or 1, decided by squaring.
    pub fn sign(&self) -> i8 {
        let (a, b) = (sign(&self.a), sign(&self.b));
        if a == b || b == 0 {
            return a;
        }
        if a == 0 {
            return b;
        }
        match (&self.a * &self.a).cmp(&(&self.b * &self.b * &self.radicand)) {
            Ordering::Greater => a,
            Ordering::Less => b,
            Ordering::Equal => 0,
        }
    }

    /// The sum of squares of three numbers over one radicand.
    pub fn norm(v: &[Surd; 3]) -> Surd {
        &(&(&v[0] * &v[0]) + &(&v[1] * &v[1])) + &(&v[2] * &v[2])
    }

    /// The inner product of two vectors over one radicand.
    pub fn dot(v: &[Surd; 3], w: &[Surd; 3]) -> Surd {
        &(&(&v[0] * &w[0]) + &(&v[1] * &w[1])) + &(&v[2] * &w[2])
    }

    /// The inner product with a rational vector.
    pub fn dot_rational(v: &[Surd; 3], w: &[Rational; 3]) -> Surd {
        &(&v[0].scale(&w[0]) + &v[1].scale(&w[1])) + &v[2].scale(&w[2])
    }

    /// `factor` times the number.
    pub fn scale(&self, factor: &Rational) -> Surd {
        self.same_field(&self.a * factor, &self.b * factor, self)
    }

    /// `1 / self`, for a number other than 0.
    pub fn recip(&self) -> Surd {
        let norm = &self.a * &self.a - &self.b * &self.b * &self.radicand;
        self.same_field(&self.a / &norm, -(&self.b / &norm), self)
    }

    /// Compares numbers whose radicands may differ.
    pub fn compare(&self, other: &Surd) -> Ordering {
        // The sign of (a - a' + b√D) - b'√D'.
        let left = Surd::new(&self.a - &other.a, self.b.clone(), self.radicand.clone());
        let right = sign(&other.b);
        if left.sign() != right {
            return left.sign().cmp(&right);
        }
        let squares = &(&left * &left) - &Surd::from(&other.b * &other.b * &other.radicand);
        (squares.sign() * right).cmp(&0)
    }

    /// `a + b√D` with the radicand of `self` or, if that is rational, of `other`.
    fn same_field(&self, a: Rational, b: Rational, other: &Surd) -> Surd {
        if sign(&b) == 0 {
            return Surd::from(a);
        }
        debug_assert!(
            sign(&self.b) == 0 || sign(&other.b) == 0 || self.radicand == other.radicand,
            "numbers of two fields"
        );
        let radicand = if sign(&self.b) == 0 {
            &other.radicand
        } else {
            &self.radicand
        };
        Surd {
            a,
            b,
            radicand: radicand.clone(),
        }
    }
}

impl From<Rational> for Surd {
    fn from(a: Rational) -> Surd {
        Surd {
            a,
            b: Rational::ZERO,
            radicand: Rational::ZERO,
        }
    }
}

/// Both operands must share their radicand, or one of them be rational; so too for the other operators.
impl Add for &Surd {
    type Output = Surd;
    fn add(self, other: &Surd) -> Surd {
        self.same_field(&self.a + &other.a, &self.b + &other.b, other)
    }
}

impl Sub for &Surd {
    type Output = Surd;
    fn sub(self, other: &Surd) -> Surd {
        self.same_field(&self.a - &other.a, &self.b - &other.b, other)
    }
}

impl Mul for &Surd {
    type Output = Surd;
    fn mul(self, other: &Surd) -> Surd {
        let a = &self.a * &other.a + &self.b * &other.b * &self.radicand;
        self.same_field(a, &self.a * &other.b + &self.b * &other.a, other)
    }
}

impl Neg for Surd {
    type Output = Surd;
    fn neg(self) -> Surd {
        Surd {
            a: -self.a,
            b: -self.b,
            radicand: self.radicand,
        }
    }
}

/// The square root of `x ≥ 0`, if it is rational.
pub(crate) fn exact_root(x: &Rational) -> Option<Rational> {
    let root = |n: &UBig| {
        let (root, rest) = n.sqrt_rem();
        rest.is_zero().then_some(root)
    };
    Some(Rational::from_parts(
        root(&magnitude(x))?.into(),
        root(x.denominator())?,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surd(a: i32, b: i32, d: i32) -> Surd {
        Surd::new(a.into(), b.into(), d.into())
    }

    #[test]
    fn signs() {
        assert_eq!(surd(0, 0, 2).sign(), 0);
        assert_eq!(surd(-2, 1, 4).sign(), 0);
        assert_eq!(surd(-3, 2, 2).sign(), -1);
        assert_eq!(surd(3, -2, 2).sign(), 1);
        assert_eq!(surd(-7, 5, 2).sign(), 1);
        assert_eq!(surd(0, -1, 2).sign(), -1);
        assert_eq!(surd(-1, -1, 2).sign(), -1);
        // A convergent of √2: f64 sees p - q√2 as 0 or noise.
        let (p, q) = (
            Rational::from(886731088897_u64),
            Rational::from(627013566048_u64),
        );
        assert_eq!(Surd::new(p, -q, 2.into()).sign(), 1);
    }

    #[test]
    fn squares_are_folded() {
        assert_eq!(surd(1, 3, 4), Surd::from(Rational::from(7)));
        let quarter = Rational::from_parts(9.into(), 4u8.into());
        assert_eq!(
            Surd::root(quarter).as_rational(),
            Some(&Rational::from_parts(3.into(), 2u8.into()))
        );
        assert!(Surd::root(8.into()).as_rational().is_none());
    }

    #[test]
    fn field_operations() {
        let x = surd(1, 2, 3);
        assert_eq!(&x * &x.recip(), Surd::from(Rational::ONE));
        assert_eq!(&x - &x, Surd::from(Rational::ZERO));
        assert_eq!(
            &surd(1, 1, 3) * &surd(1, -1, 3),
            Surd::from(Rational::from(-2))
        );
        assert_eq!(&Surd::from(Rational::from(5)) + &x, surd(6, 2, 3));
    }

    #[test]
    fn comparisons_across_fields() {
        assert_eq!(surd(0, 1, 2).compare(&surd(0, 1, 3)), Ordering::Less);
        assert_eq!(surd(0, -1, 2).compare(&surd(0, -1, 3)), Ordering::Greater);
        assert_eq!(surd(0, 2, 2).compare(&surd(0, 1, 8)), Ordering::Equal);
        assert_eq!(surd(1, 1, 2).compare(&surd(0, 1, 6)), Ordering::Less);
        assert_eq!(surd(5, -1, 2).compare(&surd(2, 1, 2)), Ordering::Greater);
        assert_eq!(surd(1, 0, 2).compare(&surd(-1, 1, 4)), Ordering::Equal);
        assert_eq!(surd(1, 0, 2).compare(&surd(2, -1, 3)), Ordering::Greater);
    }
}
