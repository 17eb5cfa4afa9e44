//! What it costs, and whether f32 can be trusted.

use super::Column::{Number, Text};
use super::picture::Pictures;
use super::words::whole;
use super::{figure, table};
use crate::bench::result::Row;
use crate::report::chart::{accuracy, nanoseconds, speed};
use crate::report::data::Data;
use maud::{Markup, html};
use ombrage::Quality;

/// What it costs.
pub fn cost(data: &Data, _: &Pictures) -> Markup {
    let (best, baseline) = (speed::best(data, "f32"), speed::lab_way(data, "f32"));
    let scalar = speed::rows(data, "relative", "f32").find(|row| row.level == "scalar");
    html! {
        @if let (Some(best), Some(baseline)) = (best, baseline) {
            p.answer {
                "Less than being wrong. A pixel of Figure 3(c) takes " (nanoseconds(best.ns_per_pixel))
                " ns, " (times(best)) " times as fast as a program built as the lab says ("
                (nanoseconds(baseline.ns_per_pixel)) " ns), on one thread."
            }
            p {
                "One pixel after the other, without SIMD, it is "
                (scalar.map_or("-".into(), times)) " times as fast. At " code { (best.level) } " it reaches "
                (share(best)) " of what this machine's adders, dividers and square roots allow for the \
                 operations that the picture takes. Every level and any number of threads gives the \
                 same bytes."
            }
        }
        div.pair {
            (figure(&speed::levels(data).markup(), &html! {
                strong { "Time by processor level. " } "Wider packets are faster; the grey line is the \
                machine's limit for the kit's operations."
            }))
            (figure(&speed::spheres(data).markup(), &html! {
                strong { "Time by number of spheres. " } "Every sphere is asked, so time grows with their \
                number; a tree over the spheres" (pays(data)) "." (many_spheres(data))
            }))
        }
        (table("Figure 3(c), 600 x 400, one thread: every way and level, with the bytes it gets wrong",
            &[Text("way"), Text("level"), Number("ns, `f32`"), Number("times as fast"),
              Number("wrong bytes"), Number("of the limit"), Number("ns, `f64`"), Number("times as fast"),
              Number("wrong bytes"), Number("of the limit")], &ways(data)))
        h3 { "What a better kernel costs" }
        p {
            "Where does a ray meet a sphere? Each mark is a family of hard test vectors, at its largest \
             error. " code { "textbook" } " (b² − 4ac) has no error bound; " code { "stable" } ", the default, \
             keeps one, and misses only where the question itself is on the edge or numbers leave \
             the format; " code { "wide" } " computes one precision up and is right to half a unit."
        }
        div.pair {
            @for float in ["f32", "f64"] {
                (figure(&accuracy::kernel(data, "ray_sphere", float).markup(), &html! {
                    strong { "Ray and sphere in " code { (float) } ". " }
                    "Lower left is better. Families with a wrong hit or miss stand at the top: "
                    @for (place, (quality, count)) in wrong_families(data, float).iter().enumerate() {
                        @if place > 0 { ", " }
                        code { (quality) } " " (count)
                    }
                    "."
                }))
            }
        }
    }
}

