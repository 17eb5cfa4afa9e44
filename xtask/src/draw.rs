//! Drawing on pictures: text, frames, lines and enlarged pixels.

mod canvas;
mod outline;
mod palette;
mod text;

pub use canvas::{Area, Canvas, Pen};
pub use outline::outline;
pub use palette::{BLACK, GREEN, INK, MUTED, SKY, WHITE, YELLOW};
pub use text::{Weight, width};
