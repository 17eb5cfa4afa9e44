//! What is read from a name or a size, and what is refused.

use crate::property::for_all;
use ombrage::conformance::diagnosis::check_size;
use ombrage::{Quality, Rung, Shadow, Size};
use proptest::prelude::*;

/// A strategy is read from its name, with any length that it may have, and from no other text.
pub fn shadows_are_read_from_their_names() {
    let lengths = (0.0..1e3f64).prop_map(|x| [Shadow::TMin(x), Shadow::ConstantOffset(x)]);
    for_all(lengths, |shadows| {
        for shadow in shadows.into_iter().chain(Shadow::ALL) {
            let name = shadow.name();
            prop_assert_eq!(Shadow::named(&name), Some(shadow));
            // One with a number is read with any other.
            if let Some((kind, _)) = name.split_once('=') {
                let other = format!("{kind}=0.625");
                prop_assert_eq!(Shadow::named(&other).map(Shadow::name), Some(other));
            }
        }
        Ok(())
    });
    for name in [
        "",
        "offset",
        "t-min",
        "zebra=1",
        "offset=",
        "t-min=nan",
        "offset=-1",
        "t-min=inf",
    ] {
        assert_eq!(Shadow::named(name), None, "{name}");
    }
}

/// A quality is read from its name, and from no other text.
pub fn qualities_are_read_from_their_names() {
    for quality in Quality::ALL {
        assert_eq!(Quality::named(quality.name()), Some(quality));
        assert!(quality.name().len() > 3);
    }
    for name in ["", "Stable", "best"] {
        assert_eq!(Quality::named(name), None, "{name}");
    }
}

/// Tables name a rung as the code does.
pub fn rungs_have_their_names() {
    for rung in Rung::ALL {
        let variant = format!("{rung:?}").to_lowercase();
        assert_eq!(rung.name().replace('_', ""), variant);
    }
}

/// Pictures are judged from 32x32 to 2^24 pixels.
pub fn sizes_that_are_judged() {
    for (width, height, is_judged) in [
        (32, 32, true),
        (31, 4000, false),
        (4000, 31, false),
        (4096, 4096, true),
        (4096, 4097, false),
    ] {
        let size = Size::new(width, height).expect("a size");
        let found = check_size(size).is_ok();
        assert_eq!(found, is_judged, "{width}x{height}");
    }
}
