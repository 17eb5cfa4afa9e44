//! How wide the processor computes.

use std::fmt;
use std::str::FromStr;

/// A way to compute a picture: one lane at a time, or with SIMD packets of a processor level.
///
/// Every level has the same bits. The names are those of the x86 and ARM instruction sets that
/// `fearless_simd` tells apart: [`Avx2`](Level::Avx2) is x86-64-v3, [`Avx512`](Level::Avx512) is
/// that of Ice Lake and later. A build for a newer baseline computes the levels below it at it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// No packets: the reference for all others.
    Scalar,
    /// Packets of 128 bits without SIMD instructions, for every processor.
    Fallback,
    /// Packets of 128 bits, which every x86-64 processor has.
    Sse2,
    /// Packets of 128 bits with more instructions: x86-64-v2.
    Sse4_2,
    /// Packets of 256 bits: x86-64-v3.
    Avx2,
    /// Packets of 512 bits.
    Avx512,
    /// Packets of 128 bits, on 64-bit ARM.
    Neon,
}

impl Level {
    /// Every level, each narrower one before the wider.
    pub const ALL: [Level; 7] = [
        Level::Scalar,
        Level::Fallback,
        Level::Sse2,
        Level::Sse4_2,
        Level::Avx2,
        Level::Avx512,
        Level::Neon,
    ];

    /// The name that [`FromStr`] reads: `scalar`, `fallback`, `sse2`, `sse4.2`, `avx2`, `avx512` or
    /// `neon`.
    pub fn name(self) -> &'static str {
        match self {
            Level::Scalar => "scalar",
            Level::Fallback => "fallback",
            Level::Sse2 => "sse2",
            Level::Sse4_2 => "sse4.2",
            Level::Avx2 => "avx2",
            Level::Avx512 => "avx512",
            Level::Neon => "neon",
        }
    }

    /// The levels that this processor has; never empty.
    pub fn available() -> impl DoubleEndedIterator<Item = Level> {
        Self::ALL.into_iter().filter(|level| level.is_available())
    }

    /// The widest level that this processor has.
    pub fn best() -> Level {
        Self::available().next_back().unwrap_or(Level::Scalar)
    }

    /// Whether this processor has the level.
    pub fn is_available(self) -> bool {
        self == Level::Scalar || self.simd().is_some()
    }

    /// The proof that this processor has the level, for `fearless_simd::dispatch!`. `None` where it
    /// has not, and for scalars, which need no proof.
    pub fn simd(self) -> Option<fearless_simd::Level> {
        use fearless_simd::Level as Simd;
        let best = Simd::new();
        match self {
            Level::Fallback => Some(Simd::fallback()),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Sse2 => best.as_sse2().map(Simd::Sse2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Sse4_2 => best.as_sse4_2().map(Simd::Sse4_2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx2 => best.as_avx2().map(Simd::Avx2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx512 => best.as_avx512().map(Simd::Avx512),
            #[cfg(target_arch = "aarch64")]
            Level::Neon => best.as_neon().map(Simd::Neon),
            _ => None,
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A level was asked for that this processor does not have, or that does not exist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoSuchLevel(
    /// The name that was given.
    pub String,
);

impl fmt::Display for NoSuchLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "level is {:?}, but must be auto", self.0)?;
        for level in Level::available() {
            write!(f, ", {level}")?;
        }
        write!(f, ": this processor has no other")
    }
}

impl std::error::Error for NoSuchLevel {}

impl FromStr for Level {
    type Err = NoSuchLevel;

    /// The level of a name, or the best for `auto`; whether the processor has it or not.
    fn from_str(name: &str) -> Result<Self, NoSuchLevel> {
        if name == "auto" {
            return Ok(Level::best());
        }
        let named = Level::ALL.into_iter().find(|level| level.name() == name);
        named.ok_or_else(|| NoSuchLevel(name.to_owned()))
    }
}
