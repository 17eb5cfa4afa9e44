//! What stands behind the answers.

use super::Column::{Number, Text};
use super::method;
use super::picture::Pictures;
use super::words::{percent, whole};
use super::{cost, figure, table};
use crate::bench::result::Row;
use crate::report::chart::{accuracy, shadow};
use crate::report::data::Data;
use crate::shadows::Strategy;
use maud::{Markup, html};

/// All details.
pub fn all(data: &Data, pictures: &Pictures) -> Markup {
    html! {
        h3 { "The figures of the lab" }
        (figures(data, pictures))
        h3 { "How much acne is a matter of luck" }
        (heights(data))
        h3 { "Every strategy on every scene" }
        @for float in ["f32", "f64"] { (heat_map(data, float)) }
        p.note {
            "Wrong shadows in pixels that face the light: acne, false shadows and leaks together. The lab's \
             chain sees the other side of the surface that the camera is on in camera_on_sphere; such \
             pixels are not counted."
        }
        h3 { "Other kernels" }
        div.pair {
            @for (kernel, name) in [("light_sample", "The light sample"), ("ray_plane", "Ray and plane")] {
                @for float in ["f32", "f64"] {
                    (figure(&accuracy::kernel(data, kernel, float).markup(), &html! {
                        strong { (name) " in " code { (float) } ". " }
                        @if kernel == "light_sample" { "Scaling by a power of two is what makes it right where the \
                            square of the distance leaves the format." }
                        @else { "Textbook and stable are one formula; wide is right also where products leave \
                            the format." }
                    }))
                }
            }
        }
        h3 { "What does not make it faster" }
        (any_hit(data))
        h3 { "f32 against f64 on every scene" }
        (table("`f32` against `f64` against the truth: the scenes",
            &[Text("scene"), Text("way"), Number("wrong bytes, `f32`"), Number("wrong bytes, `f64`"),
              Number("largest error, `f32`"), Number("largest error, `f64`"), Number("time `f64` / `f32`")],
            &cost::pictures(data, false)))
        (method::all(data))
    }
}

fn figures(data: &Data, pictures: &Pictures) -> Markup {
    let of = |name: &str| data.figures.iter().find(|figure| figure.name == name);
    let slider = pictures.slider(
        [
            "2a",
            "bytes wrap",
            "Figure 2(a): the top of the blue sphere has a black spot.",
        ],
        [
            "2b",
            "clamped",
            "Figure 2(b): the top of the blue sphere is evenly bright.",
        ],
    );
    html! {
        div.pair {
            (figure(&pictures.plain("1", "Figure 1: a blue sphere over a red plane before grey, lit from the \
                camera."), &html! {
                strong { "Figure 1. " } "A plane joins the sphere; the light is at the eye."
            }))
            (figure(&slider, &html! {
                strong { "Figures 2(a) and 2(b). " } "Without a clamp, "
                (of("2a").map_or(0, |figure| figure.too_bright))
                " pixels pass 255 and wrap to black; with it they stay bright. Drag the line."
            }))
        }
        div.pair {
            (figure(&pictures.annotated("2a", "Figure 2(a) with the wrapped spot framed and enlarged, and a \
                chart of its bytes."), &html! {
                strong { "2(a), annotated. " } "The bytes climb to 255 and start again at 0."
            }))
            (figure(&pictures.annotated("2b", "Figure 2(b) with the same spot framed: evenly blue."), &html! {
                strong { "2(b), annotated. " } "The same spot, clamped."
            }))
            (figure(&pictures.annotated("3a", "Figure 3(a) with every acne pixel marked yellow."), &html! {
                strong { "3(a), annotated. " } "Yellow pixels are falsely black."
            }))
            (figure(&pictures.annotated("3b", "Figure 3(b): a part of Figure 3(a) enlarged, its place framed in \
                a small map."), &html! {
                strong { "3(b), annotated. " } "The noise of 3(a), enlarged and brightened."
            }))
            (figure(&pictures.annotated("3c", "Figure 3(c) with the outline of the shadow."), &html! {
                strong { "3(c), annotated. " }
                (whole(of("3c").map_or(0, |figure| figure.shadowed)))
                " pixels in shadow, none of them acne."
            }))
        }
    }
}

