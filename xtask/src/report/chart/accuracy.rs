//! How far numbers are off: kernels, and pictures far from the origin.

use super::{count, counts, line, nanoseconds, power, scatter, times};
use crate::compare::moved::Row;
use crate::precision::measure::{Costs, Family};
use crate::report::data::Data;
use crate::report::plot::{Axis, Color, Mark, Plot, Scale};
use crate::table::grouped;
use kuva::plot::scatter::MarkerShape;
use std::sync::Arc;

/// How many bytes a way gets wrong.
type Count = fn(&Row) -> usize;

/// Wrong bytes against the distance from the origin.
pub fn moved(data: &Data) -> Plot {
    let ways: [(&str, Color, Count); 3] = [
        ("lab's way, f32", Color::Vermillion, |row| row.f32.lab),
        ("relative, f32", Color::Blue, |row| row.f32.relative),
        ("both, f64", Color::Green, |row| {
            row.f64.lab.max(row.f64.relative)
        }),
    ];
    let series = ways.map(|(name, color, wrong)| {
        let points = data.moved.iter().map(|row| {
            let wrong = wrong(row);
            let title = format!(
                "moved by {}, {name}: {} wrong bytes",
                power(row.moved_by),
                grouped(wrong as u64)
            );
            ([row.moved_by, count(wrong)], title)
        });
        line(name, color, points.collect())
    });
    let largest = data.moved.iter().map(|row| row.f32.lab).max();
    let farthest = data.moved.last().map_or(1.0, |row| row.moved_by * 1.1);
    Plot {
        id: "moved".into(),
        alt:
            "Wrong bytes of Figure 3(c) against its distance from the origin: the lab's way in f32 \
              rises with the distance, the kit's does not."
                .into(),
        x: Axis {
            label: "distance from the origin along each axis".into(),
            range: [0.6, 3e10],
            scale: Scale::Decades(1),
            format: Arc::new(move |value| {
                if value > farthest {
                    String::new()
                } else {
                    power(value)
                }
            }),
        },
        y: counts("wrong bytes of 720,000", largest.unwrap_or(0)),
        heights: [400.0, 360.0],
        series: series.into(),
        levels: vec![],
    }
}

/// Errors beyond this many units in the last place have no right digit in `f32`, and stand here.
const MOST: f64 = 1e8;

/// Where a family with a wrong decision stands.
const WRONG: f64 = 1e9;

/// What a kernel costs against how far it is off in a format, a mark for each family of test
/// vectors.
pub fn kernel(data: &Data, kernel: &str, float: &str) -> Plot {
    let of = |cost: &&Costs| cost.kernel == kernel && cost.float == float;
    let costs: Vec<&Costs> = data.costs.iter().filter(of).collect();
    let series = costs.iter().map(|cost| {
        let families = data.families.iter().filter(|family| {
            (&family.kernel, &family.float, &family.quality)
                == (&cost.kernel, &cost.float, &cost.quality)
        });
        let (color, shape) = match cost.quality.as_str() {
            "textbook" => (Color::Vermillion, MarkerShape::Square),
            "stable" => (Color::Green, MarkerShape::Triangle),
            _ => (Color::Blue, MarkerShape::Circle),
        };
        scatter(&cost.quality, color, shape, column(cost, families))
    });
    Plot {
        id: format!("kernel-{}-{float}", kernel.replace('_', "-")),
        alt: format!(
            "{kernel} in {float}: nanoseconds a call against the largest error of each family of test vectors. \
             Textbook and stable are fast and fail some families; wide is right on all and slow."
        ),
        x: times("nanoseconds a call", costs.iter().map(|cost| cost.ns)),
        y: Axis {
            label: "largest error, ulp".into(),
            range: [0.08, WRONG * 60.0],
            scale: Scale::Decades(1),
            format: Arc::new(|value| {
                let exponent = value.log10().round() as i32;
                match exponent {
                    10.. => String::new(),
                    9 => "wrong".into(),
                    8 => "10⁸ +".into(),
                    -1 => "≤ 0.1".into(),
                    0 => "1".into(),
                    _ => power(value),
                }
            }),
        },
        heights: [420.0, 400.0],
        series: series.collect(),
        levels: vec![],
    }
}

/// The families of a kernel, quality and format, above one another; the topmost has their name.
fn column<'a>(cost: &Costs, families: impl Iterator<Item = &'a Family>) -> Vec<Mark> {
    let height = |family: &Family| match family.wrong {
        0 => family.ulps.clamp(0.1, MOST),
        _ => WRONG,
    };
    let mut marks: Vec<Mark> = families
        .map(|family| Mark {
            at: [cost.ns, height(family)],
            title: format!(
                "{} {} {}, {}: {} ns; {} of {} decisions wrong, the others at most {:.2e} ulp off",
                cost.kernel,
                cost.quality,
                cost.float,
                family.family,
                nanoseconds(cost.ns),
                family.wrong,
                family.cases,
                family.ulps
            ),
            label: None,
        })
        .collect();
    marks.sort_by(|a, b| a.at[1].total_cmp(&b.at[1]));
    if let Some(top) = marks.last_mut() {
        top.label = Some(cost.quality.clone());
    }
    marks
}
