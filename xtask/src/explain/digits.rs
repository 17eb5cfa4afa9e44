//! Numbers in decimal, with as many digits as are worth it, their points below each other.

use ombrage::DoubleDouble;
use ombrage_oracle::decimal::decimal;
use ombrage_oracle::exact::rational;

/// The decimal digits of a double-double, `d.ddd…e±dd` with 41 digits; `inf` or `nan` for those.
pub fn scientific(x: DoubleDouble) -> String {
    match rational(x.high()).zip(rational(x.low())) {
        Some((high, low)) => decimal(&(high + low)),
        None => x.high().to_string().to_lowercase(),
    }
}

/// The number with so many significant digits, the rest cut off: fixed for magnitudes from 1e-3 to
/// 1e5, else with an exponent. Whole numbers are given whole.
pub fn digits(x: DoubleDouble, count: usize) -> String {
    let text = scientific(x);
    let Some((mantissa, exponent)) = text.split_once('e') else {
        return text;
    };
    let sign = if mantissa.starts_with('-') { "-" } else { "" };
    let all: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let digits = all.get(..count).unwrap_or(&all).trim_end_matches('0');
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if digits.is_empty() {
        return "0".into();
    }
    let place = |digits: &str| match digits.split_at(1) {
        (first, "") => first.to_owned(),
        (first, rest) => format!("{first}.{rest}"),
    };
    match usize::try_from(exponent) {
        Ok(whole @ 0..=5) => {
            let digits = format!("{digits:0<width$}", width = whole + 1);
            let (whole, part) = digits.split_at(whole + 1);
            let point = if part.is_empty() { "" } else { "." };
            format!("{sign}{whole}{point}{part}")
        }
        Err(_) if exponent >= -3 => {
            let zeros = "0".repeat(exponent.unsigned_abs() as usize - 1);
            format!("{sign}0.{zeros}{digits}")
        }
        _ => format!("{sign}{}e{exponent}", place(digits)),
    }
}

/// A number of either format, exactly.
pub fn exact(x: f64) -> DoubleDouble {
    DoubleDouble::new(x, 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_those_of_the_number() {
        for (x, count, text) in [
            (0.5, 17, "0.5"),
            (-2.0, 9, "-2"),
            (1000.0, 9, "1000"),
            (0.1, 19, "0.1000000000000000055"),
            (f64::from(0.1f32), 9, "0.100000001"),
            (1.0 / 512.0, 3, "0.00195"),
            (1.0 / 1024.0, 3, "9.76e-4"),
            (1e-20, 3, "9.99e-21"),
            (3.5e20, 5, "3.5e20"),
            (0.0, 5, "0"),
            (f64::INFINITY, 5, "inf"),
        ] {
            assert_eq!(digits(exact(x), count), text);
        }
        let third = DoubleDouble::new(1.0, 0.0) / DoubleDouble::new(3.0, 0.0);
        assert_eq!(digits(third, 30), format!("0.{}", "3".repeat(30)));
    }
}
