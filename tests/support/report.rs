//! What a failed comparison of floats says.

use ombrage::Float;

/// A number in decimal, in hexadecimal and in bits.
pub fn show<F: Float>(x: F) -> String {
    let digits = if F::PRECISION == 24 { 32 } else { 64 };
    format!("{x:e} = 0x{} = 0b{:0digits$b}", x.hex(), x.bits())
}

/// What was asked, what should have come, what came, and how far apart they are.
pub fn differs<F: Float>(what: &str, inputs: &[(&str, F)], expected: F, actual: F) -> String {
    let inputs: String = inputs
        .iter()
        .map(|(name, x)| format!("\n    {name}: {}", show(*x)))
        .collect();
    format!(
        "{what} ({}){inputs}\n    expected: {}\n    actual:   {}\n    distance: {} ulp",
        F::NAME,
        show(expected),
        show(actual),
        expected.ulp_distance(actual),
    )
}
