//! Why a surface shadows itself, as a drawing.

use maud::{Markup, html};

/// A rounded point below its surface, whose shadow ray hits the surface; and one above, whose does
/// not.
pub fn rounding() -> Markup {
    let alt = "A surface drawn as a line. One rounded point lies just below it, and its ray to the light \
        crosses the surface: falsely black. Another lies just above, and its ray is free: lit.";
    html! {
        svg.diagram viewBox="0 0 320 190" role="img" aria-label=(alt) {
            circle.lamp cx="272" cy="26" r="11" {}
            text x="250" y="31" text-anchor="end" { "light" }
            line.surface x1="10" y1="130" x2="310" y2="130" {}
            text x="310" y="148" text-anchor="end" { "surface" }
            line.blocked x1="70" y1="142" x2="84" y2="130" {}
            line.missed x1="84" y1="130" x2="262" y2="34" {}
            circle.below cx="70" cy="142" r="5" {}
            circle.hit cx="84" cy="130" r="4" {}
            text x="62" y="166" { "rounded below:" }
            text x="62" y="183" { "the ray hits, black" }
            line.free x1="196" y1="118" x2="266" y2="37" {}
            circle.above cx="196" cy="118" r="5" {}
            text x="208" y="125" { "above: lit" }
        }
    }
}
