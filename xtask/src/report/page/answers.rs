//! The first answers: what this is, what acne is, which cure to use.

use super::Column::{Number, Text};
use super::picture::Pictures;
use super::words::{percent, strategy, whole};
use super::{diagram, figure, table, tiles};
use crate::report::chart::{nanoseconds, shadow};
use crate::report::data::Data;
use crate::report::headline::scenes;
use crate::shadows::{Strategy, Total, totals};
use maud::{Markup, html};

/// What this is.
pub fn what(data: &Data, _: &Pictures) -> Markup {
    html! {
        p.answer {
            "Ombrage is a conformance kit for cast shadows: a university lab on shadow rays, done right \
             once in Rust, in " code { "f32" } " and " code { "f64" } ", and held to exact arithmetic."
        }
        p {
            "Everybody who writes a ray tracer goes through that lab: a plane, point lights, direct light \
             with a clamp, shadow rays that first speckle and then do not. The kit says in "
            (data.clauses.len()) " clauses what must be true, has " (scenes(data)) " scenes that are hard on \
             shadows, and knows the truth of every pixel. This page shows what it found."
        }
        (tiles(data))
    }
}

/// What acne is.
pub fn acne(data: &Data, pictures: &Pictures) -> Markup {
    let noisy = data.figures.iter().find(|figure| figure.name == "3a");
    let acne = noisy.map_or(0, |figure| figure.acne_plane + figure.acne_sphere);
    let lit = noisy.map_or(0, |figure| figure.lit_plane + figure.lit_sphere);
    let mut compared = data.compare.iter();
    let compared = compared.find(|row| row.picture == "figure 3a" && row.way == "lab");
    let double = compared.map_or(0, |row| row.f64.shadow);
    let slider = pictures.slider(
        [
            "3a",
            "with acne",
            "Figure 3(a): a blue sphere over a red plane; most of the picture is speckled \
          with black pixels.",
        ],
        [
            "3c",
            "cured",
            "Figure 3(c): the same scene without a speckle; the sphere casts one round shadow.",
        ],
    );
    html! {
        p.answer {
            "Acne is shadow where there is none: a surface shadows itself, because the point that its \
             shadow ray starts from has been rounded."
        }
        div.row {
            (figure(&slider, &html! {
                "Drag the line, or use the arrow keys. Left, Figure 3(a) of the lab: " (whole(acne)) " of "
                (whole(lit)) " lit pixels (" (percent(acne, lit)) ") are falsely black. Right, Figure 3(c): \
                none is."
            }))
            div {
                (diagram::rounding())
                p {
                    "Is a point in shadow? Send a ray from it to the light, and see whether it hits \
                     anything. But a computer rounds the point, so it lies a hair above its surface, a hair \
                     below, or exactly on it. From below, or on it, the ray hits the surface it has just left."
                }
                p {
                    strong { "More precision does not cure it. " } "The hair gets thinner, not rarer: computed \
                    in " code { "f64" } ", " (whole(double)) " pixels of the same picture are wrong."
                }
            }
        }
    }
}

