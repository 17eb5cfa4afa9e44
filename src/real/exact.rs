//! Numbers that are exact: sums, products, quotients and square roots of floats.
//!
//! An [`Exact`] number remembers how it was made. It also is a double-double with its bound, which
//! decides nearly everything; only where that leaves a comparison open, the numbers compared are
//! computed exactly, in a tower of fields ([`surd`]).

mod integer;
mod surd;

use super::bounded::{Bounded, Kleene};
use super::{Constant, DoubleDouble, Precise, Real};
use crate::vector::Triple;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::rc::Rc;
use surd::Surd;

/// An exact number of this thread, or one of which only a double-double is known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exact(u32);

/// How a number was made.
#[derive(Clone, Copy, Debug)]
enum Origin {
    Float(f64),
    Sum(Exact, Exact),
    Product(Exact, Exact),
    Quotient(Exact, Exact),
    Root(Exact),
    /// Not by the operations of a field, or by a choice that nothing decides.
    Unknown,
}

struct Node {
    origin: Origin,
    near: Bounded<DoubleDouble>,
    /// The number in the tower, once it was asked for: `None` inside where it cannot be had.
    exact: Option<Option<Rc<Surd>>>,
}

/// The numbers of this thread, each after those it is made of.
#[derive(Default)]
struct Numbers {
    nodes: Vec<Node>,
    floors: usize,
}

thread_local! {
    static NUMBERS: RefCell<Numbers> = RefCell::default();
}

/// The most bits of a number, and the most roots in a row, that are computed with.
const MOST_BITS: u64 = 1 << 17;
const MOST_FLOORS: usize = 8;

/// Does some work, and then forgets the numbers that it made.
pub(crate) fn forgetting<T>(work: impl FnOnce() -> T) -> T {
    let (nodes, floors) = NUMBERS.with_borrow(|numbers| (numbers.nodes.len(), numbers.floors));
    let result = work();
    NUMBERS.with_borrow_mut(|numbers| {
        numbers.nodes.truncate(nodes);
        numbers.floors = floors;
        // What was computed meanwhile may stand on floors that are gone.
        numbers.nodes.iter_mut().for_each(|node| node.exact = None);
    });
    result
}

impl Numbers {
    fn exact(&mut self, Exact(index): Exact) -> Option<Rc<Surd>> {
        let node = &self.nodes[index as usize];
        if let Some(known) = &node.exact {
            return known.clone();
        }
        let exact = self.compute(node.origin);
        let exact = exact.filter(|x| surd::bits(x) <= MOST_BITS && self.floors <= MOST_FLOORS);
        self.nodes[index as usize].exact = Some(exact.clone());
        exact
    }

    fn compute(&mut self, origin: Origin) -> Option<Rc<Surd>> {
        match origin {
            Origin::Float(x) => x.is_finite().then(|| surd::float(x)),
            Origin::Sum(a, b) => Some(surd::add(&self.exact(a)?, &self.exact(b)?)),
            Origin::Product(a, b) => match (self.exact(a), self.exact(b)) {
                (Some(zero), None) | (None, Some(zero)) => {
                    (surd::sign(&zero) == Ordering::Equal).then_some(zero)
                }
                (a, b) => Some(surd::multiply(&a?, &b?)),
            },
            Origin::Quotient(a, b) => {
                let inverse = surd::reciprocal(&self.exact(b)?)?;
                Some(surd::multiply(&self.exact(a)?, &inverse))
            }
            Origin::Root(a) => {
                let square = self.exact(a)?;
                surd::root(&square, &mut self.floors)
            }
            Origin::Unknown => None,
        }
    }
}

impl Exact {
    fn new(origin: Origin, near: Bounded<DoubleDouble>) -> Self {
        NUMBERS.with_borrow_mut(|numbers| {
            let node = Node {
                origin,
                near,
                exact: None,
            };
            numbers.nodes.push(node);
            Exact(numbers.nodes.len() as u32 - 1)
        })
    }

    /// The number as a double-double with its bound.
    pub(crate) fn bounded(self) -> Bounded<DoubleDouble> {
        NUMBERS.with_borrow(|numbers| numbers.nodes[self.0 as usize].near)
    }

