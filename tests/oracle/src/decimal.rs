//! Rationals in decimal: 41 significant digits, correctly rounded.

use crate::exact::{Rational, floor_log2, magnitude, nearest, sign};
use dashu_int::UBig;

/// How many significant digits a printed number has.
pub const DIGITS: usize = 41;

/// `x` as `d.ddd…e±dd` with [`DIGITS`] significant digits, rounded to nearest, ties to even.
pub fn decimal(x: &Rational) -> String {
    if sign(x) == 0 {
        return scientific(&"0".repeat(DIGITS), 0);
    }
    let limit = UBig::from(10u8).pow(DIGITS);
    let guess = (floor_log2(x) as f64 * std::f64::consts::LOG10_2).floor() as isize;
    // The guess is the exponent or one less.
    let (digits, exponent) = [guess, guess + 1]
        .into_iter()
        .map(|exponent| (scaled(x, DIGITS as isize - 1 - exponent), exponent))
        .find(|(digits, _)| *digits < limit)
        .unwrap_or_else(|| (limit / UBig::from(10u8), guess + 2));
    let text = scientific(&digits.to_string(), exponent);
    if sign(x) < 0 {
        format!("-{text}")
    } else {
        text
    }
}

/// The number that such a text says, also with fewer digits; `None` for any other text.
pub fn parse(text: &str) -> Option<Rational> {
    let (digits, exponent) = text.split_once('e')?;
    let negative = digits.starts_with('-');
    let (whole, fraction) = digits.trim_start_matches('-').split_once('.')?;
    let ten = Rational::from(10);
    let mut value = Rational::ZERO;
    for digit in whole.chars().chain(fraction.chars()) {
        value = value * &ten + Rational::from(digit.to_digit(10)?);
    }
    let exponent = exponent.parse::<isize>().ok()? - isize::try_from(fraction.len()).ok()?;
    let power = Rational::from(UBig::from(10u8).pow(exponent.unsigned_abs()));
    let value = if exponent < 0 {
        value / power
    } else {
        value * power
    };
    Some(if negative { -value } else { value })
}

/// The integer nearest to `|x| 10^power`.
fn scaled(x: &Rational, power: isize) -> UBig {
    let ten = UBig::from(10u8).pow(power.unsigned_abs());
    if power < 0 {
        nearest(magnitude(x), &(x.denominator() * ten))
    } else {
        nearest(magnitude(x) * ten, x.denominator())
    }
}

fn scientific(digits: &str, exponent: isize) -> String {
    let sign = if exponent < 0 { '-' } else { '+' };
    format!(
        "{}.{}e{sign}{:02}",
        &digits[..1],
        &digits[1..],
        exponent.unsigned_abs()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{power_of_two, rational};

    #[test]
    fn parse_reads_what_decimal_writes() {
        for x in [0.0, 1.0, -0.1, 5e-324, 1.797e308, -1.0 / 3.0] {
            let text = decimal(&rational(x).unwrap());
            assert_eq!(decimal(&parse(&text).unwrap()), text);
        }
        assert_eq!(
            parse("1.5e+00"),
            Some(Rational::from_parts(3.into(), 2u8.into()))
        );
        assert!(
            ["", "1", "1.5", "x.5e+00", "1.5e", "e+00"]
                .iter()
                .all(|text| parse(text).is_none())
        );
    }

    #[test]
    fn known_numbers() {
        let zeros = "0".repeat(40);
        assert_eq!(decimal(&Rational::ZERO), format!("0.{zeros}e+00"));
        assert_eq!(decimal(&Rational::ONE), format!("1.{zeros}e+00"));
        assert_eq!(decimal(&Rational::from(-10)), format!("-1.{zeros}e+01"));
        assert_eq!(
            decimal(&rational(0.001).unwrap()),
            "1.0000000000000000208166817117216851329431e-03"
        );
        assert_eq!(
            decimal(&power_of_two(-1074)),
            "4.9406564584124654417656879286822137236506e-324"
        );
    }

    #[test]
    fn carries_into_the_exponent() {
        let ten = Rational::from(10);
        let almost = &ten - power_of_two(-200);
        assert_eq!(decimal(&almost), decimal(&ten));
        assert_eq!(
            decimal(&(almost / Rational::from(100))),
            decimal(&(Rational::ONE / ten))
        );
    }

    #[test]
    fn every_power_of_ten_has_its_exponent() {
        for k in 0..400 {
            let power = Rational::from(UBig::from(10u8).pow(k));
            assert!(
                decimal(&power).starts_with("1.0000")
                    && decimal(&power).ends_with(&format!("e+{k:02}"))
            );
            let less = decimal(&(&power - power_of_two(-1)));
            assert!(
                k > 40
                    || less.ends_with(&format!(
                        "e{}{:02}",
                        if k == 0 { '-' } else { '+' },
                        k.abs_diff(1)
                    )),
                "{less}"
            );
        }
    }
}