/// Which cure to use.
pub fn cure(data: &Data, _: &Pictures) -> Markup {
    let totals = totals(&data.shadows);
    let in_single = totals.iter().filter(|total| total.float == "f32").count();
    let is_picky = |float: &str| {
        let picky = data
            .offsets
            .iter()
            .filter(|o| o.float == float && !o.serve());
        picky.count()
    };
    let own = Strategy::Sidedness.name();
    html! {
        p.answer {
            "Ask for sides, not for distances. On which side of each surface are the point and the light? \
             That is a sign, and needs no epsilon. It is the kit's default, " code { (own) } "."
        }
        ul {
            li { strong { "Planes and spheres: " } code { (own) } ", in either precision." }
            li { strong { "Other shapes: " } code { "error-bound" } " in " code { "f64" } ". It moves the ray's \
                start out of a box that is proven to hold the true point, and costs a few times more." }
            li { strong { "Not a constant epsilon. " } "In " code { "f32" } " no constant offset at all serves "
                (is_picky("f32")) " of the " (scenes(data)) " scenes, in " code { "f64" } " " (is_picky("f64"))
                (if one_fits_all(data, "f32") { "" } else { ", and no single one serves the others" }) "." }
        }
        div.pair {
            @for float in ["f32", "f64"] {
                (figure(&shadow::pareto(data, float).markup(), &html! {
                    strong { "In " code { (float) } ": what a shadow ray costs, and how many pixels are wrong. " }
                    "Lower left is better. Without a wrong pixel: " (list(&clean(&totals, float))) "."
                }))
            }
        }
        div.row {
            (figure(&shadow::offsets(data, "f32").markup(), &html! {
                strong { "There is no right epsilon. " } "Each bar: the constant offsets that serve a scene in "
                code { "f32" } ". Smaller ones have acne, larger ones leak or shadow falsely. A cross: none \
                serves. No vertical line passes through all bars."
            }))
            div {
                h3 { "How asking for sides works" }
                ol {
                    li { "The surface the ray leaves is not asked. Equal surfaces count as one." }
                    li { "Camera and light on opposite sides of that surface: black. On the same side: it \
                        never shadows itself." }
                    li { "Another plane blocks where the point and the light lie on opposite sides of it; \
                        another sphere, where the way to the light passes within its radius." }
                    li { "Everything is taken relative to the camera. No point in world space is ever formed, so \
                        none is rounded." }
                }
                p {
                    "Each is the sign of one number: no distance has to be large enough, or small enough."
                }
            }
        }
        (table(&format!("All {in_single} strategies over all scenes"),
            &[Text("strategy"), Text("what it does"), Number("wrong, `f32`"), Number("scenes"),
              Number("wrong, `f64`"), Number("scenes"), Number("ns, `f32`"), Number("ns, `f64`")],
            &strategies(data, &totals)))
        p.note {
            "Wrong: falsely black or falsely lit pixels, of those that face the light. Scenes: in how many \
             any is wrong. ns: nanoseconds a shadow ray from a known hit, two objects, one thread, one ray \
             at a time; for " code { (own) } ", where a light has no ray of its own, the picture's time with \
             shadows less that without."
        }
    }
}

/// Whether one constant offset serves all scenes that any serves.
fn one_fits_all(data: &Data, float: &str) -> bool {
    let serving = || {
        data.offsets
            .iter()
            .filter(|o| o.float == float && o.serve())
    };
    let least = serving()
        .filter_map(|offsets| offsets.least)
        .fold(0.0, f64::max);
    let most = serving()
        .filter_map(|offsets| offsets.most)
        .fold(f64::INFINITY, f64::min);
    least <= most
}

/// The strategies without a wrong pixel.
fn clean<'a>(totals: &'a [Total], float: &str) -> Vec<&'a str> {
    let clean = totals
        .iter()
        .filter(|total| total.float == float && total.wrong.shadows() == 0);
    clean.map(|total| total.strategy.as_str()).collect()
}

fn list(names: &[&str]) -> Markup {
    html! {
        @if names.is_empty() { "none" }
        @for (place, name) in names.iter().enumerate() {
            @if place > 0 { ", " }
            code { (name) }
        }
    }
}

fn strategies(data: &Data, totals: &[Total]) -> Vec<Vec<Markup>> {
    let rows = Strategy::all().into_iter().map(Strategy::name).map(|name| {
        let of = |float: &str| {
            totals
                .iter()
                .find(|t| t.strategy == name && t.float == float)
        };
        let wrong = |float: &str| of(float).map_or(0, |total| total.wrong.shadows());
        let scenes = |float: &str| of(float).map_or(0, |total| total.scenes_wrong);
        let ns = |float: &str| shadow::cost(data, &name, float).map_or("-".into(), nanoseconds);
        vec![
            html! { code { (name) } },
            html! { (strategy(&name)) },
            html! { (whole(wrong("f32"))) },
            html! { (scenes("f32")) },
            html! { (whole(wrong("f64"))) },
            html! { (scenes("f64")) },
            html! { (ns("f32")) },
            html! { (ns("f64")) },
        ]
    });
    rows.collect()
}
