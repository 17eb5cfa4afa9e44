//! How far an answer may be from the truth, and why.

use super::Kernel;
use crate::quality::Quality;

/// An allowed error, of a stated kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowed {
    /// The answer is a decision or a whole number, and right.
    Exact,
    /// The nearest number of the format, ties to even.
    CorrectlyRounded,
    /// At most so many units in the last place of the exact value.
    Ulp(u32),
    /// At most k times the a-priori bound of the case, `u * bound_u * |t|`; and where a decision's margin
    /// is within that bound, either decision.
    Bound(u32),
}

/// An allowed error with its reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precision {
    /// How large it may be.
    pub allowed: Allowed,
    /// Why it is no smaller.
    pub reason: &'static str,
}

/// The error that a kernel may make in a quality and a format (`f32` or `f64`), on every test vector but
/// the [`KNOWN_FAILURES`].
pub fn precision(kernel: Kernel, quality: Quality, _float: &str) -> Precision {
    use Allowed::{Bound, Exact, Ulp};
    let (allowed, reason) = match (kernel, quality) {
        (Kernel::RayPlane, Quality::Textbook | Quality::Stable) => (Bound(1), "b"),
        (Kernel::RayPlane, Quality::Wide) => (Ulp(1), "w"),
        (Kernel::RaySphere, Quality::Textbook | Quality::Stable) => (Bound(3), "b"),
        (Kernel::RaySphere, Quality::Wide) => (Ulp(1), "w"),
        (Kernel::LightSample, _) => (Ulp(3), "l"),
        (Kernel::Shade, _) => (Ulp(1), "s"),
        (Kernel::AnyHit | Kernel::Offset | Kernel::Quantise, _) => (Exact, "e"),
    };
    Precision { allowed, reason }
}

/// Vectors of a family that a kernel is known to fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KnownFailure {
    /// The kernel.
    pub kernel: Kernel,
    /// Its quality.
    pub quality: Quality,
    /// `f32` or `f64`.
    pub float: &'static str,
    /// The family of vectors.
    pub family: &'static str,
    /// Why it fails.
    pub reason: &'static str,
}

/// Every family that fails, by kernel, quality and format.
pub const KNOWN_FAILURES: &[KnownFailure] = &[];
