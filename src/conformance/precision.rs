//! How far an answer may be from the truth, and why.

use super::Kernel;
use crate::quality::Quality;
use std::fmt;

/// An allowed error, of a stated kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowed {
    /// The answer is a decision or a whole number, and right.
    Exact,
    /// The nearest number of the format, ties to even.
    CorrectlyRounded,
    /// At most so many units in the last place of the exact value; every decision is right.
    Ulp(u32),
    /// At most k times the a-priori bound of the case, `u * bound_u * |t|`, where it has one. A
    /// decision whose margin is within three of those bounds may fall either way.
    Bound(u32),
    /// Every byte is at most so far off, and black is where black should be.
    Bytes(u8),
}

/// An allowed error with its reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precision {
    /// How large it may be.
    pub allowed: Allowed,
    /// Why it is no smaller.
    pub reason: &'static str,
}

impl fmt::Display for Allowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Allowed::Exact => f.write_str("exact"),
            Allowed::CorrectlyRounded => f.write_str("correctly rounded"),
            Allowed::Ulp(n) => write!(f, "{n} ulp"),
            Allowed::Bound(k) => write!(f, "{k} u B"),
            Allowed::Bytes(n) => write!(f, "{n} of 255"),
        }
    }
}

const QUOTIENT: &str = "three differences, two products of three terms and a quotient, in the format \
    itself: B = 4 κ_num + 3 κ_den + 1";
const NO_PROMISE: &str = "b² - 4ac cancels, so there is no promise to keep; what passes here passes by \
    luck, and the known failures are long";
const RESIDUAL: &str = "the residual discriminant and Vieta's second root, in the format itself: at \
    most 9 roundings in a row where nothing cancels, and less on these cases";
const ONE_UP: &str = "exact decisions; one precision up for the number, which is then rounded once: \
    half a unit and what is left of the wider error";
const DECISION: &str = "one truth value; any error is the wrong answer";
const SQUARE: &str = "1 rounding each of the three differences, 3 of the square, then a quotient or a \
    root and the products";
const SCALED: &str = "as textbook, and 2 more products for the halves of colour times power, without \
    which the radiance overflows before its time";
const DOUBLE_DOUBLE: &str = "in double-double to about 2^-90, then rounded; f32 is rounded twice, and no \
    proof says that the first is far from a tie";
const SIDE: &str = "decided in exact arithmetic";
const BYTE: &str = "a whole number, by the exact product 255 x";

/// The error that a kernel may make in a quality and a format (`f32` or `f64`), on every test
/// vector but those of the [`KNOWN_FAILURES`].
pub fn precision(kernel: Kernel, quality: Quality, float: &str) -> Precision {
    use Allowed::{Bound, Exact, Ulp};
    let (allowed, reason) = match (kernel, quality, float) {
        (Kernel::RayPlane, Quality::Textbook | Quality::Stable, _) => (Bound(1), QUOTIENT),
        (Kernel::RaySphere, Quality::Textbook, _) => (Bound(3), NO_PROMISE),
        (Kernel::RaySphere, Quality::Stable, "f32") => (Bound(1), RESIDUAL),
        (Kernel::RaySphere, Quality::Stable, _) => (Bound(2), RESIDUAL),
        (Kernel::RayPlane | Kernel::RaySphere, Quality::Wide, _) => (Ulp(1), ONE_UP),
        (Kernel::AnyHit, _, _) => (Exact, DECISION),
        (Kernel::LightSample, Quality::Textbook, _) => (Ulp(2), SQUARE),
        (Kernel::LightSample, Quality::Stable | Quality::Wide, _) => (Ulp(3), SCALED),
        (Kernel::Shade, _, _) => (Ulp(1), DOUBLE_DOUBLE),
        (Kernel::Offset, _, _) => (Exact, SIDE),
        (Kernel::Quantise, _, _) => (Exact, BYTE),
    };
    Precision { allowed, reason }
}

const EACH_SURFACE: &str = "one truth value, within what the nearest hit of each surface promises";
const SEVEN: &str = "1 rounding each of the differences, 3 of the square, then 3 more at most";
const VISIBLE: &str = "what can be seen: a value next to a whole number may round to either side";