/// In how many families of rays and spheres each quality has a wrong hit or miss.
fn wrong_families(data: &Data, float: &str) -> [(&'static str, usize); Quality::ALL.len()] {
    Quality::ALL.map(|quality| {
        let wrong = data.families.iter().filter(|family| {
            (family.kernel.as_str(), family.float.as_str()) == ("ray_sphere", float)
                && family.quality == quality.name()
                && family.wrong > 0
        });
        (quality.name(), wrong.count())
    })
}

fn times(row: &Row) -> String {
    format!("{:.1}", row.ratio_to_lab_way)
}

fn share(row: &Row) -> String {
    row.share_of_limit
        .map_or("-".into(), |share| format!("{:.0}\u{a0}%", 100.0 * share))
}

/// From how many spheres a tree pays, in `f32`.
fn pays(data: &Data) -> String {
    let of = data
        .bench
        .hierarchy
        .iter()
        .filter(|hierarchy| hierarchy.float == "f32");
    let from = of.filter_map(|hierarchy| hierarchy.pays_from).max();
    from.map_or(" does not pay here".into(), |from| {
        format!(" pays from {} on", whole(from))
    })
}

/// What the kit's chain costs against the lab's where there are most spheres, in packets of `f32`.
fn many_spheres(data: &Data) -> String {
    let rows = || data.bench.growth_with_spheres.iter();
    let most = rows().map(|row| row.spheres).max();
    let best = |chain: &str| {
        let fits = |row: &&Row| {
            Some(row.spheres) == most
                && row.chain == chain
                && row.float == "f32"
                && row.query.as_deref() != Some("nearest")
        };
        let times = rows().filter(fits).map(|row| row.ns_per_pixel);
        times.min_by(f64::total_cmp)
    };
    match (most, best("relative"), best("lab")) {
        (Some(most), Some(own), Some(lab)) => format!(
            " With {} of them the kit's chain takes {:.1} times as long as the lab's in packets, which gets \
             bytes wrong there.",
            whole(most),
            own / lab
        ),
        _ => String::new(),
    }
}

fn ways(data: &Data) -> Vec<Vec<Markup>> {
    let chains = [
        ("lab-way", "the lab's program"),
        ("lab", "lab's chain"),
        ("relative", "the kit's chain"),
    ];
    let mut rows = vec![];
    for (chain, name) in chains {
        for single in speed::rows(data, chain, "f32") {
            let double = speed::rows(data, chain, "f64").find(|row| row.level == single.level);
            let mut cells = vec![html! { (name) }, html! { (single.level) }];
            for row in [Some(single), double] {
                cells.push(html! { (row.map_or("-".into(), |row| nanoseconds(row.ns_per_pixel))) });
                cells.push(html! { (row.map_or("-".into(), times)) });
                cells.push(html! { (row.map_or("-".into(), |row| whole(row.wrong_bytes))) });
                cells.push(html! { (row.map_or("-".into(), share)) });
            }
            rows.push(cells);
        }
    }
    rows
}

/// Whether f32 can be trusted.
pub fn trust(data: &Data, _: &Pictures) -> Markup {
    let bests = (speed::best(data, "f32"), speed::best(data, "f64"));
    let is_exact = data
        .moved
        .iter()
        .all(|row| row.f64.lab + row.f64.relative == 0);
    let far = data
        .moved
        .iter()
        .find(|row| row.f32.lab > 100 * row.f32.relative.max(1));
    html! {
        p.answer {
            "Yes, where everything is taken relative to the camera first. No, where points far from the \
             origin are formed in " code { "f32" } "."
        }
        div.row {
            (figure(&accuracy::moved(data).markup(), &html! {
                strong { "The lab's scene, moved away from the origin. " }
                @if let Some(row) = far {
                    "At " (whole(row.moved_by as usize)) " units the lab's way has " (whole(row.f32.lab))
                    " wrong bytes in " code { "f32" } ", the kit's " (row.f32.relative) "."
                }
            }))
            div {
                p {
                    "The kit subtracts the camera from the scene once, in double precision. After that \
                     nothing is far away: no point in world space is ever formed, and " code { "f32" }
                    " has digits to spare."
                }
                p {
                    "A wrong byte is one that differs from the exact picture. Near the origin a few bytes \
                     of 720,000 lie so close to a step that " code { "f32" } " rounds them across it, in \
                     either way; in " code { "f64" } (if is_exact { " none does." } else { " fewer do." })
                }
                @if let (Some(single), Some(double)) = bests {
                    p {
                        "What " code { "f64" } " costs: in packets "
                        (format!("{:.1}", double.ns_per_pixel / single.ns_per_pixel)) " times the time of "
                        code { "f32" } "; one pixel at a time hardly anything, as the last column of the \
                         table shows."
                    }
                }
            }
        }
        (table("`f32` against `f64` against the truth: the six figures",
            &[Text("figure"), Text("way"), Number("wrong bytes, `f32`"), Number("wrong bytes, `f64`"),
              Number("largest error, `f32`"), Number("largest error, `f64`"), Number("time `f64` / `f32`")],
            &pictures(data, true)))
        p.note {
            "Of 720,000 bytes. Largest error: of a component of the radiance, where nothing flips; white is \
             1, and a byte is 1/255 = 0.0039. Figures 3(a) and 3(b) are judged by the shadows they ought \
             to have. Time: one pixel at a time."
        }
    }
}

/// What the lab's chain and the kit's get wrong: in the six figures, or in the scenes.
pub fn pictures(data: &Data, figures: bool) -> Vec<Vec<Markup>> {
    let rows = data
        .compare
        .iter()
        .filter(|row| row.picture.starts_with("figure ") == figures);
    let cells = rows.map(|row| {
        vec![
            html! { (row.picture.trim_start_matches("figure ")) },
            html! { (if row.way == "lab" { "lab's chain" } else { "the kit's" }) },
            html! { (whole(row.f32.bytes)) },
            html! { (whole(row.f64.bytes)) },
            html! { (format!("{:.1e}", row.f32.largest)) },
            html! { (format!("{:.1e}", row.f64.largest)) },
            html! { (format!("{:.2}", row.time_f64_over_f32)) },
        ]
    });
    cells.collect()
}
