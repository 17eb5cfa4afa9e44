//! Every word of the vocabulary, and the storing of bytes, on special values.

use crate::bits;
use fearless_simd::{Simd, dispatch};
use ombrage::*;

/// A number of each kind, and numbers near the borders between kinds.
fn special_values<F: Float>() -> Vec<F> {
    let one = F::from_f64(1.0);
    let whole = F::from_f64(1.0 / F::EPSILON);
    let mut values = vec![
        F::from_f64(0.0),
        F::from_bits(1),
        F::MAX,
        one / F::from_f64(0.0),
        whole,
    ];
    values.extend([1.0, 0.3, 1.5, 2.0, 255.0, 255.9, 256.0, 1e-3, 3e9, 1e19].map(F::from_f64));
    for border in [
        one,
        whole,
        whole * F::from_f64(0.25),
        whole * F::from_f64(0.5),
    ] {
        values.extend([border.bits() - 1, border.bits(), border.bits() + 1].map(F::from_bits));
    }
    let smallest_normal = F::from_bits(1 << (F::PRECISION - 1));
    values.extend([smallest_normal, smallest_normal - F::from_bits(1)]);
    values.extend(values.clone().into_iter().map(|x| -x));
    values.push(F::from_f64(f64::NAN));
    values
}

/// Checks one word of the vocabulary on the lanes of two packets.
fn check_word<R: Lanes<Scalar: Float>>(
    word: &str,
    [a, b]: [&[R::Scalar]; 2],
    packet: R,
    scalar: impl Fn(R::Scalar, R::Scalar) -> R::Scalar,
) {
    let mut lanes = [R::Scalar::default(); 32];
    packet.store(&mut lanes);
    for ((&a, &b), &lane) in a.iter().zip(b).zip(&lanes) {
        let expected = scalar(a, b);
        assert!(
            bits(lane) == bits(expected),
            "{word} of {a:e} ({}) and {b:e} ({}): expected {expected:e} ({}), got {lane:e} ({}) in {}",
            a.hex(),
            b.hex(),
            expected.hex(),
            lane.hex(),
            std::any::type_name::<R>()
        );
    }
}

/// Checks every word of the vocabulary on every pair of special values.
fn check_words<R: Lanes<Scalar: Float>>(token: R::Token) {
    let values = special_values::<R::Scalar>();
    let one = R::Scalar::from_f64(1.0);
    for shift in 0..values.len() {
        for start in 0..values.len() {
            let lane = |k: usize| values[k % values.len()];
            let a: Vec<_> = (0..R::LANES).map(|k| lane(start + k)).collect();
            let b: Vec<_> = (0..R::LANES).map(|k| lane(start + k + shift)).collect();
            let (x, y) = (R::load(token, &a), R::load(token, &b));
            let (yes, no) = (x.constant(1.0), x.constant(0.0));
            let flag = |mask| R::select(mask, yes, no);
            let truth = |truth: bool| R::Scalar::from_f64(f64::from(u8::from(truth)));
            let inputs = [&a[..], &b[..]];
            check_word("+", inputs, x + y, |a, b| a + b);
            check_word("-", inputs, x - y, |a, b| a - b);
            check_word("*", inputs, x * y, |a, b| a * b);
            check_word("/", inputs, x / y, |a, b| a / b);
            check_word("neg", inputs, -x, |a, _| -a);
            check_word("sqrt", inputs, x.sqrt(), |a, _| Real::sqrt(a));
            check_word("trunc", inputs, x.trunc(), |a, _| Real::trunc(a));
            check_word("abs", inputs, x.abs(), |a, _| Real::abs(a));
            check_word("binade", inputs, x.binade(), |a, _| Real::binade(a));
            check_word("step", inputs, x.step(y), Real::step);
            check_word("lt", inputs, flag(x.lt(y)), |a, b| truth(a < b));
            check_word("le", inputs, flag(x.le(y)), |a, b| truth(a <= b));
            check_word("gt", inputs, flag(x.gt(y)), |a, b| truth(a > b));
            check_word("ge", inputs, flag(x.ge(y)), |a, b| truth(a >= b));
            check_word("select", inputs, R::select(x.lt(y), x, y), |a, b| {
                if a < b { a } else { b }
            });
            check_word("not", inputs, flag(!x.lt(y)), |a, b| truth(!Real::lt(a, b)));
            let within = |a, b| (a < b) & (b <= one);
            check_word("and", inputs, flag(x.lt(y) & y.le(yes)), |a, b| {
                truth(within(a, b))
            });
            let outside = |a, b| (a < b) | (b <= one);
            check_word("or", inputs, flag(x.lt(y) | y.le(yes)), |a, b| {
                truth(outside(a, b))
            });
            let less = a.iter().zip(&b).any(|(a, b)| a < b);
            assert_eq!(x.lt(y).any(), less, "any of {a:?} < {b:?}");
        }
    }
    assert!(!R::never(token).any());
    check_word(
        "splat",
        [&values[..1], &values[..1]],
        R::splat(token, values[0]),
        |a, _| a,
    );
}

fn check_packet_and_pair<L: Simd, F: Lane>(token: L, _: Level) {
    check_words::<Packet<L, F>>(token);
    check_words::<Pair<Packet<L, F>>>(token);
}

#[test]
fn every_word_has_the_scalars_bits() {
    at_every_level!(check_packet_and_pair());
}

/// Checks that every byte ends where it belongs, and no more is written than may be.
fn check_stored_bytes<R: Lanes>(token: R::Token) {
    let color = |start: usize| -> Vec<R::Scalar> {
        let bytes = (0..R::LANES).map(|k| (start + 5 * k) % 256);
        bytes.map(|byte| R::Scalar::from_f64(byte as f64)).collect()
    };
    for start in 0..256 {
        let colors = [color(start), color(start + 101), color(start + 202)];
        let mut bytes = [7; 3 * 64];
        let rgb = colors.each_ref().map(|color| R::load(token, color));
        R::store_rgb(rgb, &mut bytes);
        for (k, pixel) in bytes.as_chunks::<3>().0.iter().enumerate() {
            let expected = colors
                .each_ref()
                .map(|color| color.get(k).map(|x| x.to_f64() as u8));
            match expected {
                [Some(r), Some(g), Some(b)] => assert_eq!(pixel, &[r, g, b], "pixel {k}"),
                _ if k < R::LANES + R::SPILL => {}
                _ => assert_eq!(pixel, &[7; 3], "pixel {k} is beyond the spill"),
            }
        }
    }
}

fn check_bytes<L: Simd, F: Lane>(token: L, _: Level) {
    check_stored_bytes::<F>(());
    check_stored_bytes::<Packet<L, F>>(token);
    check_stored_bytes::<Pair<Packet<L, F>>>(token);
}

#[test]
fn bytes_are_stored_in_place() {
    at_every_level!(check_bytes());
}
