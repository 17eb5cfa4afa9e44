//! The kernel protocol: requests answered by the kit's kernels, and answers judged by exact truth.

pub mod fields;
pub mod judge;
pub mod margin;
pub mod protocol;
pub mod survey;