/// The error that any kernel can keep, computed with care in the format itself, whatever the order
/// of its operations: what a stranger's kernels are held to. Without the known failures.
pub fn promise(kernel: Kernel) -> Precision {
    use Allowed::{Bound, Bytes, Exact, Ulp};
    let (allowed, reason) = match kernel {
        Kernel::RayPlane => (Bound(1), QUOTIENT),
        Kernel::RaySphere => (Bound(3), RESIDUAL),
        Kernel::AnyHit => (Bound(3), EACH_SURFACE),
        Kernel::LightSample => (Ulp(7), SEVEN),
        Kernel::Shade => (Bytes(1), VISIBLE),
        Kernel::Offset => (Exact, SIDE),
        Kernel::Quantise => (Exact, BYTE),
    };
    Precision { allowed, reason }
}

/// Families of vectors that a kernel is known to fail: in each, at least one case is further from
/// the truth than allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KnownFailure {
    /// The kernel.
    pub kernel: Kernel,
    /// Its qualities.
    pub qualities: &'static [Quality],
    /// `f32`, `f64` or both.
    pub floats: &'static [&'static str],
    /// The families of vectors.
    pub families: &'static [&'static str],
    /// Why they fail.
    pub reason: &'static str,
}

impl KnownFailure {
    /// Whether a family of this kernel, quality and format is meant.
    pub fn is(&self, kernel: Kernel, quality: Quality, float: &str) -> bool {
        self.kernel == kernel && self.qualities.contains(&quality) && self.floats.contains(&float)
    }
}

/// The families that a kernel, quality and format is known to fail, each with the reason.
pub fn known_failures(
    kernel: Kernel,
    quality: Quality,
    float: &str,
) -> impl Iterator<Item = (&'static str, &'static str)> {
    let known = KNOWN_FAILURES
        .iter()
        .filter(move |known| known.is(kernel, quality, float));
    known.flat_map(|known| known.families.iter().map(|&family| (family, known.reason)))
}

const BOTH: &[&str] = &["f32", "f64"];
const TEXTBOOK: &[Quality] = &[Quality::Textbook];
const UNSCALED: &[Quality] = &[Quality::Textbook, Quality::Stable];

/// Every known failure. One that no longer fails is an error of the list.
pub const KNOWN_FAILURES: &[KnownFailure] = &[
    KnownFailure {
        kernel: Kernel::RayPlane,
        qualities: UNSCALED,
        floats: BOTH,
        families: &["denormal_products", "overflow_products", "subnormal_cosine"],
        reason: "nothing is scaled, and a product overflows or falls below the smallest normal number",
    },
    KnownFailure {
        kernel: Kernel::RaySphere,
        qualities: UNSCALED,
        floats: BOTH,
        families: &[
            "all_tiny",
            "overflow_difference",
            "overflow_direction",
            "overflow_product_inside",
            "overflow_squares",
            "tiny_direction",
        ],
        reason: "nothing is scaled, and a square overflows or falls below the smallest normal number",
    },
    KnownFailure {
        kernel: Kernel::RaySphere,
        qualities: TEXTBOOK,
        floats: BOTH,
        families: &[
            "direction_1e15",
            "far_origin_1e3",
            "far_origin_1e4",
            "far_origin_1e5",
            "far_origin_1e6",
            "generic",
            "mixed_scales",
            "near_tangent",
            "nonunit_direction",
            "tiny_far_r1e-3_at1e4",
        ],
        reason: "b² - 4ac cancels: beyond the bound of a stable form",
    },
    KnownFailure {
        kernel: Kernel::RaySphere,
        qualities: TEXTBOOK,
        floats: &["f64"],
        families: &[
            "direction_1e-15",
            "huge_coords_1e6",
            "needle",
            "rational_roots",
            "unit_direction_off_by_ulps",
        ],
        reason: "b² - 4ac cancels, in f64 as in f32",
    },
    KnownFailure {
        kernel: Kernel::AnyHit,
        qualities: TEXTBOOK,
        floats: BOTH,
        families: &["tangent_at_end", "tangent_occluder"],
        reason: "b² - 4ac cancels: a tangent is missed, or a near miss is hit",
    },
    KnownFailure {
        kernel: Kernel::LightSample,
        qualities: TEXTBOOK,
        floats: BOTH,
        families: &[
            "d2_subnormal",
            "difference_overflows",
            "dist_overflows",
            "one_denormal_apart",
            "radiance_overflows",
        ],
        reason: "the square of the distance overflows or falls below the smallest normal number, where \
            the radiance does not",
    },
    KnownFailure {
        kernel: Kernel::LightSample,
        qualities: TEXTBOOK,
        floats: &["f32"],
        families: &["d2_overflow", "d2_underflow"],
        reason: "the square of the distance is out of the range of f32, but not of f64",
    },
];
