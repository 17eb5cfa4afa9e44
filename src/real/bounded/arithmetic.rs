//! The kernels' words for bounded numbers, each with the proof of its bound.
//!
//! In the proofs A is the exact number that `a` stands for, `a` also its value and e its bound, u
//! the format's relative error. They hold with an allowance δ on every e, as the module above
//! explains; where a bound multiplies two bounds, or divides by one, what the allowances add is
//! covered by the constant named there.

use super::{Bounded, Kleene, Proof, Rounded};
use crate::real::{Constant, Real};
use crate::vector::Triple;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The largest relative error that quotients and roots are given a bound for.
const MOST_RELATIVE: f64 = 1.0 / 64.0;

/// What a sabotaged proof makes of a bound.
#[inline(always)]
fn times<B: Real>(error: B, factor: f64) -> B {
    if factor == 1.0 {
        error
    } else {
        error * error.constant(factor)
    }
}

/// The sum of the magnitudes.
#[inline(always)]
fn size<B: Real>([x, y, z]: [B; 3]) -> B {
    x.abs() + y.abs() + z.abs()
}

impl<B: Real<Scalar: Rounded>, P: Proof> Bounded<B, P> {
    /// This number, but unknown where its value, or its bound, is one for which the format's errors
    /// are not known. Costs nothing for `f32` and `f64`.
    #[inline(always)]
    fn within_limits(self) -> Self {
        let Some([least, most]) = B::Scalar::LIMITS else {
            return self;
        };
        let magnitude = self.value.abs();
        let [zero, least, most] = [0.0, least, most].map(|x| magnitude.constant(x));
        let large_enough = magnitude.ge(least) | magnitude.le(zero);
        self.only_where(large_enough & magnitude.le(most) & self.error.le(most))
    }

    /// What the product with another number adds to the bound of a sum of products, of which it
    /// goes through `sums` sums; η is not included.
    #[inline(always)]
    fn share(self, other: Self, sums: f64) -> B {
        let magnitude = other.value.abs();
        let rounding = 1.01 * (B::Scalar::PRODUCT + sums * B::Scalar::SUM);
        let rounding = magnitude * magnitude.constant(rounding);
        let eta = magnitude.constant(B::Scalar::ETA);
        let of_other = self.value.abs() * (other.error + (rounding + eta));
        of_other + (magnitude + (other.error + other.error)) * self.error
    }

    /// The same for the square, without its rounding.
    #[inline(always)]
    fn own_share(self) -> B {
        let twice = self.error + self.error;
        (self.value.abs() + twice) * twice
    }

    /// Where the number is 0 and nothing else.
    #[inline(always)]
    fn is_zero(self) -> B::Mask {
        let zero = self.value.constant(0.0);
        self.value.ge(zero) & self.value.le(zero) & self.error.le(zero)
    }
}

/// `|(A + B) - fl(a + b)| <= e_a + e_b + u |fl(a + b)|`.
impl<B: Real<Scalar: Rounded>, P: Proof> Add for Bounded<B, P> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        let rounding = value.abs() * value.constant(B::Scalar::SUM);
        Self::new(value, times(self.error + other.error + rounding, P::SUM))
    }
}

/// As the sum: the negative of a number is exact.
impl<B: Real<Scalar: Rounded>, P: Proof> Sub for Bounded<B, P> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let value = self.value - other.value;
        let rounding = value.abs() * value.constant(B::Scalar::SUM);
        Self::new(value, times(self.error + other.error + rounding, P::SUM))
    }
}

