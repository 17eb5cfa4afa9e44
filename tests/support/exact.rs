//! Floats as exact rationals: what a result must be, without a rounding.

use dashu_ratio::RBig;
use ombrage::{DoubleDouble, Scalar, Vector};

/// A finite number as it is.
pub fn exact<S: Exact>(x: S) -> RBig {
    x.exact()
}

/// A vector of finite numbers as it is.
pub fn exact_vector<S: Scalar + Exact>(v: S::Vector) -> [RBig; 3] {
    v.to_array().map(exact)
}

/// A number that is a rational.
pub trait Exact {
    /// Its value.
    fn exact(self) -> RBig;
}

impl Exact for f32 {
    fn exact(self) -> RBig {
        f64::from(self).exact()
    }
}

impl Exact for f64 {
    fn exact(self) -> RBig {
        RBig::try_from(self).expect("the number is finite")
    }
}

impl Exact for DoubleDouble {
    fn exact(self) -> RBig {
        self.high().exact() + self.low().exact()
    }
}

/// 2 to a power.
pub fn power_of_two(exponent: i32) -> RBig {
    assert!((-1022..1024).contains(&exponent));
    f64::from_bits(((1023 + exponent) as u64) << 52).exact()
}

/// The magnitude.
pub fn abs(x: RBig) -> RBig {
    if x < RBig::ZERO { -x } else { x }
}

/// The difference of two vectors.
pub fn minus(a: &[RBig; 3], b: &[RBig; 3]) -> [RBig; 3] {
    std::array::from_fn(|i| &a[i] - &b[i])
}

/// The terms of the scalar product of two vectors.
pub fn products(a: &[RBig; 3], b: &[RBig; 3]) -> [RBig; 3] {
    std::array::from_fn(|i| &a[i] * &b[i])
}

/// The sum of three numbers.
pub fn sum([x, y, z]: [RBig; 3]) -> RBig {
    x + y + z
}

/// The scalar product.
pub fn dot(a: &[RBig; 3], b: &[RBig; 3]) -> RBig {
    sum(products(a, b))
}

/// The vector product.
pub fn cross(a: &[RBig; 3], b: &[RBig; 3]) -> [RBig; 3] {
    let component = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [component(1, 2), component(2, 0), component(0, 1)]
}
