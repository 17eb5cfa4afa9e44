//! The sheet of an annotated figure: the picture, a panel to its right, a caption below.

use super::view::View;
use crate::draw::{self, Area, BLACK, Canvas, INK, MUTED, Pen, WHITE, Weight};
use crate::error::Result;
use ombrage::Picture;

/// Sizes in units of the layout; a unit is a pixel where the picture is 600x400.
const PICTURE: [f32; 2] = [600.0, 400.0];
const PANEL: f32 = 240.0;
const CAPTION: f32 = 58.0;
const MARGIN: f32 = 14.0;
const TITLE: f32 = 17.0;
const TEXT: f32 = 12.5;

/// One bar of a chart.
pub struct Bar {
    /// Its height, in units of the chart.
    pub value: u8,
    /// Its colour.
    pub color: [u8; 3],
}

/// A sheet that fills from top to bottom of its panel.
pub struct Sheet {
    canvas: Canvas,
    unit: f32,
    enlarged: u32,
    picture: Area,
    panel: Area,
    /// Where the next thing in the panel goes, in canvas pixels.
    y: f32,
}

impl Sheet {
    /// A sheet with the picture on it, pixel for pixel.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub fn new(view: &View, pixel: impl Fn(u32, u32) -> [u8; 3]) -> Result<Self> {
        let unit = view.unit();
        let px = |units: f32| (units * unit).round() as u32;
        let [width, height] = view.canvas_size();
        let (columns, rows) = (width.max(px(PICTURE[0])), height.max(px(PICTURE[1])));
        let mut canvas = Canvas::new(columns + px(PANEL), rows + px(CAPTION))?;
        let picture = Area {
            left: (columns - width) / 2,
            top: (rows - height) / 2,
            width,
            height,
        };
        canvas.fill(picture, |x, y| pixel(x / view.enlarged, y / view.enlarged));
        let panel = Area {
            left: columns + px(MARGIN),
            top: 0,
            width: px(PANEL) - 2 * px(MARGIN),
            height: rows,
        };
        Ok(Self {
            canvas,
            unit,
            enlarged: view.enlarged,
            picture,
            panel,
            y: MARGIN * unit,
        })
    }

    /// A length of the layout in canvas pixels.
    pub fn px(&self, units: f32) -> f32 {
        units * self.unit
    }

    /// A pen of a width in units.
    pub fn pen(&self, color: [u8; 3], width: f32, rim: [u8; 3]) -> Pen {
        Pen {
            color,
            width: self.px(width),
            rim,
        }
    }

    /// The pen of frames and leaders that say only where something is. Thinner, a white line between
    /// two rows of pixels would blend with its black rim into the grey of the background.
    pub fn plain_pen(&self) -> Pen {
        self.pen(WHITE, 1.5, BLACK)
    }

    /// What is drawn on, for what the sheet itself has no word for.
    pub fn canvas(&mut self) -> &mut Canvas {
        &mut self.canvas
    }

    /// The canvas area of an area of the picture.
    pub fn on_picture(&self, area: Area) -> Area {
        Area {
            left: self.picture.left + area.left * self.enlarged,
            top: self.picture.top + area.top * self.enlarged,
            width: area.width * self.enlarged,
            height: area.height * self.enlarged,
        }
    }

    /// Leaves a gap in the panel, in units.
    pub fn gap(&mut self, units: f32) {
        self.y += self.px(units);
    }

    /// A heading in the panel.
    pub fn heading(&mut self, words: &str) {
        self.paragraph(words, 0.0, Weight::Bold, INK);
    }

    /// Text in the panel, broken into lines.
    pub fn text(&mut self, words: &str) {
        self.paragraph(words, 0.0, Weight::Regular, INK);
    }

    /// A mark and what it means.
    pub fn key(&mut self, color: [u8; 3], words: &str) {
        let side = self.px(TEXT * 0.8);
        let area = Area {
            left: self.panel.left,
            top: (self.y + self.px(TEXT) * 0.25).round() as u32,
            width: side.round() as u32,
            height: side.round() as u32,
        };
        self.canvas.fill(area, |_, _| INK);
        let rim = self.px(1.0).round() as u32;
        self.canvas.fill(area.shrunk(rim), |_, _| color);
        self.paragraph(words, TEXT * 1.3, Weight::Regular, INK);
    }

    fn paragraph(&mut self, words: &str, indent: f32, weight: Weight, color: [u8; 3]) {
        let size = self.px(TEXT);
        let left = self.panel.left as f32 + self.px(indent);
        let room = self.panel.edges()[2] - left;
        for line in lines(words, size, weight, room) {
            self.y += 1.3 * size;
            let baseline = self.y - 0.28 * size;
            self.canvas
                .text(&line, [left, baseline], size, weight, color);
        }
    }

    /// The next area of the panel that holds `columns` x `rows` pixels enlarged as much as the panel's
    /// width and `most` units of height allow, and how much that is.
    pub fn inset(&mut self, columns: u32, rows: u32, most: f32) -> (Area, u32) {
        let height = self.px(most) as u32;
        let cell = (self.panel.width / columns).min(height / rows).max(1);
        let area = Area {
            left: self.panel.left,
            top: self.y.round() as u32,
            width: (columns * cell).min(self.panel.width),
            height: (rows * cell).min(height),
        };
        self.y += area.height as f32;
        (area, cell)
    }

    /// Fills an inset with a part of the picture, each pixel `cell` wide and high.
    pub fn enlarge(&mut self, shown: &Picture, part: Area, inset: Area, cell: u32) {
        self.canvas.fill(inset, |x, y| {
            let pixel = shown.pixel(part.left + x / cell, part.top + y / cell);
            pixel.unwrap_or_default()
        });
    }

    /// Dots the marked pixels of an enlarged part.
    pub fn dot(
        &mut self,
        is_marked: impl Fn(u32, u32) -> bool,
        color: [u8; 3],
        part: Area,
        inset: Area,
        cell: u32,
    ) {
        for y in (0..part.height).filter(|y| (y + 1) * cell <= inset.height) {
            for x in 0..part.width {
                let pixel = Area {
                    left: inset.left + x * cell,
                    top: inset.top + y * cell,
                    width: cell,
                    height: cell,
                };
                if is_marked(part.left + x, part.top + y) {
                    self.canvas.fill(pixel.shrunk(cell / 4), |_, _| color);
                }
            }
        }
    }

    /// A chart of values, one bar each; a value of `most` fills the height.
    pub fn bars(&mut self, bars: &[Bar], most: u32) {
        let area = Area {
            left: self.panel.left,
            top: self.y.round() as u32,
            width: self.panel.width,
            height: self.px(90.0) as u32,
        };
        self.canvas.fill(area, |x, y| {
            let number = u64::from(x) * bars.len() as u64 / u64::from(area.width);
            let from_below = u64::from(area.height - y) * u64::from(most);
            match bars.get(number as usize) {
                Some(bar) if from_below <= u64::from(bar.value) * u64::from(area.height) => {
                    bar.color
                }
                _ => WHITE,
            }
        });
        let pen = self.plain_pen();
        self.canvas.frame(
            area,
            Pen {
                color: MUTED,
                rim: WHITE,
                ..pen
            },
        );
        self.y += area.height as f32;
    }

    /// Puts a whole picture into the panel, reduced to its width; says where.
    pub fn map(&mut self, picture: &Picture) -> Area {
        let size = picture.size();
        let (width, height) = (f64::from(size.width()), f64::from(size.height()));
        let reduced = (f64::from(self.panel.width) / width).min(f64::from(self.px(200.0)) / height);
        let area = Area {
            left: self.panel.left,
            top: self.y.round() as u32,
            width: ((width * reduced) as u32).max(1),
            height: ((height * reduced) as u32).max(1),
        };
        // The pixels under one canvas pixel: at least one, also where the map is an enlargement.
        let under = |n: u32, whole: u32, to: u32| {
            let edge = |n: u32| (u64::from(n) * u64::from(whole) / u64::from(to)) as u32;
            edge(n)..edge(n + 1).max(edge(n) + 1)
        };
        self.canvas.fill(area, |x, y| {
            let (mut sum, mut count) = ([0; 3], 0);
            for row in under(y, size.height(), area.height) {
                for column in under(x, size.width(), area.width) {
                    let pixel = picture.pixel(column, row).unwrap_or_default();
                    sum = [0, 1, 2].map(|i| sum[i] + u32::from(pixel[i]));
                    count += 1;
                }
            }
            sum.map(|total| (total / count) as u8)
        });
        self.y += area.height as f32;
        area
    }

    /// Frames a part of the picture and an inset, and joins the two.
    pub fn join(&mut self, part: Area, inset: Area, pen: Pen) {
        let part = self.on_picture(part);
        let [_, top, right, bottom] = part.edges();
        let [left, inset_top, _, inset_bottom] = inset.edges();
        let away = 1.5 * pen.width;
        self.canvas.line(
            [right + away, top - away],
            [left - away, inset_top - away],
            pen,
        );
        self.canvas.line(
            [right + away, bottom + away],
            [left - away, inset_bottom + away],
            pen,
        );
        self.canvas.frame(part, pen);
        self.canvas.frame(inset, pen);
    }

    /// The caption below, and the finished sheet.
    ///
    /// # Errors
    /// If the sheet has more pixels than a picture may have.
    pub fn finish(mut self, title: &str, detail: &str) -> Result<Picture> {
        let left = self.px(MARGIN);
        let below = self.panel.height as f32;
        let title_at = [left, below + self.px(25.0)];
        let detail_at = [left, below + self.px(45.0)];
        let (title_size, size) = (self.px(TITLE), self.px(TEXT));
        self.canvas
            .text(title, title_at, title_size, Weight::Bold, INK);
        self.canvas
            .text(detail, detail_at, size, Weight::Regular, MUTED);
        self.canvas.into_picture()
    }
}

/// Breaks text between words into lines no wider than `room`; a longer word stays whole.
fn lines(words: &str, size: f32, weight: Weight, room: f32) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for word in words.split(' ') {
        if let Some(line) = lines.last_mut() {
            let longer = format!("{line} {word}");
            if draw::width(&longer, size, weight) <= room {
                *line = longer;
                continue;
            }
        }
        lines.push(word.to_owned());
    }
    lines
}
