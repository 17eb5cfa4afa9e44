//! The two float formats: their bits as text, and correct rounding into them.

use crate::exact::{Rational, floor_log2, magnitude, nearest, sign};

/// An IEEE 754 binary format. Values of both are held in an `f64`, into which an `f32` widens exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// binary32
    F32,
    /// binary64
    F64,
}

impl Format {
    /// Both formats.
    pub const ALL: [Format; 2] = [Format::F32, Format::F64];

    /// The name in the protocol: `f32` or `f64`.
    pub fn name(self) -> &'static str {
        match self {
            Format::F32 => "f32",
            Format::F64 => "f64",
        }
    }

    /// The bits of the significand, the hidden one included.
    pub fn precision(self) -> u32 {
        match self {
            Format::F32 => f32::MANTISSA_DIGITS,
            Format::F64 => f64::MANTISSA_DIGITS,
        }
    }

    /// The binary exponent of the smallest normal number.
    pub fn min_exponent(self) -> isize {
        match self {
            Format::F32 => -126,
            Format::F64 => -1022,
        }
    }

    /// The unit roundoff u: 2^-24 or 2^-53.
    pub fn unit_roundoff(self) -> f64 {
        match self {
            Format::F32 => f64::from(f32::EPSILON) / 2.0,
            Format::F64 => f64::EPSILON / 2.0,
        }
    }

    /// The float whose bits these 8 or 16 hexadecimal digits are.
    pub fn parse(self, hex: &str) -> Option<f64> {
        let digits = hex.bytes().all(|b| b.is_ascii_hexdigit());
        match self {
            Format::F32 if digits && hex.len() == 8 => u32::from_str_radix(hex, 16)
                .ok()
                .map(|b| f64::from(f32::from_bits(b))),
            Format::F64 if digits && hex.len() == 16 => {
                u64::from_str_radix(hex, 16).ok().map(f64::from_bits)
            }
            _ => None,
        }
    }

    /// The bits of `x`, a value of this format, as 8 or 16 hexadecimal digits; one pattern for every NaN, since a cast may
    /// change its sign and payload.
    pub fn hex(self, x: f64) -> String {
        match self {
            Format::F32 if x.is_nan() => "7fc00000".into(),
            Format::F64 if x.is_nan() => "7ff8000000000000".into(),
            Format::F32 => format!("{:08x}", (x as f32).to_bits()),
            Format::F64 => format!("{:016x}", x.to_bits()),
        }
    }

    /// The value of this format nearest to `x`, ties to even; subnormals and overflow to infinity as in IEEE 754.
    /// A negative number too small for the format becomes `-0.0`; an exact zero is `+0.0`.
    pub fn round(self, x: &Rational) -> f64 {
        if sign(x) == 0 {
            return 0.0;
        }
        let precision = self.precision() as isize;
        let exponent = floor_log2(x).max(self.min_exponent());
        let shift = precision - 1 - exponent;
        let (n, d) = (magnitude(x), x.denominator());
        let significand = if shift < 0 {
            nearest(n, &(d << shift.unsigned_abs()))
        } else {
            nearest(n << shift.unsigned_abs(), d)
        };
        // A carry out of the significand runs into the exponent field, as it should.
        let biased = (exponent - self.min_exponent()) as u64;
        let bits = (biased << (precision - 1))
            .saturating_add(u64::try_from(significand).unwrap_or(u64::MAX));
        let rounded = match self {
            Format::F32 => f64::from(f32::from_bits(
                bits.min(u64::from(f32::INFINITY.to_bits())) as u32
            )),
            Format::F64 => f64::from_bits(bits.min(f64::INFINITY.to_bits())),
        };
        if sign(x) < 0 { -rounded } else { rounded }
    }

    /// The nearest value of this format to an `f64`.
    pub fn narrow(self, x: f64) -> f64 {
        match self {
            Format::F32 => f64::from(x as f32),
            Format::F64 => x,
        }
    }

    /// The value `steps` units in the last place above (below, if negative) a finite `x` of this format.
    pub fn step(self, x: f64, steps: i64) -> f64 {
        let (bits, top) = match self {
            Format::F32 => (i64::from((x as f32).to_bits() as i32), i64::from(i32::MIN)),
            Format::F64 => (x.to_bits() as i64, i64::MIN),
        };
        // Floats in order: negative patterns count down from zero.
        let ordered = if bits < 0 {
            top.wrapping_sub(bits)
        } else {
            bits
        } + steps;
        let bits = if ordered < 0 {
            top.wrapping_sub(ordered)
        } else {
            ordered
        };
        match self {
            Format::F32 => f64::from(f32::from_bits(bits as u32)),
            Format::F64 => f64::from_bits(bits as u64),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{power_of_two, rational};

    fn round32(x: impl std::borrow::Borrow<Rational>) -> u32 {
        (Format::F32.round(x.borrow()) as f32).to_bits()
    }

    #[test]
    fn ties_go_to_even() {
        let half = power_of_two(-24);
        let one = Rational::ONE;
        assert_eq!(round32(&one + &half), 0x3f80_0000);
        assert_eq!(round32(&one + &half * Rational::from(3)), 0x3f80_0002);
        assert_eq!(round32(&one + &half + power_of_two(-200)), 0x3f80_0001);
        assert_eq!(round32(-(&one + &half * Rational::from(3))), 0xbf80_0002);
        assert_eq!(round32(power_of_two(1) - power_of_two(-30)), 0x4000_0000);
    }

    #[test]
    fn subnormals_and_underflow() {
        assert_eq!(round32(power_of_two(-149)), 1);
        assert_eq!(round32(power_of_two(-150)), 0);
        assert_eq!(round32(power_of_two(-150) + power_of_two(-300)), 1);
        assert_eq!(
            round32(power_of_two(-149) * Rational::from(3) * power_of_two(-1)),
            2
        );
        assert_eq!(
            round32(power_of_two(-126) - power_of_two(-160)),
            0x0080_0000
        );
        assert_eq!(round32(-power_of_two(-2000)), 0x8000_0000);
    }

    #[test]
    fn overflow_goes_to_infinity() {
        let max = rational(f64::from(f32::MAX)).unwrap();
        assert_eq!(round32(&max), f32::MAX.to_bits());
        assert_eq!(round32(&max + power_of_two(102)), f32::MAX.to_bits());
        assert_eq!(round32(&max + power_of_two(103)), f32::INFINITY.to_bits());
        assert_eq!(round32(-power_of_two(5000)), f32::NEG_INFINITY.to_bits());
        assert_eq!(Format::F64.round(&power_of_two(1024)), f64::INFINITY);
    }

    #[test]
    fn rounding_a_float_is_the_identity() {
        for bits in [
            1u64,
            0x000f_ffff_ffff_ffff,
            0x0010_0000_0000_0000,
            0x3ff0_0000_0000_0001,
            0x7fef_ffff_ffff_ffff,
        ] {
            let x = f64::from_bits(bits);
            assert_eq!(Format::F64.round(&rational(x).unwrap()), x);
            assert_eq!(Format::F64.round(&rational(-x).unwrap()), -x);
        }
    }

    #[test]
    fn narrowing_agrees_with_the_processor() {
        for x in [0.1, 1e-40, -3.4e38, 3.5e38, 7e-46, 1.0 + f64::EPSILON] {
            assert_eq!(
                Format::F32.round(&rational(x).unwrap()).to_bits(),
                Format::F32.narrow(x).to_bits()
            );
        }
    }

    #[test]
    fn text_and_steps() {
        assert_eq!(Format::F32.parse("3f800000"), Some(1.0));
        assert_eq!(Format::F32.parse("+f800000"), None);
        assert_eq!(Format::F64.parse("3f800000"), None);
        assert_eq!(Format::F64.hex(-1.0), "bff0000000000000");
        assert_eq!(Format::F32.step(0.0, -1), -f64::from(f32::from_bits(1)));
        assert_eq!(Format::F64.step(-5e-324, 2), 5e-324);
        assert_eq!(Format::F32.hex(Format::F32.step(1.0, -1)), "3f7fffff");
    }
}
