//! How the truth is known that everything is measured by.

use super::Column::{Number, Text};
use super::picture::Pictures;
use super::words::whole;
use super::{figure, table};
use crate::report::chart::{nanoseconds, speed};
use crate::report::data::Data;
use crate::report::proofs::Row;
use maud::{Markup, html};

/// Which pixels are proven, by what, and what it costs.
pub fn proof(data: &Data, pictures: &Pictures) -> Markup {
    let total: usize = data.proofs.iter().map(pixels).sum();
    let open: usize = data.proofs.iter().map(|row| row.proof.undecided).sum();
    let first: usize = data.proofs.iter().map(|row| row.proof.rungs.f32).sum();
    let last = data.proofs.iter().find(|row| row.picture == "figure 3c");
    html! {
        p.answer {
            "It is proven, byte by byte: the pictures that all others are measured by are those of exact \
             arithmetic. " (whole(total)) " pixels in " (data.proofs.len()) " pictures, "
            (whole(open)) " of them undecided."
        }
        div.row {
            @if let Some(row) = last {
                (figure(&map(row, pictures), &html! {
                    strong { "Figure 3(c), proven. " } "Circled: the " (whole(row.higher.len())) " pixels of "
                    (whole(pixels(row))) " that single precision could not prove. Most lie where a \
                    colour is so near the border between two bytes that its bound reaches over it."
                }))
            }
            div {
                p {
                    "The kernels run on numbers that carry a bound of their own rounding error. Where no bound \
                     reaches over the border of a byte, and no decision was in doubt, the byte is proven; "
                    (format!("{:.2}", 100.0 * first as f64 / total.max(1) as f64)) " % of the pixels are, in "
                    code { "f32" } ". The others are done again in " code { "f64" } ", then in double-double, \
                     and ties, where a ray just touches, in exact fractions."
                }
                (cost(data))
            }
        }
        (table("Pixels by what proved them: the figures, and all scenes together",
            &[Text("picture"), Text("size"), Number("`f32`"), Number("`f64`"), Number("double-double"),
              Number("exact"), Number("undecided")], &rows(data)))
        p.note {
            "Figures 3(a) and 3(b) show errors of rounding, so there is no true picture of them."
        }
    }
}

/// What a proof costs, by the bench.
fn cost(data: &Data) -> Markup {
    let best = |chain: &'static str| {
        speed::rows(data, chain, "f32").min_by(|a, b| a.ns_per_pixel.total_cmp(&b.ns_per_pixel))
    };
    html! {
        @if let (Some(proven), Some(plain)) = (best("proven"), best("relative")) {
            p {
                "A proven pixel of Figure 3(c) takes " (nanoseconds(proven.ns_per_pixel)) " ns: "
                (format!("{:.1}", proven.ns_per_pixel / plain.ns_per_pixel)) " times the plain one, and "
                (format!("{:.0}", proven.ratio_to_lab_way)) " times as fast as the lab's way, of \
                which nothing is known. What the unproven ways get wrong stands in the table of all ways, above."
            }
        }
    }
}

fn pixels(row: &Row) -> usize {
    row.size[0] as usize * row.size[1] as usize
}

fn map(row: &Row, pictures: &Pictures) -> Markup {
    let alt = "Figure 3(c) in grey; circles mark the few pixels, spread over plane and sphere, that single \
        precision could not prove.";
    let marks = row.higher.iter().map(|pixel| {
        let kind = pixel.rung.as_str();
        let by = kind.replace('_', "-");
        let says = format!("column {}, row {}: proven in {by}", pixel.column, pixel.row);
        ([pixel.column, pixel.row], kind, says)
    });
    pictures.marked("3c", alt, &marks.collect::<Vec<_>>())
}

/// The figures, and the sum of the scenes.
fn rows(data: &Data) -> Vec<Vec<Markup>> {
    let counts = |row: &Row| {
        let rungs = row.proof.rungs;
        let double_double = rungs.double_double;
        [
            rungs.f32,
            rungs.f64,
            double_double,
            rungs.exact,
            row.proof.undecided,
        ]
    };
    let cells = |name: String, size: String, counts: [usize; 5]| {
        let mut cells = vec![html! { (name) }, html! { (size) }];
        cells.extend(counts.map(|count| html! { (whole(count)) }));
        cells
    };
    let (figures, scenes): (Vec<&Row>, Vec<&Row>) = data
        .proofs
        .iter()
        .partition(|row| row.picture.starts_with("figure "));
    let mut rows: Vec<_> = figures
        .iter()
        .map(|row| {
            let name = row.picture.trim_start_matches("figure ").to_owned();
            cells(
                name,
                format!("{} x {}", row.size[0], row.size[1]),
                counts(row),
            )
        })
        .collect();
    let mut sum = [0; 5];
    for row in &scenes {
        for (sum, count) in sum.iter_mut().zip(counts(row)) {
            *sum += count;
        }
    }
    rows.push(cells(
        format!("{} scenes", scenes.len()),
        String::new(),
        sum,
    ));
    rows
}
