//! From radiance to bytes (clauses 3.2 and 3.3).

use crate::real::Real;

/// What becomes of radiance above 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Film {
    /// Restricted to [0, 1] before it becomes a byte: Figure 2(b).
    Clamp,
    /// Truncated to an integer, of which the byte keeps the low 8 bits: Figure 2(a).
    Wrap,
}

impl Film {
    /// The byte of one component of radiance, as a whole number from 0 to 255. NaN becomes 0.
    ///
    /// It is `floor(255 x)` of the exact product, not of the rounded one: in `f64` those differ for
    /// 143 of the 256 values k/255. The rounded product may be a whole number w just above the
    /// exact one: where `256 x - w < x`. Both sides are exact: the difference has no more digits
    /// than x (Sterbenz's lemma), or w is the rounded product itself (Dekker's fast two-sum).
    #[inline(always)]
    pub fn byte<R: Real>(self, x: R) -> R {
        let (zero, one) = (x.constant(0.0), x.constant(1.0));
        let x = R::select(x.gt(zero), x, zero);
        let x = match self {
            Film::Clamp => R::select(x.lt(one), x, one),
            Film::Wrap => x,
        };
        let scaled = x * x.constant(256.0);
        let whole = (scaled - x).trunc();
        let rounded_up = (scaled - whole).lt(x);
        let level = R::select(rounded_up, whole - one, whole);
        match self {
            Film::Clamp => level,
            Film::Wrap => {
                let turns = (level * x.constant(1.0 / 256.0)).trunc();
                let byte = level - turns * x.constant(256.0);
                R::select(byte.ge(zero), byte, zero)
            }
        }
    }
}
