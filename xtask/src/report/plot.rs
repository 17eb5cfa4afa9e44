//! Plots as SVG, drawn with kuva.
//!
//! Of the two crates that draw plots without a browser, `plotters` and `kuva`, only `kuva` writes a
//! `<title>` into every mark and takes any CSS colour, so that `currentColor` and variables follow
//! the page from light to dark; it has log axes, brings five small crates, and is released often.
//! `plotters` (last released in 2024) writes fixed RGB colours and no titles, and would have
//! needed a backend of our own. What is left to do here: labels beside the marks they name, lines
//! with titles, and an opening tag that scales with the page and names the plot for a reader who
//! cannot see it.

mod label;

use kuva::backend::svg::SvgBackend;
use kuva::plot::annotations::ReferenceLine;
use kuva::plot::scatter::{MarkerShape, ScatterPlot};
use kuva::render::layout::{ComputedLayout, Layout, TickFormat};
use kuva::render::plots::Plot as KuvaPlot;
use kuva::render::render::{Primitive, Scene, TextAnchor, render_multiple};
use kuva::render::theme::Theme;
use label::Area;
use maud::{Markup, PreEscaped, html};
use std::sync::Arc;

/// A colour of the page: its variable, which is lighter on a dark page. All are Okabe and Ito's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Color {
    /// The kit's own way.
    Blue,
    /// The lab's way.
    Vermillion,
    /// A third.
    Green,
    /// A fourth.
    Purple,
    /// Whatever stands back.
    Grey,
}

impl Color {
    /// As CSS writes it.
    pub fn css(self) -> &'static str {
        match self {
            Color::Blue => "var(--blue)",
            Color::Vermillion => "var(--vermillion)",
            Color::Green => "var(--green)",
            Color::Purple => "var(--purple)",
            Color::Grey => "var(--muted)",
        }
    }
}

/// How large a plot is drawn. Text has the same size in both, so a phone shows the small one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Width {
    /// For a column of text on a desk.
    Wide,
    /// For a phone.
    Narrow,
}

impl Width {
    /// In pixels.
    fn pixels(self) -> f64 {
        match self {
            Width::Wide => 580.0,
            Width::Narrow => 340.0,
        }
    }

    /// One of two values.
    fn of<T>(self, wide: T, narrow: T) -> T {
        match self {
            Width::Wide => wide,
            Width::Narrow => narrow,
        }
    }
}

/// An axis.
pub struct Axis {
    /// What it counts, with the unit.
    pub label: String,
    /// From where to where.
    pub range: [f64; 2],
    /// How values stand on it.
    pub scale: Scale,
    /// What is written at a value of it.
    pub format: Arc<dyn Fn(f64) -> String + Send + Sync>,
}

/// How values stand on an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// Evenly, with a tick at every multiple of this step.
    Linear(f64),
    /// By their logarithm, with ticks at 1, 2 and 5.
    Log,
    /// By their logarithm, with a tick at every so manieth power of ten, however small; across a
    /// narrow plot at every second of those.
    Decades(u32),
}

impl Axis {
    fn place(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Decades(_) => value.log10(),
            _ => value,
        }
    }

    fn ends(&self) -> [f64; 2] {
        self.range.map(|end| self.place(end))
    }

    fn ticks(&self) -> TickFormat {
        let (format, scale) = (self.format.clone(), self.scale);
        TickFormat::Custom(Arc::new(move |place| {
            format(match scale {
                Scale::Decades(_) => 10f64.powf(place.round()),
                _ => place,
            })
        }))
    }
}

/// A mark.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Where.
    pub at: [f64; 2],
    /// What its `<title>` says.
    pub title: String,
    /// What is written beside it.
    pub label: Option<String>,
}

/// Marks that belong together.
pub struct Series {
    /// Their name, the `<title>` of their line.
    pub name: String,
    /// Their colour.
    pub color: Color,
    /// Their shape.
    pub shape: MarkerShape,
    /// Their radius in pixels.
    pub size: f64,
    /// Whether a line joins them.
    pub joined: bool,
    /// The marks.
    pub marks: Vec<Mark>,
}

/// A plot.
pub struct Plot {
    /// A name that no other plot of the page has.
    pub id: String,
    /// What it shows, for a reader who cannot see it.
    pub alt: String,
    /// The axis across.
    pub x: Axis,
    /// The axis upward.
    pub y: Axis,
    /// Its height in pixels, wide and narrow.
    pub heights: [f64; 2],
    /// What is drawn.
    pub series: Vec<Series>,
    /// Dashed lines across, each at a value and with a label.
    pub levels: Vec<(f64, String)>,
}

const TEXT: u32 = 13;

impl Plot {
    /// Draws it in both widths; the page shows the one that fits.
    pub fn markup(&self) -> Markup {
        html! { (self.svg(Width::Wide)) (self.svg(Width::Narrow)) }
    }

    fn svg(&self, width: Width) -> Markup {
        let layout = self.layout(width);
        let computed = ComputedLayout::from_layout(&layout);
        let marks = self.series.iter().map(|series| series.scatter(self));
        let mut scene = render_multiple(marks.collect(), layout);
        for series in &self.series {
            series.line(self, &computed, &mut scene);
        }
        self.label(&computed, &mut scene);
        PreEscaped(self.embed(&SvgBackend::new().render_scene(&scene), width))
    }