/// With A = a + α and B = b + β it is `A B - a b = a β + (b + β) α`, so
///
/// ```text
/// |A B - fl(a b)| <= |a| e_b + (|b| + e_b) e_a + u |a b| + η
///                 <= |a| (e_b + u |b|) + (|b| + 2 e_b) e_a + η.
/// ```
///
/// The second `e_b` is for the allowance on the product of two bounds: `(1 + δ)² e_b e_a` is below
/// `(1 + δ) 2 e_b e_a`. Where they underflow, the two products of the bound and that of the values
/// lose at most half of the smallest number each, together less than η; so does u |b|, which is
/// multiplied by |a| and therefore has an η of its own.
///
/// Double-double keeps zeros exact: there the product of an exact 0 and a known number is one.
impl<B: Real<Scalar: Rounded>, P: Proof> Mul for Bounded<B, P> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.within_limits(), other.within_limits());
        let magnitude = b.value.abs();
        let eta = magnitude.constant(B::Scalar::ETA);
        let rounding = magnitude * magnitude.constant(B::Scalar::PRODUCT) + eta;
        let of_b = a.value.abs() * (b.error + rounding);
        let of_a = (magnitude + (b.error + b.error)) * a.error;
        let error = of_b + of_a + eta;
        let error = if B::Scalar::LIMITS.is_some() {
            let zero = magnitude.constant(0.0);
            B::select((a.is_zero() | b.is_zero()) & error.ge(zero), zero, error)
        } else {
            error
        };
        Self::new(a.value * b.value, times(error, P::PRODUCT))
    }
}

/// With `x = e_b / |b|` at most 1/64,
///
/// ```text
/// |A/B - a/b| <= (E_a + |a/b| E_b) / |B| <= 1/(1 - x) (e_a / |b| + |a/b| x),
/// ```
///
/// and 1/(1 - x) is below 1.0161, the allowance on x included. 1.02 leaves a part in 300 for the
/// four roundings of the terms; the reciprocal, which may underflow, is off by at most 2^-22 of
/// itself even then. Where x is larger the bound is undefined: so is a quotient by zero. The
/// quotient itself has to be within the format's limits too: its remainder is found by a product.
impl<B: Real<Scalar: Rounded>, P: Proof> Div for Bounded<B, P> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let (a, b) = (self.within_limits(), other.within_limits());
        let value = a.value / b.value;
        let one = value.constant(1.0);
        let magnitude = value.abs();
        let reciprocal = (one / b.value).abs();
        let relative = b.error * reciprocal;
        let inherited = (a.error * reciprocal + magnitude * relative) * one.constant(1.02);
        let rounding = magnitude * one.constant(B::Scalar::QUOTIENT);
        let error = inherited + rounding + one.constant(B::Scalar::ETA);
        Self::new(value, times(error, P::QUOTIENT))
            .within_limits()
            .only_where(relative.le(one.constant(MOST_RELATIVE)))
    }
}

impl<B: Real<Scalar: Rounded>, P: Proof> Neg for Bounded<B, P> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.value, self.error)
    }
}

impl<B: Real<Scalar: Rounded>, P: Proof> Real for Bounded<B, P> {
    type Scalar = Bounded<B::Scalar, P>;
    type Mask = Kleene<B::Mask>;
    type Vector = Triple<Self>;
    type Token = B::Token;

    #[inline(always)]
    fn token(self) -> B::Token {
        self.value.token()
    }

    #[inline(always)]
    fn splat(token: B::Token, value: Self::Scalar) -> Self {
        Self::new(B::splat(token, value.value), B::splat(token, value.error))
    }

    #[inline(always)]
    fn never(token: B::Token) -> Self::Mask {
        let never = B::never(token);
        Kleene {
            certain: never,
            possible: never,
        }
    }

    /// With e/a at most 1/64,
    ///
    /// ```text
    /// |√A - √a| = |A - a| / (√A + √a) <= E / (√a (1 + √(1 - E/a))) <= 0.5021 E / √a.
    /// ```
    ///
    /// 0.51 leaves a part in 64 for the roundings. Where e/a is larger, or the number is 0 or less,
    /// the bound is undefined.
    #[inline(always)]
    fn sqrt(self) -> Self {
        let a = self.within_limits();
        let root = a.value.sqrt();
        let inherited = a.error / root * root.constant(0.51);
        let error = inherited + root * root.constant(B::Scalar::ROOT);
        let relative = a.error * root.constant(1.0 / MOST_RELATIVE);
        Self::new(root, times(error, P::ROOT)).only_where(relative.le(a.value))
    }

    /// Known where every number within the bound has the same integer part: it then is exact.
    #[inline(always)]
    fn trunc(self) -> Self {
        let (zero, one) = (self.value.constant(0.0), self.value.constant(1.0));
        let (magnitude, reach) = (self.value.abs(), self.reach());
        let whole = magnitude.trunc();
        let above = magnitude - whole;
        let same = above.ge(reach) & (one - above).gt(reach);
        let none = (magnitude + reach).lt(one);
        Self::new(self.value.trunc(), zero).only_where(same | none)
    }

