//! How far a computed float is from an exact value.

use crate::exact::{Rational, abs, floor_log2, power_of_two, rational, sign};
use crate::format::Format;
use crate::real::Real;

/// `|computed - exact| / (u |exact|)` with the unit roundoff u of `format`, rounded to nearest.
///
/// 0 if `computed` is exact, or an infinity that `exact` rounds to; infinite for any other NaN or infinity, and for a
/// computed number other than 0 where `exact` is 0.
pub fn in_units(computed: f64, exact: &Real, format: Format) -> f64 {
    measure(computed, exact, format, |x| {
        abs(x.clone()) * power_of_two(-(format.precision() as isize))
    })
}

/// `|computed - exact|` in units in the last place that `format` has at `exact` (the subnormal spacing below its smallest
/// normal number), rounded to nearest; NaN and infinities as in [`in_units`].
pub fn in_ulps(computed: f64, exact: &Real, format: Format) -> f64 {
    measure(computed, exact, format, |x| {
        let exponent = if sign(x) == 0 {
            format.min_exponent()
        } else {
            floor_log2(x).max(format.min_exponent())
        };
        power_of_two(exponent + 1 - format.precision() as isize)
    })
}

fn measure(
    computed: f64,
    exact: &Real,
    format: Format,
    unit: impl Fn(&Rational) -> Rational,
) -> f64 {
    let Some(value) = rational(computed) else {
        return if exact.round(format) == computed {
            0.0
        } else {
            f64::INFINITY
        };
    };
    // Signs and binade come along, so that both ends of an enclosure lie in one monotone piece.
    let (.., error) = exact.decide(|x| {
        let (difference, unit) = (&value - x, unit(x));
        let binade = (sign(x) != 0).then(|| floor_log2(x));
        let error = match (sign(&difference), sign(&unit)) {
            (0, _) => 0.0,
            (_, 0) => f64::INFINITY,
            (side, _) => {
                let ratio = &difference / unit;
                Format::F64.round(&if side < 0 { -ratio } else { ratio })
            }
        };
        (sign(x), binade, sign(&difference), error)
    });
    error
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surd::Surd;

    fn exact(x: f64) -> Real {
        Real::from(rational(x).unwrap())
    }

    #[test]
    fn one_ulp_is_one_ulp_everywhere() {
        for format in Format::ALL {
            for x in [1.0, -1.5, 1e30, 1e-37, 1e-45].map(|x| format.narrow(x)) {
                assert_eq!(
                    in_ulps(format.step(x, 1), &exact(x), format),
                    1.0,
                    "{x} {format:?}"
                );
                assert_eq!(in_ulps(x, &exact(x), format), 0.0);
            }
        }
        assert_eq!(in_ulps(5e-324, &exact(0.0), Format::F64), 1.0);
        assert_eq!(
            in_ulps(f64::MAX, &Real::from(power_of_two(1024)), Format::F64),
            0.5
        );
    }

    #[test]
    fn units_are_relative() {
        assert_eq!(in_units(1.0 + f64::EPSILON, &exact(1.0), Format::F64), 2.0);
        assert_eq!(in_units(0.0, &exact(5e-324), Format::F64), 2f64.powi(53));
        assert_eq!(in_units(1.0, &exact(0.0), Format::F64), f64::INFINITY);
        assert_eq!(in_units(0.0, &exact(0.0), Format::F64), 0.0);
    }

    #[test]
    fn irrational_values() {
        let root = Real::from(Surd::root(2.into()));
        let nearest = in_ulps(std::f64::consts::SQRT_2, &root, Format::F64);
        assert!(nearest > 0.0 && nearest < 0.5);
        let next = in_ulps(
            Format::F64.step(std::f64::consts::SQRT_2, 1),
            &root,
            Format::F64,
        );
        assert!((next - 1.0).abs() <= 0.5);
    }

    #[test]
    fn not_finite() {
        let huge = Real::from(power_of_two(2000));
        assert_eq!(in_ulps(f64::INFINITY, &huge, Format::F64), 0.0);
        assert_eq!(
            in_ulps(f64::NEG_INFINITY, &huge, Format::F64),
            f64::INFINITY
        );
        assert_eq!(in_ulps(f64::NAN, &exact(1.0), Format::F64), f64::INFINITY);
    }
}
