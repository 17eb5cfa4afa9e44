//! Bounded numbers: bounds are not only right but close, and known what can be known.

use crate::property::for_all;
use ombrage::{Bounded, Real, Rounded};
use proptest::prelude::*;

/// Bounds are not only right but close: within a tenth of the first-order error.
pub fn moderate_numbers_stay_known() {
    let number = || (-12..12i32, 1.0..2.0f64).prop_map(|(e, m)| m * f64::from(e).exp2());
    let inputs = (number(), number(), 0.0..1e-3f64, 0.0..1e-3f64);
    for_all(inputs, |(a, b, p, q)| {
        let u = f64::SUM;
        let (x, y) = (Bounded::new(a, a * p), Bounded::new(b, b * q));
        let zero = Bounded::exact(0.0);
        let near = |name: &str, result: Bounded<f64>, relative: f64| {
            let most = 1.1 * result.value.abs() * relative;
            prop_assert!(result.error <= most, "{name} {result:?} of {x:?} and {y:?}");
            Ok(())
        };
        near("sum", x + y, (a * p + b * q) / (a + b) + u)?;
        near("product", x * y, p + q + 2.0 * u)?;
        near("quotient", x / y, p + q + 2.0 * u)?;
        near("root", x.sqrt(), p / 2.0 + 2.0 * u)?;
        near("inverse root", x.inverse_root(), p / 2.0 + 2.0 * u)?;
        let of_two = (a * b * (p + q) + 2.0 * a * a * p) / (a * b + a * a) + 4.0 * u;
        near(
            "sum of products",
            Real::sum_of_products([x, x, zero], [y, x, y]),
            of_two,
        )?;
        near(
            "sum of squares",
            Real::sum_of_squares([x, zero, x]),
            2.0 * p + 4.0 * u,
        )?;
        // Of vectors as lengths, and of the square as twice a length.
        let (scalar, square) = Real::products([x, zero, zero], [zero, y, zero]);
        let most = 1.1 * a * b * (p + q + 4.0 * u);
        prop_assert!(
            scalar.error <= most,
            "scalar product {scalar:?} of {x:?} and {y:?}"
        );
        prop_assert!(
            square.error <= 1.1 * 2.0 * a * b * most,
            "square {square:?} of {x:?} and {y:?}"
        );
        let difference = Real::difference_of_products([x, y], [zero, y]);
        near("difference of products", difference, p + q + 4.0 * u)
    });
}

/// Just below and above a whole number, or a power of two: known up to there, and no further.
pub fn integer_parts_and_leading_bits_are_known_up_to_their_ends() {
    for_all(
        (0..60u32, -40..-2i32, any::<bool>()),
        |(whole, distance, negative)| {
            let distance = f64::from(distance).exp2();
            let sign = if negative { -1.0 } else { 1.0 };
            let known = |value: f64, error: f64| Bounded::<f64>::new(sign * value, error);
            let is_known = |number: Bounded<f64>| number.error.is_finite();
            let end = f64::from(whole);
            for (value, part) in [(end + distance, end), (end + 1.0 - distance, end)] {
                let inside = known(value, 0.5 * distance).trunc();
                prop_assert!(
                    is_known(inside) && inside.value == sign * part,
                    "{inside:?}"
                );
                // Around 0 all have the same integer part.
                let crosses = value < 0.5 || is_known(known(value, 2.0 * distance).trunc());
                prop_assert!(crosses == (value < 0.5), "{value} with {}", 2.0 * distance);
            }
            let power = f64::from(whole).exp2();
            for value in [power * (1.0 + distance), 2.0 * power * (1.0 - distance)] {
                let inside = known(value, 0.5 * distance * power).binade();
                prop_assert!(is_known(inside) && inside.value == power, "{inside:?}");
                let outside = known(value, 4.0 * distance * power).binade();
                prop_assert!(
                    !is_known(outside),
                    "{value} with {}",
                    4.0 * distance * power
                );
            }
            let small = known(0.25 * distance, distance).trunc();
            prop_assert!(is_known(small) && small.value == 0.0, "{small:?}");
            Ok(())
        },
    );
}
