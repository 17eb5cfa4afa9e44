//! Floats as exact rationals, and vectors of them.

use dashu_int::ops::BitTest;
use dashu_int::{IBig, UBig};
pub use dashu_ratio::RBig as Rational;

/// Three exact coordinates.
pub type Vector = [Rational; 3];

/// The exact value of a float; `None` for NaN and the infinities. `-0.0` is 0.
pub fn rational(x: f64) -> Option<Rational> {
    Rational::try_from(x).ok()
}

/// The exact value of three floats; `None` if any is NaN or infinite.
pub fn vector([x, y, z]: [f64; 3]) -> Option<Vector> {
    Some([rational(x)?, rational(y)?, rational(z)?])
}

/// -1, 0 or 1.
pub fn sign(x: &Rational) -> i8 {
    match x.cmp(&Rational::ZERO) {
        std::cmp::Ordering::Less => -1,
        std::cmp::Ordering::Equal => 0,
        std::cmp::Ordering::Greater => 1,
    }
}

/// `|x|`.
pub fn abs(x: Rational) -> Rational {
    if sign(&x) < 0 { -x } else { x }
}

/// `x²`.
pub fn square(x: &Rational) -> Rational {
    x * x
}

/// `a - b`.
pub fn sub(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] - &b[i])
}

/// The inner product.
pub fn dot(a: &Vector, b: &Vector) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// `2^exponent`.
pub fn power_of_two(exponent: isize) -> Rational {
    let power = UBig::ONE << exponent.unsigned_abs();
    if exponent < 0 {
        Rational::from_parts(IBig::ONE, power)
    } else {
        Rational::from(power)
    }
}

/// The floor of the binary logarithm of `|x|`, for `x ≠ 0`.
pub fn floor_log2(x: &Rational) -> isize {
    let (n, d) = (magnitude(x), x.denominator());
    let guess = n.bit_len() as isize - d.bit_len() as isize;
    let below = if guess < 0 {
        (n << guess.unsigned_abs()) < *d
    } else {
        n < (d << guess.unsigned_abs())
    };
    guess - isize::from(below)
}

/// The magnitude of the numerator.
pub(crate) fn magnitude(x: &Rational) -> UBig {
    use dashu_int::ops::UnsignedAbs;
    x.numerator().unsigned_abs()
}

/// The nearest integer to `n / d`, ties to even.
pub(crate) fn nearest(n: UBig, d: &UBig) -> UBig {
    use dashu_int::ops::DivRem;
    let (quotient, remainder) = n.div_rem(d);
    match (remainder << 1).cmp(d) {
        std::cmp::Ordering::Less => quotient,
        std::cmp::Ordering::Equal if !quotient.bit(0) => quotient,
        _ => quotient + UBig::ONE,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_are_exact() {
        assert_eq!(
            rational(0.1).unwrap(),
            Rational::from_parts(3602879701896397_i64.into(), (1u64 << 55).into())
        );
        assert_eq!(rational(-0.0).unwrap(), Rational::ZERO);
        assert_eq!(rational(5e-324).unwrap(), power_of_two(-1074));
        assert!(rational(f64::NAN).is_none() && rational(f64::INFINITY).is_none());
    }

    #[test]
    fn floor_log2_at_powers() {
        for k in [-1074, -1, 0, 1, 60, 1023] {
            let x = power_of_two(k);
            assert_eq!(floor_log2(&x), k);
            assert_eq!(
                floor_log2(&-(&x * Rational::from_parts(1.into(), 3u8.into()))),
                k - 2
            );
            assert_eq!(
                floor_log2(&(x * Rational::from_parts(5.into(), 3u8.into()))),
                k
            );
        }
    }
}
