//! The byte of a colour component: `truncate(255 * clamp(x, 0, 1))`, clause 3.3.

use crate::exact::{Rational, rational, sign};
use crate::format::Format;

/// What is true of a component as a byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuantiseTruth {
    /// The exact product truncated: the byte of clause 3.3.
    pub floor: u8,
    /// The exact product rounded, half up.
    pub round: u8,
    /// What `255 * x`, rounded to the format first, truncates to.
    pub float_mul_then_trunc: u8,
    /// What `255 * x + 0.5`, each operation rounded to the format, truncates to.
    pub float_mul_add_half_trunc: u8,
}

/// The byte of `x`, a value of `format`; 0 for NaN, by policy.
pub fn quantise(x: f64, format: Format) -> QuantiseTruth {
    let clamped = if x.is_nan() { 0.0 } else { x.clamp(0.0, 1.0) };
    let exact = rational(clamped).unwrap_or(Rational::ZERO);
    // Products and sums of f32 values are exact in f64, or so close that rounding twice does no harm (53 >= 2 * 24 + 2).
    let product = format.narrow(255.0 * clamped);
    QuantiseTruth {
        floor: byte(&exact),
        round: floor(&(exact * Rational::from(255) + Rational::from_parts(1.into(), 2u8.into()))),
        float_mul_then_trunc: product as u8,
        float_mul_add_half_trunc: format.narrow(product + 0.5) as u8,
    }
}

/// `truncate(255 * clamp(x, 0, 1))` of an exact component.
pub fn byte(x: &Rational) -> u8 {
    if sign(x) < 0 {
        0
    } else {
        floor(&(x * Rational::from(255)))
    }
}

fn floor(x: &Rational) -> u8 {
    u8::try_from(x.floor()).unwrap_or(u8::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_double_precision_trap() {
        let trapped = |format: Format| {
            (0..=255u8)
                .filter(|&k| {
                    let x = format.narrow(f64::from(k) / 255.0);
                    let truth = quantise(x, format);
                    truth.floor != truth.float_mul_then_trunc
                })
                .count()
        };
        assert_eq!((trapped(Format::F32), trapped(Format::F64)), (0, 143));
    }

    #[test]
    fn ends_and_policy() {
        let floor = |x| quantise(x, Format::F64).floor;
        assert_eq!(
            [
                floor(f64::NAN),
                floor(-1.0),
                floor(f64::INFINITY),
                floor(1.0)
            ],
            [0, 0, 255, 255]
        );
        assert_eq!(floor(Format::F64.step(1.0, -1)), 254);
    }
}
