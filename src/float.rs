//! The two formats of IEEE 754 that kernels are judged in: `f32` and `f64`.

use crate::real::{Constant, DoubleDouble, Real, Scalar};
use std::fmt::{Debug, Display, LowerExp};

/// `f32` or `f64`: a scalar whose bits can be seen, and compared place by place.
pub trait Float: Scalar + Debug + Display + LowerExp {
    /// Bits of precision, the leading one included: 24 or 53.
    const PRECISION: u32;

    /// The bits, widened to 64.
    fn bits(self) -> u64;
    /// The number with these bits; only the low 32 count for `f32`.
    fn from_bits(bits: u64) -> Self;
    /// The bits in big-endian hexadecimal: 8 digits for `f32`, 16 for `f64`.
    fn hex(self) -> String;
    /// How many numbers of this format lie between the two, counting one end: 0 for equal numbers
    /// (also `0.0` and `-0.0`), `u64::MAX` where either is NaN.
    fn ulp_distance(self, other: Self) -> u64;
}

macro_rules! float {
    ($float:ident, $bits:ident, $signed:ident, $vector:ty) => {
        impl Real for $float {
            type Scalar = $float;
            type Mask = bool;
            type Vector = $vector;
            type Token = ();

            #[inline(always)]
            fn token(self) {}

            #[inline(always)]
            fn splat((): (), value: $float) -> $float {
                value
            }

            #[inline(always)]
            fn never((): ()) -> bool {
                false
            }

            #[inline(always)]
            fn sqrt(self) -> $float {
                <$float>::sqrt(self)
            }

            #[inline(always)]
            fn trunc(self) -> $float {
                <$float>::trunc(self)
            }

            #[inline(always)]
            fn abs(self) -> $float {
                <$float>::abs(self)
            }

            #[inline(always)]
            fn step(self, count: $float) -> $float {
                let counts = <$float>::abs(count) <= 0.5 / <$float>::EPSILON;
                let places = if counts { count as $signed } else { 0 };
                let places = if self < 0.0 { -places } else { places };
                <$float>::from_bits(self.to_bits().wrapping_add(places as $bits))
            }

            #[inline(always)]
            fn binade(self) -> $float {
                <$float>::from_bits(self.to_bits() & <$float>::INFINITY.to_bits())
            }

            #[inline(always)]
            fn lt(self, other: $float) -> bool {
                self < other
            }

            #[inline(always)]
            fn le(self, other: $float) -> bool {
                self <= other
            }

            #[inline(always)]
            fn select(mask: bool, yes: $float, no: $float) -> $float {
                if mask { yes } else { no }
            }

            #[inline(always)]
            fn each<const N: usize>(
                inputs: [$float; N],
                f: impl Fn([$float; N]) -> $float,
            ) -> $float {
                f(inputs)
            }
        }

        impl Float for $float {
            const PRECISION: u32 = $float::MANTISSA_DIGITS;

            fn bits(self) -> u64 {
                u64::from(self.to_bits())
            }

            fn from_bits(bits: u64) -> $float {
                <$float>::from_bits(bits as $bits)
            }

            fn hex(self) -> String {
                format!(
                    "{:0width$x}",
                    self.to_bits(),
                    width = 2 * size_of::<$float>()
                )
            }

            fn ulp_distance(self, other: $float) -> u64 {
                if self.is_nan() || other.is_nan() {
                    return u64::MAX;
                }
                let place = |x: $float| {
                    let magnitude = i128::from(x.to_bits() & ($bits::MAX >> 1));
                    if x.is_sign_negative() {
                        -magnitude
                    } else {
                        magnitude
                    }
                };
                u64::try_from((place(self) - place(other)).unsigned_abs()).unwrap_or(u64::MAX)
            }
        }
    };
}

float!(f32, u32, i32, glam::Vec3);
float!(f64, u64, i64, glam::DVec3);

impl Constant for f32 {
    const EPSILON: f64 = f32::EPSILON as f64;
    const MIN_POSITIVE: f64 = f32::MIN_POSITIVE as f64;

    #[inline(always)]
    fn from_f64(value: f64) -> f32 {
        value as f32
    }
}

impl Scalar for f32 {
    type Wide = f64;

    const NAME: &'static str = "f32";
    const MAX: f32 = f32::MAX;

    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }

    #[inline(always)]
    fn widen(self) -> f64 {
        f64::from(self)
    }

    #[inline(always)]
    fn narrow(wide: f64) -> f32 {
        wide as f32
    }

    #[inline(always)]
    fn scaled(self, power_of_two: f64) -> f32 {
        (f64::from(self) * power_of_two) as f32
    }

    fn tan_half(degrees: f32) -> f32 {
        f64::tan_half(f64::from(degrees)) as f32
    }
}

impl Constant for f64 {
    const EPSILON: f64 = f64::EPSILON;
    const MIN_POSITIVE: f64 = f64::MIN_POSITIVE;

    #[inline(always)]
    fn from_f64(value: f64) -> f64 {
        value
    }
}

impl Scalar for f64 {
    type Wide = DoubleDouble;

    const NAME: &'static str = "f64";
    const MAX: f64 = f64::MAX;

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }

    #[inline(always)]
    fn widen(self) -> DoubleDouble {
        DoubleDouble::from_f64(self)
    }

    #[inline(always)]
    fn narrow(wide: DoubleDouble) -> f64 {
        wide.high()
    }

    #[inline(always)]
    fn scaled(self, power_of_two: f64) -> f64 {
        self * power_of_two
    }

    fn tan_half(degrees: f64) -> f64 {
        libm::tan(degrees * (std::f64::consts::PI / 360.0))
    }
}