/// Acne against the height of the plane, with the range that was found.
fn heights(data: &Data) -> Markup {
    let both = || {
        data.heights
            .iter()
            .flat_map(|height| [height.f32, height.f64])
    };
    let share = |acne: usize, lit: usize| acne as f64 / lit.max(1) as f64;
    let lab = data.heights.iter().find(|height| height.y == -2.0);
    let least = both().min_by(|a, b| share(a.closed, a.lit).total_cmp(&share(b.closed, b.lit)));
    let most = both().max_by(|a, b| share(a.open, a.lit).total_cmp(&share(b.open, b.lit)));
    figure(
        &shadow::heights(data).markup(),
        &html! {
            "The lab's plane at another height. Where a hit at distance 0 counts"
            @if let Some(acne) = least { ", at least " (percent(acne.closed, acne.lit)) " of it is acne" }
            ". Where it does not"
            @if let Some(lab) = lab { ", " (percent(lab.f32.open, lab.f32.lit)) " at a depth of 2, the lab's" }
            @if let Some(acne) = most { ", and up to " (percent(acne.open, acne.lit)) " elsewhere" }
            ": a cure that is tried on the lab's scene alone proves nothing."
        },
    )
}

/// Any hit against the nearest hit, from the bench.
fn any_hit(data: &Data) -> Markup {
    let rows = &data.bench.growth_with_spheres;
    let ratio = |spheres: usize| {
        let ask = |query: &str| {
            let mut rows = rows.iter().filter(|row: &&Row| {
                let is_lab = row.chain == "lab" && row.level == "scalar" && row.float == "f32";
                is_lab && row.spheres == spheres
            });
            rows.find(|row| row.query.as_deref() == Some(query))
                .map(|row| row.ns_per_pixel)
        };
        ask("nearest")
            .zip(ask("any"))
            .map(|(nearest, any)| format!("{:.2}", nearest / any))
    };
    let counts = rows.iter().map(|row| row.spheres);
    let ends = [counts.clone().min(), counts.max()];
    html! {
        p {
            "Asking for any hit instead of the nearest one (clause 5) is often sold as a speed-up. "
            @for spheres in ends.into_iter().flatten() {
                @if let Some(ratio) = ratio(spheres) {
                    "With " (whole(spheres)) (if spheres == 1 { " sphere" } else { " spheres" })
                    " the nearest hit takes " (ratio) " times as long, one pixel at a time. "
                }
            }
            "It is a clearer question, and the same picture byte for byte."
        }
    }
}

/// Scenes by strategies: each cell says how many pixels are wrong, and is the darker the more.
fn heat_map(data: &Data, float: &str) -> Markup {
    let strategies: Vec<String> = Strategy::all().into_iter().map(Strategy::name).collect();
    let mut scenes: Vec<&str> = data.shadows.iter().map(|row| row.scene.as_str()).collect();
    scenes.dedup();
    let mut seen = vec![];
    scenes.retain(|scene| {
        !seen.contains(scene) && {
            seen.push(*scene);
            true
        }
    });
    let wrong = |scene: &str, strategy: &str| {
        let mut rows = data.shadows.iter();
        let row = rows.find(|r| r.scene == scene && r.strategy == strategy && r.float == float);
        row.map(|row| row.wrong.shadows())
    };
    let mut heads = vec!["scene"];
    heads.extend(strategies.iter().map(String::as_str));
    let name = format!("Wrong pixels by scene and strategy, {float}");
    html! {
        div.scroll role="region" aria-label=(name) tabindex="0" {
            table.heat {
                caption { (name) }
                thead { tr { @for head in &heads { th scope="col" { (head) } } } }
                tbody {
                    @for scene in &scenes {
                        tr {
                            th scope="row" { (scene) }
                            @for strategy in &strategies {
                                @if let Some(wrong) = wrong(scene, strategy) {
                                    td class={ "h" (decade(wrong)) } title={
                                        (scene) ", " (strategy) ", " (float) ": " (whole(wrong)) " wrong"
                                    } { (whole(wrong)) }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// 0 for none, else one more than the power of ten.
fn decade(count: usize) -> u32 {
    count.checked_ilog10().map_or(0, |power| power + 1)
}
