//! The heat map: a row for each scene, a column for each strategy, both formats side by side.

use super::report::Row;
use super::strategy::Strategy;
use crate::draw::{Area, Canvas, INK, MUTED, WHITE, Weight, width};
use crate::error::Result;
use crate::table::grouped;
use ombrage::Picture;

const LABEL: u32 = 156;
const HEAD: u32 = 92;
const CELL: [u32; 2] = [80, 23];
const GAP: u32 = 28;
const FOOT: u32 = 62;
const TEXT: f32 = 12.0;

/// Yellow, grey and navy: light to dark for every colour vision, as in cividis (Nuñez, Anderton,
/// Renslow, "Optimizing colormaps with consideration for color vision deficiency", PLOS ONE 13
/// (2018)).
const SCALE: [[f32; 3]; 3] = [
    [255.0, 234.0, 70.0],
    [124.0, 123.0, 120.0],
    [0.0, 34.0, 78.0],
];

/// No wrong pixel at all.
const NONE: [u8; 3] = WHITE;

/// The largest power of ten of the scale.
const DECADES: f32 = 5.0;

/// Draws the heat map of these rows.
///
/// # Errors
/// If there is no memory for it.
pub fn draw(rows: &[Row]) -> Result<Picture> {
    let mut scenes: Vec<&str> = vec![];
    for row in rows {
        if !scenes.contains(&row.scene.as_str()) {
            scenes.push(&row.scene);
        }
    }
    let strategies: Vec<String> = Strategy::all().into_iter().map(Strategy::name).collect();
    let block = strategies.len() as u32 * CELL[0];
    let bottom = HEAD + scenes.len() as u32 * CELL[1];
    let mut canvas = Canvas::new(LABEL + 2 * block + 2 * GAP, bottom + FOOT)?;
    let title =
        "Wrong shadows, in pixels that face the light: acne, false shadows and leaks together";
    canvas.text(title, [14.0, 26.0], 17.0, Weight::Bold, INK);
    for (place, scene) in scenes.iter().enumerate() {
        let y = HEAD + place as u32 * CELL[1];
        canvas.text(scene, [14.0, y as f32 + 16.0], TEXT, Weight::Regular, INK);
    }
    for (side, float) in (0..).zip(["f32", "f64"]) {
        let left = LABEL + side * (block + GAP);
        canvas.text(float, [left as f32, 54.0], 15.0, Weight::Bold, INK);
        for (column, strategy) in (0..).zip(&strategies) {
            let x = left + column * CELL[0];
            centered(&mut canvas, strategy, x, 80.0, INK);
            for (line, scene) in (0..).zip(&scenes) {
                let is_this = |row: &&Row| {
                    row.scene == **scene && row.float == float && row.strategy == *strategy
                };
                let Some(row) = rows.iter().find(is_this) else {
                    continue;
                };
                let area = Area {
                    left: x,
                    top: HEAD + line * CELL[1],
                    width: CELL[0] - 2,
                    height: CELL[1] - 2,
                };
                cell(&mut canvas, area, row.wrong.shadows());
            }
        }
    }
    legend(&mut canvas, bottom + 18);
    canvas.into_picture()
}

/// A cell: the count on its colour.
fn cell(canvas: &mut Canvas, area: Area, count: usize) {
    let color = color(count);
    canvas.fill(area, |_, _| color);
    let ink = if count == 0 {
        MUTED
    } else if color[1] > 118 {
        INK
    } else {
        WHITE
    };
    let baseline = area.top as f32 + 15.0;
    centered(canvas, &grouped(count as u64), area.left, baseline, ink);
}

fn centered(canvas: &mut Canvas, text: &str, left: u32, baseline: f32, color: [u8; 3]) {
    let space = (CELL[0] - 2) as f32 - width(text, TEXT, Weight::Regular);
    let at = [left as f32 + space / 2.0, baseline];
    canvas.text(text, at, TEXT, Weight::Regular, color);
}

/// The colour of a count: white for 0, then by the logarithm.
fn color(count: usize) -> [u8; 3] {
    if count == 0 {
        return NONE;
    }
    let place = ((count as f32).log10() / DECADES).min(1.0) * 2.0;
    let (from, to) = if place < 1.0 { (0, 1) } else { (1, 2) };
    let part = place - from as f32;
    [0, 1, 2].map(|i| (SCALE[from][i] + part * (SCALE[to][i] - SCALE[from][i])).round() as u8)
}

/// What the colours mean.
fn legend(canvas: &mut Canvas, top: u32) {
    let counts = [0, 1, 10, 100, 1000, 10_000, 100_000];
    for (place, count) in (0..).zip(counts) {
        let area = Area {
            left: LABEL + place * CELL[0],
            top,
            width: CELL[0] - 2,
            height: CELL[1] - 2,
        };
        cell(canvas, area, count);
    }
    canvas.text(
        "pixels",
        [14.0, top as f32 + 15.0],
        TEXT,
        Weight::Regular,
        INK,
    );
}
