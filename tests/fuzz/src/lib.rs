//! What must hold of any bytes that a stranger may send. `xtask/tests/fuzz.rs` makes them by a
//! grammar and by mutation; the targets of this crate are led by coverage.

mod adapter_answer;
mod picture_file;
mod protocol_line;
mod scene_file;

pub use adapter_answer::{adapter_answer, right_answers};
pub use picture_file::picture_file;
pub use protocol_line::protocol_line;
pub use scene_file::scene_file;
