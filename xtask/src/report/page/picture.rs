//! The pictures of the lab's figures, inside the page.

use crate::error::{Error, Result};
use crate::figures::Drawn;
use crate::report::data::Data;
use crate::report::measure;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, html};
use ombrage::Picture;
use png::{BitDepth, ColorType, Compression, Encoder, Filter};

/// All figures, drawn.
pub struct Pictures(Vec<Drawn>);

impl Pictures {
    /// These figures.
    pub fn new(drawn: Vec<Drawn>) -> Self {
        Self(drawn)
    }

    /// The figures.
    pub fn drawn(&self) -> &[Drawn] {
        &self.0
    }

    /// Says whether the data are about these pictures.
    ///
    /// # Errors
    /// If the code draws other pictures than those that were measured.
    pub fn are_those_of(&self, data: &Data) -> Result<()> {
        for drawn in &self.0 {
            let figure = measure::figure(drawn);
            if !data.figures.contains(&figure) {
                return Err(Error::new(format!(
                    "figure {} is not the one that data.json was measured with; measure anew with: \
                     cargo xtask report",
                    figure.name
                )));
            }
        }
        Ok(())
    }

    /// A figure as computed.
    pub fn plain(&self, name: &str, alt: &str) -> Markup {
        self.0
            .iter()
            .find(|drawn| drawn.figure.name == name)
            .map_or(html! {}, |drawn| image(&drawn.picture, alt))
    }

    /// A figure with marks on some of its pixels: column, row, kind, and what the mark says.
    pub fn marked(&self, name: &str, alt: &str, marks: &[([u32; 2], &str, String)]) -> Markup {
        let Some(drawn) = self.0.iter().find(|drawn| drawn.figure.name == name) else {
            return html! {};
        };
        let size = drawn.picture.size();
        let (width, height) = (size.width(), size.height());
        html! {
            svg.marked viewBox={ "0 0 " (width) " " (height) } role="img" aria-label=(alt) {
                image href=(source(&drawn.picture)) width=(width) height=(height) {}
                @for ([column, row], kind, says) in marks {
                    g class=(kind) {
                        title { (says) }
                        circle cx={ (column) ".5" } cy={ (row) ".5" } r="4" {}
                    }
                }
            }
        }
    }

    /// A figure with its notes.
    pub fn annotated(&self, name: &str, alt: &str) -> Markup {
        let drawn = self.0.iter().find(|drawn| drawn.figure.name == name);
        let sheet = drawn.and_then(|drawn| drawn.sheet.as_ref());
        sheet.map_or(html! {}, |sheet| image(sheet, alt))
    }

    /// Two figures of which a slider shows more of the one or of the other; without a script, both
    /// side by side.
    pub fn slider(&self, left: [&str; 3], right: [&str; 3]) -> Markup {
        let name = format!("Figure {} or {}", left[0], right[0]);
        html! {
            div.slider {
                @for (side, [figure, label, alt]) in [("left", left), ("right", right)] {
                    div class={ "half " (side) } {
                        (self.plain(figure, alt))
                        span.tag { (label) }
                    }
                }
                input type="range" min="0" max="100" value="50" step="1" hidden aria-label={
                    "How much of the left picture is shown. " (name)
                };
            }
        }
    }
}

/// A picture inside the page.
fn image(picture: &Picture, alt: &str) -> Markup {
    let size = picture.size();
    html! {
        img src=(source(picture)) alt=(alt) width=(size.width()) height=(size.height());
    }
}

fn source(picture: &Picture) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(encode(picture)))
}

/// As small as PNG makes it.
fn encode(picture: &Picture) -> Vec<u8> {
    let mut bytes = vec![];
    let size = picture.size();
    let mut encoder = Encoder::new(&mut bytes, size.width(), size.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_filter(Filter::NoFilter);
    // Writing to memory does not fail, and a picture has the bytes its size says.
    if let Ok(mut writer) = encoder.write_header() {
        let _ = writer.write_image_data(picture.bytes());
    }
    bytes
}
