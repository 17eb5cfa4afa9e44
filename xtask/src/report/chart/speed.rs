//! How fast pictures are computed.

use super::{line, nanoseconds, times};
use crate::bench::result::Row;
use crate::report::data::Data;
use crate::report::plot::{Axis, Color, Plot, Scale, Series};
use crate::table::grouped;
use std::sync::Arc;

/// The width of the picture that the plots and tables are about.
const WIDTH: u32 = 600;

/// Figure 3(c) at the lab's size on one thread: the way, in which the shadow is the lab's.
pub fn rows<'a>(data: &'a Data, chain: &'a str, float: &'a str) -> impl Iterator<Item = &'a Row> {
    data.bench.rows.iter().filter(move |row| {
        let is_plain = row.chain != "lab"
            || (row.shadow == "ulp-offset"
                && row.quality.as_deref() == Some("textbook")
                && row.query.as_deref() == Some("any"));
        row.chain == chain
            && row.float == float
            && row.width == WIDTH
            && row.threads == 1
            && is_plain
    })
}

/// The baseline in a format.
pub fn lab_way<'a>(data: &'a Data, float: &'a str) -> Option<&'a Row> {
    rows(data, "lab-way", float).next()
}

/// The kit's default at the best level.
pub fn best<'a>(data: &'a Data, float: &'a str) -> Option<&'a Row> {
    rows(data, "relative", float).min_by(|a, b| a.ns_per_pixel.total_cmp(&b.ns_per_pixel))
}

/// Nanoseconds a pixel at every level.
pub fn levels(data: &Data) -> Plot {
    let levels = data.bench.machine.levels.clone();
    let place = |row: &Row| levels.iter().position(|level| *level == row.level);
    let series = |name: &str, chain: &str, float: &str, color| {
        let points = rows(data, chain, float).filter_map(|row| {
            let title = format!(
                "{name} at {}: {} ns a pixel, {:.1} times as fast as the lab's way, {} wrong bytes",
                row.level,
                nanoseconds(row.ns_per_pixel),
                row.ratio_to_lab_way,
                grouped(row.wrong_bytes as u64)
            );
            Some(([place(row)? as f64, row.ns_per_pixel], title))
        });
        line(name, color, points.collect())
    };
    let limit = |name: &str, float: &str| {
        let points = rows(data, "relative", float).filter_map(|row| {
            let limit = row.ns_per_pixel * row.share_of_limit?;
            let title = format!("{name} at {}: {} ns a pixel", row.level, nanoseconds(limit));
            Some(([place(row)? as f64, limit], title))
        });
        line(name, Color::Grey, points.collect())
    };
    let series = vec![
        series("lab's chain, f32", "lab", "f32", Color::Vermillion),
        series("kit, f32", "relative", "f32", Color::Blue),
        series("kit, f64", "relative", "f64", Color::Green),
        limit("limit, f32", "f32"),
    ];
    let baseline = lab_way(data, "f32").map(|row| row.ns_per_pixel);
    let all = series.iter().flat_map(|series: &Series| &series.marks);
    let values: Vec<f64> = all.map(|mark| mark.at[1]).chain(baseline).collect();
    let last = levels.len() as f64 - 1.0;
    Plot {
        id: "levels".into(),
        alt: "Nanoseconds a pixel of Figure 3(c) at every processor level: wider levels are faster, and \
              the kit's chain is faster than the lab's at each."
            .into(),
        x: Axis {
            label: "processor level".into(),
            range: [-0.4, last + 1.6],
            scale: Scale::Linear(1.0),
            format: Arc::new(move |value| {
                let place = value.round();
                let is_whole = (value - place).abs() < 0.01 && place >= 0.0;
                let level = is_whole.then(|| levels.get(place as usize)).flatten();
                level.cloned().unwrap_or_default()
            }),
        },
        y: times("nanoseconds a pixel", values.iter().copied()),
        heights: [420.0, 400.0],
        series,
        levels: baseline.map(|ns| (ns, format!("lab's way, f32: {} ns", nanoseconds(ns)))).into_iter().collect(),
    }
}

/// Nanoseconds a pixel against the number of spheres, in `f32`.
pub fn spheres(data: &Data) -> Plot {
    let rows = &data.bench.growth_with_spheres;
    let best = data
        .bench
        .machine
        .levels
        .last()
        .cloned()
        .unwrap_or_default();
    let ways = [
        ("lab's way", "lab-way", "scalar", Color::Vermillion),
        ("kit, one by one", "relative", "scalar", Color::Green),
        ("kit, packets", "relative", best.as_str(), Color::Blue),
        (
            "lab's chain, tree",
            "lab, hierarchy",
            best.as_str(),
            Color::Purple,
        ),
    ];
    let series = ways.map(|(name, chain, level, color)| {
        // The lab's way has only one question, and asks for the nearest hit.
        let query = if chain == "lab-way" { "nearest" } else { "any" };
        let of = |row: &&Row| {
            (row.float.as_str(), row.chain.as_str(), row.level.as_str()) == ("f32", chain, level)
                && row.query.as_deref().is_none_or(|asked| asked == query)
        };
        let points = rows.iter().filter(of).map(|row| {
            let title = format!(
                "{name}, {} spheres: {} ns a pixel, {} wrong bytes",
                grouped(row.spheres as u64),
                nanoseconds(row.ns_per_pixel),
                grouped(row.wrong_bytes as u64)
            );
            ([row.spheres as f64, row.ns_per_pixel], title)
        });
        line(name, color, points.collect())
    });
    let most = rows.iter().map(|row| row.spheres).max().unwrap_or(1) as f64;
    let values: Vec<f64> = rows.iter().map(|row| row.ns_per_pixel).collect();
    Plot {
        id: "spheres".into(),
        alt: "Nanoseconds a pixel against the number of spheres: without a tree over the spheres time grows \
              with their number, with one hardly."
            .into(),
        x: Axis {
            label: "spheres over a plane".into(),
            range: [0.7, most * 40.0],
            scale: Scale::Decades(1),
            format: Arc::new(move |value| match value {
                value if value > most * 1.1 => String::new(),
                value => grouped(value.round() as u64),
            }),
        },
        y: Axis {
            scale: Scale::Decades(1),
            format: Arc::new(|value| if value < 1.0 { format!("{value}") } else { grouped(value.round() as u64) }),
            ..times("nanoseconds a pixel", values.iter().copied())
        },
        heights: [420.0, 400.0],
        series: series.into(),
        levels: vec![],
    }
}
