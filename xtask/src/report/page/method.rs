//! The tables of errors and clauses, and how everything was measured.

use super::Column::{Number, Text};
use super::table;
use super::words::{whole, with_code};
use crate::report::data::Data;
use maud::{Markup, html};

/// All of it.
pub fn all(data: &Data) -> Markup {
    html! {
        h3 { "Allowed and measured errors" }
        p {
            "Every kernel, quality and format on all of its test vectors. " code { "k u B" } ": at most k \
             times the a-priori bound of the case; " code { "n ulp" } ": at most n units in the last place \
             of the exact value, every decision right; " code { "exact" } ": a decision or whole number, and \
             right. A test fails where an error is larger than allowed, and where less could be allowed."
        }
        (table("Allowed and measured errors", &[Text("kernel"), Text("quality"), Text("float"), Text("allowed"), Number("measured"), Number("cases"), Number("wrong"), Number("beyond"), Text("why no less")], &errors(data)))
        (table("Known failures: families of vectors in which a case is beyond what is allowed",
            &["kernel", "qualities", "floats", "families", "why"].map(Text), &known(data)))
        h3 { "The clauses and their tests" }
        p { "What must be true, from " code { "docs/spec.md" } ". Each test has a control that conforms and \
             wrong variants that it must reject." }
        (table("Clauses", &["clause", "what it asks", "item", "test", "figure"].map(Text), &clauses(data)))
        h3 { "How it was measured" }
        (run(data))
    }
}

fn errors(data: &Data) -> Vec<Vec<Markup>> {
    let rows = data.errors.iter().map(|row| {
        let wrong = row.decisions + row.roots;
        vec![
            html! { code { (row.kernel) } },
            html! { (row.quality) },
            html! { (row.float) },
            html! { (row.allowed) },
            html! { (row.measured) },
            html! { (whole(row.cases)) },
            html! { (whole(wrong)) },
            html! { (whole(row.beyond)) },
            html! { (row.reason) },
        ]
    });
    rows.collect()
}

fn known(data: &Data) -> Vec<Vec<Markup>> {
    let rows = data.known_failures.iter().map(|known| {
        vec![
            html! { code { (known.kernel) } },
            html! { (known.qualities.join(", ")) },
            html! { (known.floats.join(", ")) },
            html! { (known.families.join(", ")) },
            html! { (known.reason) },
        ]
    });
    rows.collect()
}

fn clauses(data: &Data) -> Vec<Vec<Markup>> {
    let rows = data.clauses.iter().map(|clause| {
        vec![
            html! { (clause.id) },
            html! { (clause.title) },
            html! { code { (clause.item) } },
            html! { code { (clause.test) } },
            html! { (clause.figure) },
        ]
    });
    rows.collect()
}

fn run(data: &Data) -> Markup {
    let (run, machine) = (&data.run, &data.bench.machine);
    let facts = [
        ("date", format!("{} UTC", run.date)),
        ("command", format!("`{}`, {} s", run.command, run.seconds)),
        (
            "processor",
            format!("{}, {} threads", machine.processor, machine.cores),
        ),
        ("levels", machine.levels.join(", ")),
        (
            "system",
            format!("{} {}", machine.system, machine.architecture),
        ),
        (
            "load at the start",
            machine
                .load
                .map_or("unknown".into(), |load| format!("{load:.2}")),
        ),
        ("kit", format!("ombrage {}", run.version)),
        ("compiler", run.compiler.clone()),
    ];
    html! {
        dl {
            @for (name, fact) in &facts { dt { (name) } dd { (with_code(fact)) } }
        }
        ul {
            li { "Errors and counts are the same on every machine and at every level; times are not. Times \
                 are medians of runs in turns, so that a machine that slows down slows all alike." }
            li { "The truth of a picture is computed in double-double, and its decisions by another method \
                 than those it judges; pixels that double-double cannot decide are left out of the counts \
                 of shadows." }
            li { "Of the 256 values k/255, truncating the rounded product 255 x gives another byte than the \
                 exact product for " (data.quantise.f64) " in " code { "f64" } " and " (data.quantise.f32)
                 " in " code { "f32" } "; the kit's film for " (data.quantise.kit) "." }
            li { "To measure again: " code { "cargo xtask report" } "; to redraw from the data: "
                 code { "cargo xtask report --from docs/report/data.json" } "." }
        }
    }
}
