//! What judges kernels: the questions that are asked of them, the kit's own answers, and how far an
//! answer may be from the truth.
//!
//! The questions are those of the kernel protocol (`docs/protocol.md`). This module may know all of
//! the library; nothing in the library knows it.
//!
//! The cargo feature `vectors` adds the protocol itself as JSON, the test vectors with their exact
//! truth, and `Trial`, which asks them of anyone's kernels. Without it the
//! library depends on no JSON and no exact arithmetic.

pub mod diagnosis;
mod explain;
mod kernels;
mod precision;
mod question;
mod shade;
mod surface;
#[cfg(feature = "vectors")]
mod vectors;

pub use explain::{Agreement, Drawing, Explanation, First, FromLight, Loss, Step, Trace, explain};
pub use kernels::{Kernels, Offset};
pub use precision::{
    Allowed, KNOWN_FAILURES, KnownFailure, Precision, known_failures, precision, promise,
};
pub use question::{Answer, Question};
pub use shade::{Shade, Shaded};
pub use surface::{Ends, Surface};
#[cfg(feature = "vectors")]
pub use vectors::{
    Behaviour, Case, Evidence, Judged, Measured, Trial, Verdict, Wrong, answer, failing, output,
    recognise, vectors,
};

/// What a question is about: one kind of the kernel protocol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kernel {
    /// The nearest hit of a plane in an interval.
    RayPlane,
    /// The nearest hit of a sphere in an interval.
    RaySphere,
    /// Whether anything is hit in an interval.
    AnyHit,
    /// The sample of a point light (clause 2.3).
    LightSample,
    /// The radiance along one ray.
    Shade,
    /// A shadow ray's origin.
    Offset,
    /// The byte of a component of radiance (clause 3.3).
    Quantise,
}

impl Kernel {
    /// All kernels, in the order of tables.
    pub const ALL: [Kernel; 7] = [
        Kernel::RayPlane,
        Kernel::RaySphere,
        Kernel::AnyHit,
        Kernel::LightSample,
        Kernel::Shade,
        Kernel::Offset,
        Kernel::Quantise,
    ];

    /// The name in the protocol.
    pub fn name(self) -> &'static str {
        match self {
            Kernel::RayPlane => "ray_plane",
            Kernel::RaySphere => "ray_sphere",
            Kernel::AnyHit => "any_hit",
            Kernel::LightSample => "light_sample",
            Kernel::Shade => "shade",
            Kernel::Offset => "offset",
            Kernel::Quantise => "quantise",
        }
    }

    /// The kernel of this name.
    pub fn named(name: &str) -> Option<Kernel> {
        Self::ALL.into_iter().find(|kernel| kernel.name() == name)
    }

    /// Whether its answers depend on the [`Quality`](crate::Quality). Those of the others are as
    /// right as they can be in every quality.
    pub fn has_qualities(self) -> bool {
        !matches!(self, Kernel::Shade | Kernel::Offset | Kernel::Quantise)
    }
}
