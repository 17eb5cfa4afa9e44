//! Sizes and bytes that no picture has.

use super::bad_input::refused;
use ombrage::{Picture, Size};

pub fn pictures_are_refused_by_field_and_value() {
    for (width, height) in [
        (0, 1),
        (1, 0),
        (0, 0),
        (1 << 14, (1 << 14) + 1),
        (u32::MAX, u32::MAX),
    ] {
        refused(
            Size::new(width, height),
            "picture size",
            &format!("{width}x{height}"),
        );
    }
    assert!(Size::new(1 << 14, 1 << 14).is_ok());
    let size = Size::new(2, 3).expect("the size is valid");
    for bytes in [0, 17, 19] {
        refused(
            Picture::new(size, &vec![0; bytes]),
            "picture bytes",
            &bytes.to_string(),
        );
    }
    assert!(Picture::new(size, &[0; 18]).is_ok());
    for pixels in [0, 5, 7] {
        refused(
            Picture::from_pixels(size, vec![[0; 3]; pixels]),
            "picture pixels",
            &pixels.to_string(),
        );
    }
    assert!(Picture::from_pixels(size, vec![[0; 3]; 6]).is_ok());
}
