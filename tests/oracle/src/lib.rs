//! The independent exact truth of the kit: what a shadow kernel ought to have answered.
//!
//! Inputs are floats, taken as exact rationals. Every decision (hit or miss, which root, on which
//! side, blocked by what) is made in exact arithmetic: rationals, and signs of `a + b√D` decided by
//! squaring. Values are rounded once, at the end, to the nearest float (ties to even). Nothing here
//! is shared with the kernels it judges.
//!
//! - [`truth`] turns a request of the kernel protocol into the `exp` of a test vector.
//! - [`Ray`], [`Plane`], [`Sphere`], [`any_hit`], [`light`], [`shade`], [`offset`] and [`quantise`]
//!   are the same truth as typed functions, for property tests.
//! - [`error`] measures how far a computed float is from an exact value.
//! - [`families`] generates the test vectors.
//!
//! A single precision float widens to `f64` exactly, so typed functions take `f64` and, where
//! something is rounded, a [`Format`].

pub mod any_hit;
pub mod case;
pub mod decimal;
pub mod error;
pub mod exact;
pub mod families;
pub mod format;
mod json;
pub mod light;
pub mod object;
pub mod offset;
pub mod plane;
pub mod quantise;
pub mod ray;
pub mod real;
pub mod shade;
pub mod sphere;
pub mod surd;

pub use case::{Error, truth};
pub use exact::{Rational, Vector};
pub use format::Format;
pub use object::Object;
pub use plane::Plane;
pub use ray::{Interval, PerInterval, Ray};
pub use real::Real;
pub use sphere::Sphere;
pub use surd::Surd;
