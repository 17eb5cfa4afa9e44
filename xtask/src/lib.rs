//! The commands of the kit, and what they share.

pub mod arguments;
pub mod draw;
pub mod error;
pub mod figures;
pub mod output;
pub mod picture_file;
pub mod progress;
pub mod render;
pub mod scene_file;
pub mod table;
pub mod whole_file;
pub mod workspace;
