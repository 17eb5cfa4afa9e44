//! Rays over an interval, and the three readings of that interval.

use crate::exact::{Rational, Vector, rational, sign, vector};
use crate::surd::Surd;
use std::cmp::Ordering;

/// The points `origin + t direction`; t counts in lengths of the direction, which need not be 1.
#[derive(Clone, Debug)]
pub struct Ray {
    /// Where t is 0.
    pub origin: Vector,
    /// Not zero.
    pub direction: Vector,
    /// The lower end of the interval.
    pub tmin: Rational,
    /// The upper end of the interval; `None` is +∞.
    pub tmax: Option<Rational>,
}

impl Ray {
    /// `None` where policy calls every object missed: a NaN, an infinity other than `tmax = +∞`, a zero direction.
    pub fn new(origin: [f64; 3], direction: [f64; 3], tmin: f64, tmax: f64) -> Option<Ray> {
        let tmax = if tmax == f64::INFINITY {
            None
        } else {
            Some(rational(tmax)?)
        };
        let direction = vector(direction).filter(|d| d.iter().any(|x| sign(x) != 0))?;
        Some(Ray {
            origin: vector(origin)?,
            direction,
            tmin: rational(tmin)?,
            tmax,
        })
    }

    /// The point at `t`.
    pub fn at(&self, t: &Surd) -> [Surd; 3] {
        std::array::from_fn(|i| &Surd::from(self.origin[i].clone()) + &t.scale(&self.direction[i]))
    }

    /// Whether `t` lies in the interval of this ray, read as `interval`.
    pub fn admits(&self, t: &Surd, interval: Interval) -> bool {
        let lower = t.compare(&Surd::from(self.tmin.clone()));
        let upper = self
            .tmax
            .as_ref()
            .map_or(Ordering::Less, |tmax| t.compare(&Surd::from(tmax.clone())));
        match interval {
            Interval::Closed => lower.is_ge() && upper.is_le(),
            Interval::Half => lower.is_gt() && upper.is_le(),
            Interval::Open => lower.is_gt() && upper.is_lt(),
        }
    }
}

/// How the ends of an interval count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interval {
    /// `[tmin, tmax]`
    Closed,
    /// `(tmin, tmax]`
    Half,
    /// `(tmin, tmax)`
    Open,
}

/// One answer for each reading of the interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PerInterval<T> {
    /// Over `[tmin, tmax]`.
    pub closed: T,
    /// Over `(tmin, tmax]`.
    pub half: T,
    /// Over `(tmin, tmax)`.
    pub open: T,
}

impl<T> PerInterval<T> {
    /// The answer of `answer` for each reading.
    pub fn of(mut answer: impl FnMut(Interval) -> T) -> Self {
        PerInterval {
            closed: answer(Interval::Closed),
            half: answer(Interval::Half),
            open: answer(Interval::Open),
        }
    }

    /// The answers turned into others.
    pub fn map<U>(&self, change: impl Fn(&T) -> U) -> PerInterval<U> {
        PerInterval {
            closed: change(&self.closed),
            half: change(&self.half),
            open: change(&self.open),
        }
    }
}