    /// The sign of a number that its bound leaves open. One that is 0 is known to be from then on.
    fn sign(self) -> Option<Ordering> {
        NUMBERS.with_borrow_mut(|numbers| {
            let sign = surd::sign(&*numbers.exact(self)?);
            if sign == Ordering::Equal {
                numbers.nodes[self.0 as usize].near = Bounded::from_f64(0.0);
            }
            Some(sign)
        })
    }

    /// The answer of a comparison of two numbers, and if their bounds leave it open, by the sign of
    /// `other - self`.
    fn compare(
        self,
        other: Self,
        near: Kleene<bool>,
        holds: impl FnOnce(Ordering) -> bool,
    ) -> Kleene<bool> {
        if near.decided() {
            return near;
        }
        let is_zero = |x: Bounded<DoubleDouble>| x.value.high() == 0.0 && x.error.high() == 0.0;
        let sign = if is_zero(other.bounded()) {
            self.sign().map(Ordering::reverse)
        } else if is_zero(self.bounded()) {
            other.sign()
        } else {
            (other - self).sign()
        };
        let answer = sign.map(holds);
        Kleene {
            certain: answer == Some(true),
            possible: answer != Some(false),
        }
    }
}

impl Add for Exact {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(Origin::Sum(self, other), self.bounded() + other.bounded())
    }
}

impl Sub for Exact {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Exact {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::new(
            Origin::Product(self, other),
            self.bounded() * other.bounded(),
        )
    }
}

impl Div for Exact {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self::new(
            Origin::Quotient(self, other),
            self.bounded() / other.bounded(),
        )
    }
}

impl Neg for Exact {
    type Output = Self;

    fn neg(self) -> Self {
        let minus_one = Self::from_f64(-1.0);
        Self::new(Origin::Product(minus_one, self), -self.bounded())
    }
}

impl Real for Exact {
    type Scalar = Self;
    type Mask = Kleene<bool>;
    type Vector = Triple<Self>;
    type Token = ();

    fn token(self) {}

    fn splat((): (), value: Self) -> Self {
        value
    }

    fn never((): ()) -> Kleene<bool> {
        Bounded::<DoubleDouble>::never(())
    }

    fn sqrt(self) -> Self {
        let square = self.bounded();
        let is_zero = square.value.high() == 0.0 && square.error.high() == 0.0;
        let root = if is_zero { square } else { square.sqrt() };
        Self::new(Origin::Root(self), root)
    }

    fn trunc(self) -> Self {
        Self::new(Origin::Unknown, self.bounded().trunc())
    }

    fn step(self, count: Self) -> Self {
        Self::new(Origin::Unknown, self.bounded().step(count.bounded()))
    }

    fn binade(self) -> Self {
        Self::new(Origin::Unknown, self.bounded().binade())
    }

    fn lt(self, other: Self) -> Kleene<bool> {
        let near = self.bounded().lt(other.bounded());
        self.compare(other, near, Ordering::is_gt)
    }

    fn le(self, other: Self) -> Kleene<bool> {
        let near = self.bounded().le(other.bounded());
        self.compare(other, near, Ordering::is_ge)
    }

    fn select(mask: Kleene<bool>, yes: Self, no: Self) -> Self {
        match (mask.certain, mask.possible) {
            (true, _) => yes,
            (_, false) => no,
            _ => {
                let open = Bounded::select(mask, yes.bounded(), no.bounded());
                Self::new(Origin::Unknown, open)
            }
        }
    }

    fn each<const N: usize>(inputs: [Self; N], f: impl Fn([Self; N]) -> Self) -> Self {
        f(inputs)
    }
}

impl Constant for Exact {
    const EPSILON: f64 = DoubleDouble::EPSILON;
    const MIN_POSITIVE: f64 = DoubleDouble::MIN_POSITIVE;

    fn from_f64(value: f64) -> Self {
        Self::new(Origin::Float(value), Bounded::from_f64(value))
    }
}

impl Precise for Exact {
    fn near(self) -> f64 {
        self.bounded().near()
    }