    /// Unknown: a number has no places, only its value has.
    #[inline(always)]
    fn step(self, count: Self) -> Self {
        let value = self.value.step(count.value);
        Self::new(value, value.constant(f64::NAN))
    }

    /// Known where every number within the bound has the same leading bit.
    #[inline(always)]
    fn binade(self) -> Self {
        let (magnitude, reach) = (self.value.abs(), self.reach());
        let binade = magnitude.binade();
        let same = (magnitude - reach).ge(binade) & (magnitude + reach).lt(binade + binade);
        Self::exact(binade).only_where(same)
    }

    /// `A < B` certainly where b - a is larger than both bounds together, certainly not where it is
    /// not above their negative. No number is above an infinite bound, and the sum with one is
    /// undefined or infinite itself, so that an infinite bound decides nothing.
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        let zero = self.value.constant(0.0);
        let way = other.value - self.value;
        if P::COMPARES_VALUES {
            let certain = way.gt(zero);
            let possible = certain;
            return Kleene { certain, possible };
        }
        let doubt = Self::new(way, self.error + other.error).reach();
        Kleene {
            certain: way.gt(doubt),
            possible: !(way + doubt).le(zero),
        }
    }

    /// As `lt`; certainly also where the two are equal and known exactly.
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        let zero = self.value.constant(0.0);
        let way = other.value - self.value;
        if P::COMPARES_VALUES {
            let certain = way.ge(zero);
            let possible = certain;
            return Kleene { certain, possible };
        }
        let doubt = Self::new(way, self.error + other.error).reach();
        Kleene {
            certain: (way - doubt).ge(zero),
            possible: !(way + doubt).lt(zero),
        }
    }

    /// Unknown where the choice is not certain.
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        let value = B::select(mask.possible, yes.value, no.value);
        let error = B::select(mask.possible, yes.error, no.error);
        let chosen = Self::new(value, error);
        if P::CHOOSES_POSSIBLE {
            return chosen;
        }
        chosen.only_where(mask.decided())
    }

    /// Unknown: what a function of plain numbers does is not known of their bounds.
    #[inline(always)]
    fn each<const N: usize>(
        inputs: [Self; N],
        _: impl Fn([Self::Scalar; N]) -> Self::Scalar,
    ) -> Self {
        let value = inputs[0].value;
        Self::new(value, value.constant(f64::NAN))
    }

    /// Certain only of numbers that are known exactly.
    #[inline(always)]
    fn is(self, other: Self) -> Self::Mask {
        let equal = self.value.is(other.value);
        let exact = (self.error + other.error).le(self.error.constant(0.0));
        Kleene {
            certain: equal & exact,
            possible: equal | !exact,
        }
    }

    /// With x = e/a at most 1/64, and X the same with its allowance,
    ///
    /// ```text
    /// |1/√A - 1/√a| <= 1/√a X/2 (1 - X)^(-3/2) <= 0.5121 X / √a,
    /// ```
    ///
    /// and the roundings of the quotient, halved, and of the root come to `0.5 Q + R`. 0.514 and
    /// 1.02 leave room for the roundings of the bound. A reciprocal that underflows is not known.
    #[inline(always)]
    fn inverse_root(self) -> Self {
        if B::Scalar::LIMITS.is_some() {
            return (self.constant(1.0) / self).sqrt();
        }
        let one = self.value.constant(1.0);
        let reciprocal = one / self.value;
        let root = reciprocal.sqrt();
        let relative = self.error * reciprocal;
        let rounding = 1.02 * (0.5 * B::Scalar::QUOTIENT + B::Scalar::ROOT);
        let error = root * (relative * one.constant(0.514) + one.constant(rounding));
        let normal = reciprocal.ge(one.constant(B::Scalar::MIN_POSITIVE));
        Self::new(root, times(error, P::ROOT))
            .only_where(normal & relative.le(one.constant(MOST_RELATIVE)))
    }

    /// As three products and two sums, but the roundings of the sums are taken as parts of the
    /// products': `|fl(Σ a b) - Σ a b| <= 1.01 (p + 2 s) Σ |a b|`, with p and s the relative errors
    /// of a product and a sum (Higham, equation 3.5).
    #[inline(always)]
    fn sum_of_products([x, y, z]: [Self; 3], [u, v, w]: [Self; 3]) -> Self {
        if B::Scalar::LIMITS.is_some() {
            return x * u + y * v + z * w;
        }
        let value = B::sum_of_products([x.value, y.value, z.value], [u.value, v.value, w.value]);
        let error = x.share(u, 2.0) + y.share(v, 2.0) + z.share(w, 2.0);
        let eta = value.constant(B::Scalar::ETA);
        Self::new(value, times(error + eta, P::PRODUCT))
    }

    /// With k = |a| + 2 e, `|A² - a²| <= 2 e k`, the allowance included; the sum of squares is not
    /// negative, so the roundings are a part of it.
    #[inline(always)]
    fn sum_of_squares([x, y, z]: [Self; 3]) -> Self {
        if B::Scalar::LIMITS.is_some() {
            return x * x + y * y + z * z;
        }
        let value = B::sum_of_squares([x.value, y.value, z.value]);
        let [x, y, z] = [x.own_share(), y.own_share(), z.own_share()];
        let rounding = 1.02 * (B::Scalar::PRODUCT + 2.0 * B::Scalar::SUM);
        let rounding = value * value.constant(rounding);
        let eta = value.constant(B::Scalar::ETA);
        Self::new(value, times(x + y + z + rounding + eta, P::PRODUCT))
    }

    /// As `sum_of_products`, of two.
    #[inline(always)]
    fn difference_of_products([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        if B::Scalar::LIMITS.is_some() {
            return a * b - c * d;
        }
        let value = B::difference_of_products([a.value, b.value], [c.value, d.value]);
        let error = a.share(b, 1.0) + c.share(d, 1.0);
        let eta = value.constant(B::Scalar::ETA);
        Self::new(value, times(error + eta, P::PRODUCT))
    }

    /// With |a| for the sum of the magnitudes and e for that of the bounds of a vector, and
    ///
    /// ```text
    /// d = |a| e_b + (|b| + 2 e_b) e_a + 1.01 (p + 2 s) |a| |b| + η,
    /// ```
    ///
    /// the scalar product is off by d at most. So are the three components of the vector product m
    /// together: every product of components of a and b is in one of the two. As
    /// `M² - m² = (M - m) · (M + m)`, the square is off by `d (2 |m| + d)`, where `2 d (|m| + d)` covers
    /// the allowance, and by its own roundings.
    #[inline(always)]
    fn products(a: [Self; 3], b: [Self; 3]) -> (Self, Self) {
        let [[x, y, z], [u, v, w]] = [a, b];
        if B::Scalar::LIMITS.is_some() {
            let m = [y * w - z * v, z * u - x * w, x * v - y * u];
            return (Self::sum_of_products(a, b), Self::sum_of_squares(m));
        }
        let m = [
            B::difference_of_products([y.value, w.value], [z.value, v.value]),
            B::difference_of_products([z.value, u.value], [x.value, w.value]),
            B::difference_of_products([x.value, v.value], [y.value, u.value]),
        ];
        let square = B::sum_of_squares(m);
        let scalar = B::sum_of_products([x.value, y.value, z.value], [u.value, v.value, w.value]);
        let eta = square.constant(B::Scalar::ETA);
        let rounding = B::Scalar::PRODUCT + 2.0 * B::Scalar::SUM;
        let error_a = x.error + y.error + z.error;
        let error_b = u.error + v.error + w.error;
        let size_a = size([x.value, y.value, z.value]);
        let size_b = size([u.value, v.value, w.value]);
        let of_b = size_a * (error_b + (size_b * eta.constant(1.01 * rounding) + eta));
        let error = of_b + (size_b + (error_b + error_b)) * error_a + eta;
        let of_square = (size(m) + error) * (error + error);
        let of_square = of_square + square * eta.constant(1.02 * rounding) + eta;
        (
            Self::new(scalar, times(error, P::PRODUCT)),
            Self::new(square, times(of_square, P::PRODUCT)),
        )
    }

    /// As near to the exact magnitude as the value is to the exact number.
    #[inline(always)]
    fn abs(self) -> Self {
        Self::new(self.value.abs(), self.error)
    }
}
