//! Bytes, against exact integers.

use crate::property::{Sample, any_number, for_all};
use crate::report::show;
use ombrage::Film;
use proptest::prelude::*;

/// `floor(255 x)` of a finite x that is not below 0, from the integers its bits are; `None` past
/// 128 bits.
fn level<F: Sample>(x: F) -> Option<u128> {
    let bits = x.to_f64().to_bits();
    let exponent = (bits >> 52) as i32;
    let fraction = u128::from(bits & ((1 << 52) - 1));
    let (mantissa, exponent) = if exponent == 0 {
        (fraction, 1)
    } else {
        (fraction | 1 << 52, exponent)
    };
    let (product, shift) = (255 * mantissa, exponent - 1075);
    match shift {
        ..-127 => Some(0),
        -127..=0 => Some(product >> -shift),
        1..=67 => Some(product << shift),
        _ => None,
    }
}

fn byte<F: Sample>(film: Film, x: F) -> u128 {
    let byte = film.byte(x).to_f64();
    assert!(
        byte.fract() == 0.0 && (0.0..=255.0).contains(&byte),
        "{} is byte {byte}",
        show(x)
    );
    byte as u128
}

/// Compares both films with the exact level.
fn check<F: Sample>(x: F) -> Result<(), String> {
    let is_number = x.to_f64() > 0.0 && x.to_f64().is_finite();
    let level = if is_number { level(x) } else { Some(0) };
    let clamped = match level {
        _ if x.to_f64() == f64::INFINITY => 255,
        None => 255,
        Some(level) => level.min(255),
    };
    if byte(Film::Clamp, x) != clamped {
        return Err(format!(
            "{} is byte {} instead of {clamped}",
            show(x),
            byte(Film::Clamp, x)
        ));
    }
    let wrapped = byte(Film::Wrap, x);
    match level {
        // Levels with more digits than the format are not whole numbers of it.
        Some(level) if level >> F::PRECISION == 0 && wrapped != level % 256 => Err(format!(
            "{} wraps to {wrapped} instead of {}",
            show(x),
            level % 256
        )),
        _ => Ok(()),
    }
}

/// k/255 rounded to the format and its neighbours, where `floor(255 x)` of the rounded product is
/// wrong for 143 values of k in `f64`.
pub fn bytes_around_every_level_are_exact<F: Sample>() {
    for k in 0..=1024u16 {
        let x = F::from_f64(f64::from(k) / 255.0);
        for places in -3..=3 {
            let near = if k == 0 {
                x
            } else {
                x.step(F::from_f64(f64::from(places)))
            };
            check(near).unwrap_or_else(|words| panic!("{k}/255, {places} places on: {words}"));
        }
    }
}

pub fn bytes_are_exact<F: Sample>() {
    let inputs = prop_oneof![
        (0.0..1.0f64).prop_map(F::from_f64),
        (0.0..1e4f64).prop_map(F::from_f64)
    ];
    for_all(inputs, |x| check(x).map_err(TestCaseError::fail));
}

/// Infinities, NaN, numbers below 0 and of any size.
pub fn bytes_of_any_bits_are_bytes<F: Sample>() {
    for_all(any_number::<F>(), |x| check(x).map_err(TestCaseError::fail));
}

pub fn clamped_bytes_grow_with_radiance<F: Sample>() {
    for_all([any_number::<F>(), any_number::<F>()], |[a, b]| {
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        prop_assume!(a <= b);
        prop_assert!(byte(Film::Clamp, a) <= byte(Film::Clamp, b));
        Ok(())
    });
}