    /// Exact for the angles whose tangents square roots can give; a double-double for others.
    fn half_tangent(degrees: f64) -> Self {
        let [one, two, three] = [1.0, 2.0, 3.0].map(Self::from_f64);
        match degrees {
            30.0 => two - three.sqrt(),
            45.0 => two.sqrt() - one,
            60.0 => one / three.sqrt(),
            90.0 => one,
            120.0 => three.sqrt(),
            135.0 => one + two.sqrt(),
            150.0 => two + three.sqrt(),
            _ => Self::new(Origin::Unknown, Bounded::half_tangent(degrees)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn float(x: f64) -> Exact {
        Exact::from_f64(x)
    }

    fn root(x: f64) -> Exact {
        float(x).sqrt()
    }

    /// Two numbers are certainly the same, however they are asked.
    fn are_same(a: Exact, b: Exact) -> bool {
        let all = a.le(b) & b.le(a) & !a.lt(b) & !b.lt(a);
        all.certain
    }

    /// `tan 2x (1 - tan² x) = 2 tan x`, and angles that make up a right one.
    #[test]
    fn tangents_of_some_angles_are_exact() {
        let tangent = Exact::half_tangent;
        let one = float(1.0);
        for (half, whole) in [(30.0, 60.0), (45.0, 90.0), (60.0, 120.0)] {
            let same = || {
                let (t, double) = (tangent(half), tangent(whole));
                are_same(double * (one - t * t), t + t)
            };
            assert!(forgetting(same), "{half}");
        }
        for (a, b) in [(30.0, 150.0), (45.0, 135.0), (60.0, 120.0), (90.0, 90.0)] {
            let same = || are_same(tangent(a) * tangent(b), one);
            assert!(forgetting(same), "{a} and {b}");
        }
        for degrees in [30.0, 45.0, 60.0, 90.0, 120.0, 135.0, 150.0, 77.0] {
            let near = DoubleDouble::half_tangent(degrees).near();
            assert!(
                (tangent(degrees).near() / near - 1.0).abs() < 1e-15,
                "{degrees}"
            );
        }
        assert!(!tangent(77.0).is(tangent(77.0) + float(0.0)).decided());
    }

    #[test]
    fn nothing_of_what_is_unknown_is_nothing() {
        let unknown = Exact::half_tangent(77.0);
        let zero = root(2.0) * root(3.0) - root(6.0);
        assert!(are_same(zero * unknown, float(0.0)));
        assert!(are_same(unknown * zero, float(0.0)));
        let product = unknown * root(2.0);
        assert!(!product.is(product + float(0.0)).decided());
    }

    #[test]
    fn equal_numbers_are_told_however_they_are_made() {
        let (two, three, six) = (root(2.0), root(3.0), root(6.0));
        assert!(are_same(two * three, six));
        assert!(are_same(three * two, six));
        assert!(are_same(-(two * three), -six));
        assert!(are_same(two + three - two, three));
        assert!(are_same(six / two - three, float(0.0)));
        assert!(are_same(float(0.0), six / two - three));
        assert!((-two).lt(float(0.0)).certain && (-two).near() < 0.0);
        // Roots of different floors, in either order.
        let nested = (float(5.0) + six + six).sqrt();
        assert!(are_same(nested, two + three) && are_same(three + two, nested));
        assert!(are_same(nested + two, two + nested));
        assert!(are_same(nested * two, two * nested));
    }

    /// A number that differs where no double-double sees it.
    #[test]
    fn nearly_equal_numbers_are_told() {
        let tiny = float(1e-200);
        for a in [float(1.0), root(2.0), root(2.0) * root(3.0)] {
            assert!(a.lt(a + tiny).certain && (a - tiny).lt(a).certain);
            assert!(!(a + tiny).le(a).possible);
        }
    }

    #[test]
    fn too_many_roots_in_a_row_stay_open() {
        let nested = |floors: usize| (0..floors).fold(float(2.0), |x, _| (x + root(2.0)).sqrt());
        let is_told = |floors| {
            forgetting(|| {
                let x = nested(floors);
                let square = x * x;
                let same = nested(floors - 1) + root(2.0);
                square.le(same).decided()
            })
        };
        assert!(is_told(2));
        assert!(!is_told(MOST_FLOORS + 2));
    }
}
