//! How numbers and names are written.

use crate::table::grouped;
use maud::{Markup, html};

/// A whole number with its digits in groups.
pub fn whole(number: usize) -> String {
    grouped(number as u64)
}

/// A share in percent, with a decimal.
pub fn percent(part: usize, whole: usize) -> String {
    format!("{:.1}\u{a0}%", 100.0 * part as f64 / whole.max(1) as f64)
}

/// Text in which what stands between backquotes is code.
pub fn with_code(text: &str) -> Markup {
    html! {
        @for (place, part) in text.split('`').enumerate() {
            @if place % 2 == 1 { code { (part) } } @else { (part) }
        }
    }
}

/// What a strategy does, in a few words.
pub fn strategy(name: &str) -> &'static str {
    match name {
        "self-hitting" => "nothing; a hit at distance 0 counts",
        "half-open" => "nothing; a hit at distance exactly 0 does not count",
        "t-min=0.0001" => "hits nearer than 0.0001 do not count",
        "t-min=0.001" => "hits nearer than 0.001 do not count",
        "offset=0.001" => "the ray starts 0.001 off the surface",
        "offset=0.01" => "the ray starts 0.01 off the surface",
        "offset=0.1" => "the ray starts 0.1 off the surface",
        "ulp-offset" => "the lab's Ray::offset: 256 units in the last place off the surface",
        "error-bound" => {
            "the ray starts outside a box that is proven to hold the true point (pbrt)"
        }
        "reprojection" => "the hit point is projected onto its surface once more",
        "skip-self" => "the surface the ray leaves is not asked",
        "sidedness" => "the kit's default: on which side of each surface are point and light?",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shadows::Strategy;

    #[test]
    fn every_strategy_has_words() {
        for name in Strategy::all().into_iter().map(Strategy::name) {
            assert!(!strategy(&name).is_empty(), "{name}");
        }
    }
}
