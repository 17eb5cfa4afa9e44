//! The commands of the kit, and what they share.

pub mod arguments;
pub mod bench;
pub mod case;
pub mod clock;
pub mod compare;
pub mod conform;
pub mod digests;
pub mod draw;
pub mod error;
pub mod explain;
pub mod figures;
pub mod kernels;
pub mod output;
pub mod parallel;
pub mod picture_file;
pub mod precision;
pub mod progress;
pub mod render;
pub mod scene_file;
pub mod shadows;
pub mod table;
pub mod tidy;
pub mod truth;
pub mod vectors;
pub mod whole_file;
pub mod workspace;
