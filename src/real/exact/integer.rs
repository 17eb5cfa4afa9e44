//! Whole numbers of any size: as little of them as exact decisions need.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

/// A whole number: its sign, and its magnitude in digits of 32 bits, the least significant first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Integer {
    negative: bool,
    digits: Vec<u32>,
}

impl From<u64> for Integer {
    fn from(value: u64) -> Self {
        Self::new(false, vec![value as u32, (value >> 32) as u32])
    }
}

impl Integer {
    /// Drops leading zeros; zero is not negative.
    fn new(negative: bool, mut digits: Vec<u32>) -> Self {
        while digits.last() == Some(&0) {
            digits.pop();
        }
        let negative = negative && !digits.is_empty();
        Self { negative, digits }
    }

    pub fn sign(&self) -> Ordering {
        match (self.digits.is_empty(), self.negative) {
            (true, _) => Ordering::Equal,
            (_, true) => Ordering::Less,
            _ => Ordering::Greater,
        }
    }

    /// How many bits the magnitude has.
    pub fn bits(&self) -> u64 {
        let leading = self.digits.last().map_or(0, |d| d.leading_zeros());
        32 * self.digits.len() as u64 - u64::from(leading)
    }

    /// How often 2 divides the magnitude; 0 for zero.
    pub fn trailing_zeros(&self) -> u64 {
        let zeros = self.digits.iter().take_while(|&&d| d == 0).count();
        let last = self.digits.get(zeros).map_or(0, |d| d.trailing_zeros());
        32 * zeros.min(self.digits.len().saturating_sub(1)) as u64 + u64::from(last)
    }

    /// Times `2^bits`.
    pub fn shifted_up(&self, bits: u64) -> Self {
        let mut digits = vec![0; (bits / 32) as usize];
        let mut carry = 0;
        for &digit in &self.digits {
            let wide = (u64::from(digit) << (bits % 32)) | carry;
            digits.push(wide as u32);
            carry = wide >> 32;
        }
        digits.push(carry as u32);
        Self::new(self.negative, digits)
    }

    /// Over `2^bits`, which must divide it.
    pub fn shifted_down(&self, bits: u64) -> Self {
        let digits = &self.digits[((bits / 32) as usize).min(self.digits.len())..];
        let shifted = (0..digits.len()).map(|i| {
            let above = digits.get(i + 1).map_or(0, |&d| u64::from(d));
            (((above << 32) | u64::from(digits[i])) >> (bits % 32)) as u32
        });
        Self::new(self.negative, shifted.collect())
    }

    /// The square root, if it is a whole number and not too large to look for, bit by bit.
    pub fn exact_root(&self) -> Option<Self> {
        if self.negative || self.bits() > 512 {
            return None;
        }
        let mut root = Integer::from(0);
        for bit in (0..self.bits().div_ceil(2)).rev() {
            let next = &root + &Integer::from(1).shifted_up(bit);
            if (self - &(&next * &next)).sign() != Ordering::Less {
                root = next;
            }
        }
        (&root * &root == *self).then_some(root)
    }
}

/// The order of two magnitudes.
fn compare(a: &[u32], b: &[u32]) -> Ordering {
    a.len()
        .cmp(&b.len())
        .then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

fn sum(a: &[u32], b: &[u32]) -> Vec<u32> {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let mut carry = 0;
    let mut digits = Vec::with_capacity(long.len() + 1);
    for (i, &digit) in long.iter().enumerate() {
        let other = short.get(i).map_or(0, |&d| u64::from(d));
        carry += u64::from(digit) + other;
        digits.push(carry as u32);
        carry >>= 32;
    }
    digits.push(carry as u32);
    digits
}

/// `a - b`, which must not be negative.
fn difference(a: &[u32], b: &[u32]) -> Vec<u32> {
    let mut borrow = false;
    let subtract = |(i, &digit): (usize, &u32)| {
        let other = b.get(i).map_or(0, |&d| d);
        let (rest, first) = digit.overflowing_sub(other);
        let (rest, second) = rest.overflowing_sub(u32::from(borrow));
        borrow = first || second;
        rest
    };
    a.iter().enumerate().map(subtract).collect()
}

impl Add for &Integer {
    type Output = Integer;

    fn add(self, other: &Integer) -> Integer {
        let (a, b) = (&self.digits, &other.digits);
        if self.negative == other.negative {
            return Integer::new(self.negative, sum(a, b));
        }
        match compare(a, b) {
            Ordering::Less => Integer::new(other.negative, difference(b, a)),
            _ => Integer::new(self.negative, difference(a, b)),
        }
    }
}

impl Sub for &Integer {
    type Output = Integer;

    fn sub(self, other: &Integer) -> Integer {
        self + &-other
    }
}

impl Neg for &Integer {
    type Output = Integer;

    fn neg(self) -> Integer {
        Integer::new(!self.negative, self.digits.clone())
    }
}

impl Mul for &Integer {
    type Output = Integer;

    fn mul(self, other: &Integer) -> Integer {
        let mut digits = vec![0; self.digits.len() + other.digits.len()];
        for (i, &a) in self.digits.iter().enumerate() {
            let mut carry = 0;
            for (digit, &b) in digits[i..].iter_mut().zip(&other.digits) {
                carry += u64::from(*digit) + u64::from(a) * u64::from(b);
                *digit = carry as u32;
                carry >>= 32;
            }
            digits[i + other.digits.len()] = carry as u32;
        }
        Integer::new(self.negative != other.negative, digits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn power(exponent: u64) -> Integer {
        Integer::from(1).shifted_up(exponent)
    }

    #[test]
    fn carries_and_borrows_go_all_the_way() {
        let one = Integer::from(1);
        let all = &power(200) - &one;
        assert_eq!(&all + &one, power(200));
        assert_eq!(&(&all * &all) - &(&power(400) - &power(201)), one);
        assert_eq!((&-&all + &all).sign(), Ordering::Equal);
        assert_eq!((&one - &all).sign(), Ordering::Less);
    }

    #[test]
    fn shifts_undo_each_other() {
        let odd = Integer::from(0x1234_5678_9abc_def1);
        for bits in [0, 1, 31, 32, 33, 64, 100] {
            let shifted = odd.shifted_up(bits);
            assert_eq!(shifted.trailing_zeros(), bits);
            assert_eq!(shifted.bits(), odd.bits() + bits);
            assert_eq!(shifted.shifted_down(bits), odd);
        }
    }

    #[test]
    fn roots_of_squares_alone() {
        let number = Integer::from(u64::MAX);
        let square = &number * &number;
        assert_eq!(square.exact_root(), Some(number));
        assert_eq!((&square + &Integer::from(1)).exact_root(), None);
        assert_eq!((-&square).exact_root(), None);
        assert_eq!(Integer::from(0).exact_root(), Some(Integer::from(0)));
    }
}