    fn layout(&self, width: Width) -> Layout {
        let ink = || "currentColor".to_owned();
        let theme = Theme {
            background: "none".into(),
            axis_color: "var(--rule)".into(),
            grid_color: "var(--grid)".into(),
            tick_color: "var(--rule)".into(),
            text_color: ink(),
            font_family: Some("inherit".into()),
            ..Theme::light()
        };
        let ([left, right], [bottom, top]) = (self.x.ends(), self.y.ends());
        let mut layout = Layout::new((left, right), (bottom, top))
            .with_theme(theme)
            .with_width(width.pixels())
            .with_height(self.height(width))
            .with_x_axis_min(left)
            .with_x_axis_max(right)
            .with_y_axis_min(bottom)
            .with_y_axis_max(top)
            .with_x_label(self.x.label.clone())
            .with_y_label(self.y.label.clone())
            .with_x_tick_format(self.x.ticks())
            .with_y_tick_format(self.y.ticks())
            .with_label_size(TEXT)
            .with_tick_size(TEXT)
            .with_body_size(TEXT);
        layout = match self.x.scale {
            Scale::Log => layout.with_log_x(),
            Scale::Linear(step) => layout.with_x_tick_step(step),
            Scale::Decades(step) => layout.with_x_tick_step(f64::from(width.of(step, 2 * step))),
        };
        layout = match self.y.scale {
            Scale::Log => layout.with_log_y(),
            Scale::Linear(step) => layout.with_y_tick_step(step),
            Scale::Decades(step) => layout.with_y_tick_step(f64::from(step)),
        };
        for (value, label) in &self.levels {
            let line = ReferenceLine::horizontal(self.y.place(*value))
                .with_color("var(--muted)")
                .with_label(label.clone());
            layout = layout.with_reference_line(line);
        }
        layout
    }

    fn height(&self, width: Width) -> f64 {
        let [wide, narrow] = self.heights;
        width.of(wide, narrow)
    }

    fn place(&self, mark: &Mark, computed: &ComputedLayout) -> [f64; 2] {
        let [x, y] = mark.at;
        [
            computed.map_x(self.x.place(x)),
            computed.map_y(self.y.place(y)),
        ]
    }

    /// Writes what stands beside the marks.
    fn label(&self, computed: &ComputedLayout, scene: &mut Scene) {
        let all: Vec<&Mark> = self
            .series
            .iter()
            .flat_map(|series| &series.marks)
            .collect();
        let places: Vec<[f64; 2]> = all.iter().map(|mark| self.place(mark, computed)).collect();
        let labels: Vec<([f64; 2], &str)> = (places.iter().zip(&all))
            .filter_map(|(&place, mark)| Some((place, mark.label.as_deref()?)))
            .collect();
        let radius = self
            .series
            .iter()
            .map(|series| series.size)
            .fold(0.0, f64::max);
        let bottom = computed.height - computed.margin_bottom;
        let page = Area([computed.margin_left, 0.0, computed.width, bottom]);
        for (([x, y], text), label) in labels
            .iter()
            .zip(label::place(&labels, &places, radius, page))
        {
            let [left, baseline] = label.at;
            if label.led {
                let (away, middle) = (if label.ends { 2.0 } else { -2.0 }, baseline - 4.5);
                scene.add(Primitive::Line {
                    x1: *x,
                    y1: *y,
                    x2: left + away,
                    y2: middle,
                    stroke: "var(--rule)".into(),
                    stroke_width: 0.8,
                    stroke_dasharray: None,
                });
            }
            scene.add(Primitive::Text {
                x: left,
                y: baseline,
                content: (*text).to_owned(),
                size: TEXT,
                anchor: if label.ends {
                    TextAnchor::End
                } else {
                    TextAnchor::Start
                },
                rotate: None,
                bold: false,
                color: None,
            });
        }
    }

    /// Makes kuva's picture a part of the page: it scales, has a name, and its clips are its own.
    fn embed(&self, svg: &str, width: Width) -> String {
        let id = format!("{}-{}", self.id, width.of("wide", "narrow"));
        let body = svg.split_once('>').map_or("", |(_, body)| body);
        let body = body.replace("kuva-clip-", &format!("{id}-clip-"));
        let (pixels, height) = (width.pixels(), self.height(width));
        let class = width.of("plot wide", "plot narrow");
        let open = html! {
            svg class=(class) viewBox={ "0 0 " (pixels) " " (height) }
                role="img" aria-label=(self.alt) {}
        };
        let open = open.into_string();
        open.trim_end_matches("</svg>").to_owned() + &body
    }
}

impl Series {
    fn scatter(&self, plot: &Plot) -> KuvaPlot {
        let points: Vec<(f64, f64)> = self
            .marks
            .iter()
            .map(|mark| (plot.x.place(mark.at[0]), plot.y.place(mark.at[1])))
            .collect();
        let marks = ScatterPlot::new()
            .with_data(points)
            .with_color(self.color.css())
            .with_marker(self.shape)
            .with_size(self.size)
            .with_tooltip_labels(self.marks.iter().map(|mark| mark.title.clone()));
        KuvaPlot::Scatter(marks)
    }

    fn line(&self, plot: &Plot, computed: &ComputedLayout, scene: &mut Scene) {
        if !self.joined {
            return;
        }
        let points = self.marks.iter().map(|mark| {
            let [x, y] = plot.place(mark, computed);
            (x, y)
        });
        scene.add(Primitive::GroupStart {
            transform: None,
            title: Some(self.name.clone()),
            extra_attrs: None,
        });
        scene.add(Primitive::PolyLine {
            points: points.collect(),
            stroke: self.color.css().into(),
            stroke_width: 1.6,
            stroke_dasharray: None,
        });
        scene.add(Primitive::GroupEnd);
    }
}
