//! What is written and drawn beside each figure.

use super::sheet::{Bar, Sheet};
use super::study::Study;
use crate::draw::{Area, BLACK, GREEN, SKY, WHITE, YELLOW, outline};
use crate::error::Result;
use crate::table::grouped;
use ombrage::{Detail, Figure, Picture, Size};

/// The pieces that Figures 3(a) and 3(c) enlarge: their middle in hundredths of the picture, and
/// their columns and rows.
const PIECE_OF_SPHERE: [u32; 2] = [54, 41];
const PIECE_OF_PLANE: [u32; 2] = [84, 72];
const PIECE: [u32; 2] = [26, 17];

/// Whether a figure has a sheet: all but Figure 1, which needs no words.
pub fn is_annotated(figure: &Figure) -> bool {
    figure.name != "1"
}

/// The sheet of a figure.
///
/// # Errors
/// If there is no memory for it.
pub fn annotate(study: &Study) -> Result<Picture> {
    if let (Some(detail), Some(whole)) = (study.figure.detail, &study.whole) {
        return enlarged(study, detail, whole);
    }
    match study.figure.name {
        "2a" | "2b" => too_bright(study),
        "3a" => acne(study),
        _ => shadow(study),
    }
}

/// Figures 2(a) and 2(b): where a component passes 255.
fn too_bright(study: &Study) -> Result<Picture> {
    let mut sheet = sheet_of(study, |_, _| None)?;
    let counts = &study.findings.counts;
    match study.findings.bounds {
        None => sheet.text("No pixel of this size passes 255."),
        Some(bounds) => {
            let pen = sheet.pen(GREEN, 1.6, WHITE);
            let part = around(bounds, 4.max(bounds.width / 16), study.view.shown);
            let (inset, cell) = sheet.inset(part.width, part.height, 150.0);
            sheet.enlarge(&study.shown, part, inset, cell);
            sheet.join(bounds, inset, pen);
            let framed = Area {
                left: inset.left + (bounds.left - part.left) * cell,
                top: inset.top + (bounds.top - part.top) * cell,
                width: bounds.width * cell,
                height: bounds.height * cell,
            };
            sheet.canvas().frame(framed, pen);
            sheet.gap(10.0);
            let number = grouped(study.findings.marks);
            let largest = counts.largest_level;
            if study.figure.name == "2a" {
                sheet.heading(&format!("{number} pixels pass 255 and wrap"));
                let byte = largest % 256;
                sheet.text(&format!("Largest: {largest}, which becomes {byte}."));
            } else {
                sheet.heading(&format!("{number} pixels pass 255, clamped"));
                sheet.text(&format!("Largest: {largest}, which becomes 255."));
            }
            column(study, &mut sheet, bounds);
        }
    }
    finish(study, sheet)
}

/// A chart of the bytes down the column in the middle of the bright pixels.
fn column(study: &Study, sheet: &mut Sheet, bounds: Area) {
    let x = bounds.left + bounds.width / 2;
    sheet.gap(16.0);
    sheet.heading(&format!("Bytes down column {}", x * study.view.every));
    sheet.gap(5.0);
    let first = bounds.top.saturating_sub(bounds.height / 2);
    let last = (bounds.top + 8 * bounds.height).min(study.shown.size().height());
    let bars: Vec<Bar> = (first..last)
        .map(|y| {
            let color = study.shown.pixel(x, y).unwrap_or_default();
            let value = color.into_iter().max().unwrap_or(0);
            Bar { value, color }
        })
        .collect();
    sheet.bars(&bars, 255);
    let every = study.view.every;
    let (first, last) = (first * every, (last - 1) * every);
    sheet.gap(3.0);
    sheet.text(&format!("rows {first} to {last}; height: 0 to 255"));
}

/// Figure 3(a): the pixels that are falsely black.
fn acne(study: &Study) -> Result<Picture> {
    let findings = study.findings;
    let mut sheet = sheet_of(study, |x, y| findings.is_marked(x, y).then_some(YELLOW))?;
    sheet.heading("Acne: falsely black");
    sheet.key(YELLOW, "the surface shadows itself");
    pieces(study, &mut sheet, Some(YELLOW));
    finish(study, sheet)
}

