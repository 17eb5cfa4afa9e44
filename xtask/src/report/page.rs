//! The page: one HTML file with everything in it.
//!
//! Written with maud: its templates are checked when they are compiled, they escape every value, and
//! they stand beside the code that counts. askama would parse templates of its own while compiling
//! and brings another parser; minijinja has the fewest crates, but finds a wrong name only when it
//! runs.

mod answers;
mod cost;
mod details;
mod diagram;
mod method;
mod picture;
mod proof;
mod words;

pub use picture::Pictures;

use super::data::Data;
use super::headline;
use crate::error::Result;
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("page/style.css");
const SCRIPT: &str = include_str!("page/slider.js");

/// Nothing but what the page itself holds may be loaded.
const POLICY: &str = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; \
    script-src 'unsafe-inline'";

/// The questions, in the order of a newcomer: the anchor, what the menu says, and the answer.
type Section = (&'static str, &'static str, fn(&Data, &Pictures) -> Markup);

const SECTIONS: [Section; 7] = [
    ("what", "What is this?", answers::what),
    ("acne", "What is acne?", answers::acne),
    ("cure", "Which cure should I use?", answers::cure),
    ("cost", "What does it cost?", cost::cost),
    ("trust", "Can I trust f32?", cost::trust),
    ("proof", "How is truth known?", proof::proof),
    ("details", "Details", details::all),
];

/// The whole page.
///
/// # Errors
/// If a picture is not the one that was measured.
pub fn page(data: &Data, pictures: &Pictures) -> Result<String> {
    pictures.are_those_of(data)?;
    let body = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="description" content="What goes wrong in ray-traced shadows, what each \
                    cure costs, how wrong f32 is, and how fast the right answer can be: measured.";
                title { "Ombrage: speed against error in ray-traced shadows" }
                link rel="icon" href="data:,";
                style { (PreEscaped(STYLE)) }
            }
            body {
                a.skip href="#what" { "Skip to the report" }
                header {
                    p.kicker { "Ombrage · the report" }
                    h1 { "Shadows without acne, in " code { "f32" } }
                    p.lede {
                        "A small ray tracer gets its shadows wrong in ways that every beginner meets \
                         and few measure. This page measures them: what goes wrong, which cure works, \
                         what it costs, and how far single precision can be trusted."
                    }
                    nav aria-label="Questions" {
                        @for (anchor, name, _) in &SECTIONS { a href={ "#" (anchor) } { (name) } }
                    }
                }
                main {
                    @for (anchor, name, content) in &SECTIONS {
                        section id=(anchor) aria-labelledby={ (anchor) "-head" } {
                            h2 id={ (anchor) "-head" } { (name) }
                            (content(data, pictures))
                        }
                    }
                }
                footer {
                    p {
                        "Measured on " (data.run.date) " UTC by " code { (data.run.command) } " in "
                        (data.run.seconds) " s on " (data.bench.machine.processor) ". Every number of this page \
                         stands in " code { "data.json" } " beside it."
                    }
                }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    Ok(body.into_string() + "\n")
}

/// The three headline figures as tiles.
fn tiles(data: &Data) -> Markup {
    html! {
        ul.tiles {
            @for headline in headline::all(data) {
                li {
                    strong { (headline.figure) }
                    span { (words::with_code(&headline.sentence)) }
                }
            }
        }
    }
}

/// A plot or picture with the sentence that says what to see.
fn figure(content: &Markup, see: &Markup) -> Markup {
    html! {
        figure {
            (content)
            figcaption { (see) }
        }
    }
}

/// The head of a column, which says how its cells are aligned.
enum Column<'a> {
    Text(&'a str),
    Number(&'a str),
}

impl Column<'_> {
    fn head(&self) -> &str {
        let (Column::Text(head) | Column::Number(head)) = self;
        head
    }

    fn class(&self) -> &'static str {
        match self {
            Column::Text(_) => "text",
            Column::Number(_) => "number",
        }
    }
}

/// A table that scrolls in its own box where the page is too narrow for it.
fn table(name: &str, columns: &[Column], rows: &[Vec<Markup>]) -> Markup {
    html! {
        div.scroll role="region" aria-label=(name) tabindex="0" {
            table {
                caption { (words::with_code(name)) }
                thead {
                    tr {
                        @for column in columns {
                            th scope="col" class=(column.class()) { (words::with_code(column.head())) }
                        }
                    }
                }
                tbody {
                    @for row in rows {
                        tr {
                            @for (place, (cell, column)) in row.iter().zip(columns).enumerate() {
                                @if place == 0 { th scope="row" class=(column.class()) { (cell) } }
                                @else { td class=(column.class()) { (cell) } }
                            }
                        }
                    }
                }
            }
        }
    }
}
