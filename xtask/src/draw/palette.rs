//! Colours that people with any colour vision can tell apart: Okabe and Ito, "Color Universal
//! Design" (2008), and the neutral ones beside them.

/// An sRGB colour.
pub type Color = [u8; 3];

/// Okabe and Ito's bluish green.
pub const GREEN: Color = [0, 158, 115];
/// Okabe and Ito's sky blue.
pub const SKY: Color = [86, 180, 233];
/// Okabe and Ito's yellow.
pub const YELLOW: Color = [240, 228, 66];

/// Black.
pub const BLACK: Color = [0, 0, 0];
/// White.
pub const WHITE: Color = [255, 255, 255];
/// The ground of captions.
pub const PAPER: Color = [250, 250, 248];
/// Text.
pub const INK: Color = [28, 28, 30];
/// Text that is second in rank.
pub const MUTED: Color = [92, 92, 98];
