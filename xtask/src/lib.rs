//! The commands of the kit, and what they share.

pub mod arguments;
pub mod case;
pub mod clock;
pub mod compare;
pub mod draw;
pub mod error;
pub mod fields;
pub mod figures;
pub mod judge;
pub mod kernels;
pub mod margin;
pub mod output;
pub mod parallel;
pub mod picture_file;
pub mod precision;
pub mod progress;
pub mod protocol;
pub mod render;
pub mod scene_file;
pub mod shadows;
pub mod survey;
pub mod table;
pub mod truth;
pub mod vectors;
pub mod whole_file;
pub mod workspace;
