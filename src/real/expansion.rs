//! Exact sums, for the decisions that rounding would spoil.

use super::double_double::{two_product, two_sum};
use super::{DoubleDouble, Scalar};
use crate::vector::Vector;
use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

/// The exact value of sums, differences and products of numbers, as a sum of `f64` of which none
/// overlaps another, the smallest first. It is exact as long as no product of two parts overflows
/// or has bits below 2^-1074, which numbers scaled to about 1 do not.
///
/// Source: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates", Discrete & Computational Geometry 18 (1997), sections 2.4 to 2.8.
#[derive(Clone, Debug)]
pub(crate) struct Expansion(Vec<f64>);

/// Three exact numbers.
pub(crate) type Exact3 = [Expansion; 3];

impl Expansion {
    /// Where the number is, seen from zero.
    pub fn sign(&self) -> Ordering {
        let leading = self.0.last().copied().unwrap_or(0.0);
        leading.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }

    /// The number rounded to a double-double.
    pub fn round(&self) -> DoubleDouble {
        let parts = self.0.iter().map(|&part| DoubleDouble::from_f64(part));
        parts.fold(DoubleDouble::from_f64(0.0), |sum, part| sum + part)
    }

    /// Adds one `f64` (Shewchuk, figure 6).
    fn grow(&mut self, term: f64) {
        let mut carry = term;
        for part in &mut self.0 {
            (carry, *part) = two_sum(carry, *part);
        }
        self.0.push(carry);
        self.0.retain(|&part| part != 0.0);
    }

    /// As few parts as the number needs, or nearly so (Shewchuk, figure 15, downward half twice).
    fn compressed(mut self) -> Self {
        let Some(mut carry) = self.0.pop() else {
            return self;
        };
        let mut large = vec![];
        while let Some(part) = self.0.pop() {
            let (sum, rest) = two_sum(carry, part);
            if rest == 0.0 {
                carry = sum;
            } else {
                large.push(sum);
                carry = rest;
            }
        }
        while let Some(part) = large.pop() {
            let (sum, rest) = two_sum(part, carry);
            if rest != 0.0 {
                self.0.push(rest);
            }
            carry = sum;
        }
        self.0.push(carry);
        self
    }
}

impl<S: Scalar> From<S> for Expansion {
    fn from(value: S) -> Self {
        let value = value.to_double_double();
        let parts = [value.low(), value.high()];
        Self(parts.into_iter().filter(|&part| part != 0.0).collect())
    }
}

impl Add for &Expansion {
    type Output = Expansion;

    fn add(self, other: &Expansion) -> Expansion {
        let mut sum = self.clone();
        for &part in &other.0 {
            sum.grow(part);
        }
        sum.compressed()
    }
}

impl Sub for &Expansion {
    type Output = Expansion;

    fn sub(self, other: &Expansion) -> Expansion {
        let mut difference = self.clone();
        for &part in &other.0 {
            difference.grow(-part);
        }
        difference.compressed()
    }
}

impl Mul for &Expansion {
    type Output = Expansion;

    fn mul(self, other: &Expansion) -> Expansion {
        let mut product = Expansion(vec![]);
        for &a in &self.0 {
            for &b in &other.0 {
                let (high, low) = two_product(a, b);
                product.grow(low);
                product.grow(high);
            }
        }
        product.compressed()
    }
}

/// The exact values of a vector's components.
pub(crate) fn exact3<S: Scalar>(vector: S::Vector) -> Exact3 {
    vector.to_array().map(Expansion::from)
}

/// `a - b`.
pub(crate) fn difference(a: &Exact3, b: &Exact3) -> Exact3 {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

/// `a + t b`.
pub(crate) fn along(a: &Exact3, t: &Expansion, b: &Exact3) -> Exact3 {
    [0, 1, 2].map(|i| &a[i] + &(t * &b[i]))
}

/// The scalar product.
pub(crate) fn dot(a: &Exact3, b: &Exact3) -> Expansion {
    let [x, y, z] = [0, 1, 2].map(|i| &a[i] * &b[i]);
    &(&x + &y) + &z
}

/// The vector product.
pub(crate) fn cross(a: &Exact3, b: &Exact3) -> Exact3 {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &(&a[i] * &b[j]) - &(&a[j] * &b[i]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(value: f64) -> Expansion {
        Expansion::from(value)
    }

    #[test]
    fn nothing_is_lost_in_a_sum() {
        let (huge, tiny) = (exact(1e200), exact(1e-200));
        let sum = &(&huge + &tiny) - &huge;
        assert_eq!(sum.0, [1e-200]);
        assert_eq!((&sum - &tiny).sign(), Ordering::Equal);
    }

    #[test]
    fn products_that_differ_beyond_two_floats() {
        // (1 + e)(1 - e) = 1 - e², and its square against 1 - 2e²: e⁴ apart.
        let e = 2f64.powi(-52);
        let product = &exact(1.0 + e) * &exact(1.0 - e);
        let square = &product * &product;
        let near = &exact(1.0) - &exact(2.0 * e * e);
        assert_eq!((&square - &near).0, [e * e * e * e]);
        assert_eq!((&near - &square).sign(), Ordering::Less);
    }

    #[test]
    fn as_few_parts_as_needed() {
        let third = exact(1.0 / 3.0);
        let mut sum = exact(0.0);
        for _ in 0..100 {
            sum = &(&sum + &third) + &exact(1e-30);
        }
        assert!(sum.0.len() <= 4, "{:?}", sum.0);
        // The terms of 1e-30 are too small to change the rounding.
        assert_eq!(sum.round().high(), 100.0 * (1.0 / 3.0));
    }
}