/// Figure 3(b): which part is enlarged.
fn enlarged(study: &Study, detail: Detail, whole: &Picture) -> Result<Picture> {
    let mut sheet = sheet_of(study, |_, _| None)?;
    let [left, top, width, height] = detail.region(study.size);
    sheet.heading("Where this is in Figure 3(a)");
    sheet.gap(5.0);
    let map = sheet.map(whole);
    let scale =
        |n: u32, from: u32, to: u32| (u64::from(n) * u64::from(to) / u64::from(from)).max(1) as u32;
    let part = Area {
        left: map.left
            + (u64::from(left) * u64::from(map.width) / u64::from(study.size.width())) as u32,
        top: map.top
            + (u64::from(top) * u64::from(map.height) / u64::from(study.size.height())) as u32,
        width: scale(width, study.size.width(), map.width),
        height: scale(height, study.size.height(), map.height),
    };
    let pen = sheet.pen(YELLOW, 1.6, BLACK);
    sheet.canvas().frame(part, pen);
    sheet.gap(12.0);
    sheet.heading(&format!("{width} × {height} pixels from ({left}, {top})"));
    sheet.text(&format!("each enlarged {0} × {0}", detail.factor));
    sheet.text(&format!("bytes times {}, up to 255", detail.gain));
    finish(study, sheet)
}

/// Figure 3(c): the shadow, and nothing else that is black.
fn shadow(study: &Study) -> Result<Picture> {
    let mut sheet = sheet_of(study, |_, _| None)?;
    let findings = study.findings;
    if let Some(bounds) = findings.bounds {
        let path = outline(
            bounds,
            |x, y| findings.is_marked(x, y),
            |x, y| {
                let corner = Area {
                    left: x,
                    top: y,
                    width: 0,
                    height: 0,
                };
                let [left, top, ..] = sheet.on_picture(corner).edges();
                [left, top]
            },
        );
        let pen = sheet.pen(SKY, 2.0, BLACK);
        if let Some(path) = path {
            sheet.canvas().stroke(&path, pen);
        }
    }
    sheet.heading("Shadow, and no acne");
    let number = grouped(findings.counts.shadowed as u64);
    sheet.key(SKY, &format!("{number} pixels in shadow"));
    pieces(study, &mut sheet, None);
    finish(study, sheet)
}

/// A piece of the sphere and one of the plane, enlarged, each with its count of acne.
fn pieces(study: &Study, sheet: &mut Sheet, mark: Option<[u8; 3]>) {
    let counts = &study.findings.counts;
    let [across, down] = PIECE;
    for (name, percent, acne, lit) in [
        (
            "Sphere",
            PIECE_OF_SPHERE,
            counts.acne_sphere,
            counts.lit_sphere,
        ),
        ("Plane", PIECE_OF_PLANE, counts.acne_plane, counts.lit_plane),
    ] {
        sheet.gap(7.0);
        let part = study.view.part(percent, across, down);
        let (inset, cell) = sheet.inset(part.width, part.height, 136.0);
        sheet.enlarge(&study.shown, part, inset, cell);
        if let Some(color) = mark {
            let is_marked = |x, y| study.findings.is_marked(x, y);
            sheet.dot(is_marked, color, part, inset, cell);
        }
        let pen = sheet.plain_pen();
        sheet.join(part, inset, pen);
        sheet.gap(4.0);
        let text = match (acne, lit) {
            (_, 0) => "no pixel is lit".to_owned(),
            (0, _) => format!("no acne on {} lit pixels", grouped(lit as u64)),
            _ => {
                let share = 100.0 * acne as f64 / lit as f64;
                let (acne, lit) = (grouped(acne as u64), grouped(lit as u64));
                format!("{acne} of {lit} lit ({share:.1}\u{a0}%)")
            }
        };
        sheet.text(&format!("{name}: {text}"));
    }
}

/// The sheet with the figure on it, some of its pixels in another colour.
fn sheet_of(study: &Study, mark: impl Fn(u32, u32) -> Option<[u8; 3]>) -> Result<Sheet> {
    Sheet::new(&study.view, |x, y| {
        mark(x, y).unwrap_or_else(|| study.shown.pixel(x, y).unwrap_or_default())
    })
}

/// The caption: what the figure is, and of which picture.
fn finish(study: &Study, sheet: Sheet) -> Result<Picture> {
    let (number, letter) = study.figure.name.split_at(1);
    let title = format!("Figure {number}({letter}): {}", study.figure.title);
    let (width, height) = (study.size.width(), study.size.height());
    let mut detail = format!("{width} × {height} pixels, {}", study.float);
    if study.view.every > 1 {
        detail += &format!("; one pixel in {0} × {0} is shown", study.view.every);
    }
    if study.view.enlarged > 1 {
        detail += &format!("; each is shown {0} × {0}", study.view.enlarged);
    }
    sheet.finish(&title, &detail)
}

/// The area with a border of `by` pixels, as far as the picture goes.
fn around(area: Area, by: u32, size: Size) -> Area {
    let (left, top) = (area.left.saturating_sub(by), area.top.saturating_sub(by));
    Area {
        left,
        top,
        width: (area.left + area.width + by).min(size.width()) - left,
        height: (area.top + area.height + by).min(size.height()) - top,
    }
}
