//! The picture that was handed in, its faults marked, with a legend.

use super::read::Submission;
use super::report;
use crate::draw::{Area, BLACK, GREEN, SKY, YELLOW, outline};
use crate::error::Result;
use crate::figures::sheet::Sheet;
use crate::figures::view::View;
use crate::table::grouped;
use ombrage::Picture;
use ombrage::conformance::diagnosis::{Code, Diagnosis, Finding};

/// The colours of marks, one a finding, in turns.
const COLORS: [[u8; 3]; 3] = [YELLOW, SKY, GREEN];

/// The annotated picture.
///
/// # Errors
/// If there is no memory for it.
pub fn annotate(submission: &Submission, diagnosis: &Diagnosis) -> Result<Picture> {
    let picture = &submission.picture;
    let size = picture.size();
    let view = View::of(size);
    let speckled = diagnosis
        .findings
        .iter()
        .zip(COLORS.into_iter().cycle())
        .find(|(finding, _)| finding.code == Code::Acne);
    let dots = speckled.map(|(finding, color)| (set_of(finding, size.pixels()), color));
    let mut sheet = Sheet::new(&view, |x, y| {
        let (x, y) = (x * view.every, y * view.every);
        let at = (y * size.width() + x) as usize;
        match &dots {
            Some((acne, color)) if acne[at] => *color,
            _ => picture.pixel(x, y).unwrap_or_default(),
        }
    })?;
    sheet.heading(diagnosis.verdict.name());
    for (finding, color) in diagnosis.findings.iter().zip(COLORS.into_iter().cycle()) {
        if finding.code != Code::Acne {
            mark(&mut sheet, &view, finding, size.width(), color);
        }
        let pixels = grouped(finding.pixels as u64);
        sheet.gap(7.0);
        sheet.key(color, &format!("{}: {pixels} pixels", finding.code.name()));
        sheet.text(&finding.message);
    }
    if diagnosis.findings.is_empty() {
        sheet.text(&report::headline(diagnosis));
    }
    let title = format!("Handed in as Figure {}", diagnosis.figure);
    let (width, height) = (size.width(), size.height());
    let conventions = report::in_words(submission, diagnosis);
    sheet.finish(&title, &format!("{width} × {height} pixels; {conventions}"))
}

/// Draws around the pixels of a finding; around the rectangle of all where they are scattered.
fn mark(sheet: &mut Sheet, view: &View, finding: &Finding, width: u32, color: [u8; 3]) {
    let Some(region) = finding.region else {
        return;
    };
    let scaled = Area {
        left: region.left / view.every,
        top: region.top / view.every,
        width: (region.width / view.every).max(1),
        height: (region.height / view.every).max(1),
    };
    let pen = sheet.pen(color, 1.6, BLACK);
    let full = u64::from(region.width) * u64::from(region.height);
    if finding.places.is_empty() || finding.pixels as u64 * 20 < full {
        let area = sheet.on_picture(scaled);
        sheet.canvas().frame(area, pen);
        return;
    }
    let last = finding.places.last().map_or(0, |&at| at + 1);
    let set = set_of(finding, last);
    let within = |x: u32, y: u32| {
        let at = (y * view.every * width + x * view.every) as usize;
        set.get(at).copied().unwrap_or(false)
    };
    let path = outline(scaled, within, |x, y| {
        let corner = Area {
            left: x,
            top: y,
            width: 0,
            height: 0,
        };
        let [left, top, ..] = sheet.on_picture(corner).edges();
        [left, top]
    });
    if let Some(path) = path {
        sheet.canvas().stroke(&path, pen);
    }
}

/// Which pixels show a finding.
fn set_of(finding: &Finding, pixels: usize) -> Vec<bool> {
    let mut set = vec![false; pixels];
    for &at in &finding.places {
        set[at] = true;
    }
    set
}
