//! How well a kernel computes: three qualities of the same formulas.

use crate::real::{Constant, Real, Scalar};
use crate::vector::Vector;

/// How well the kernels compute. The error of each is in `docs/precision.md`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quality {
    /// What the lab's readers write: b² - 4ac for the sphere, power / d² for the light. The figures
    /// use it. It has no error bound: near tangency, far from the origin, or for a small sphere far
    /// away it misses hits and finds false ones.
    Textbook,
    /// The forms without avoidable cancellation: the sphere's residual discriminant, scaled light
    /// samples. It has an error bound and costs little more.
    #[default]
    Stable,
    /// The stable forms one precision up, scaled by powers of two and rounded once: `f32` in `f64`,
    /// `f64` in double-double. Right to the last place or nearly so, also where the others fail.
    Wide,
}

impl Quality {
    /// All qualities, the plainest first.
    pub const ALL: [Quality; 3] = [Quality::Textbook, Quality::Stable, Quality::Wide];

    /// The name, as options and tables give it.
    pub fn name(self) -> &'static str {
        match self {
            Quality::Textbook => "textbook",
            Quality::Stable => "stable",
            Quality::Wide => "wide",
        }
    }

    /// The quality of this name.
    pub fn named(name: &str) -> Option<Quality> {
        Self::ALL.into_iter().find(|quality| quality.name() == name)
    }
}

/// A power of two, and its reciprocal: a change of scale that rounds nothing, as long as no result
/// falls below the smallest normal number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale<R> {
    /// The power of two: never 0.
    pub unit: R,
    /// Its reciprocal: never infinite.
    pub reciprocal: R,
}

impl<R: Real> Scale<R> {
    /// The scale in which the largest of these magnitudes lies between 1 and 2; smaller, where that
    /// is below the smallest normal number.
    #[inline(always)]
    pub fn of(magnitudes: [R; 4]) -> Self {
        let larger = |a: R, b: R| R::select(a.lt(b), b, a);
        let [a, b, c, d] = magnitudes;
        let binade = larger(larger(a.abs(), b.abs()), larger(c.abs(), d.abs())).binade();
        let unit = larger(binade, a.constant(R::Scalar::MIN_POSITIVE));
        Self {
            unit,
            reciprocal: a.constant(1.0) / unit,
        }
    }

    /// The scale of a vector.
    #[inline(always)]
    pub fn of_vector(vector: R::Vector) -> Self {
        Self::of([vector.x(), vector.y(), vector.z(), vector.z()])
    }
}

/// The unit vector of the same direction, whatever the length; not finite for the zero vector.
pub(crate) fn unit<S: Scalar>(vector: S::Vector) -> S::Vector {
    (vector * Scale::<S>::of_vector(vector).reciprocal).normalized()
}
