//! The plots of the report, each from the data.

pub mod accuracy;
pub mod shadow;
pub mod speed;

use super::plot::{Axis, Color, Mark, Scale, Series};
use crate::table::grouped;
use kuva::plot::scatter::MarkerShape;
use std::sync::Arc;

/// Where a count of 0 stands on an axis of logarithms.
const ZERO: f64 = 0.1;

/// A count on an axis of logarithms, on which there is a place for 0.
fn count(count: usize) -> f64 {
    if count == 0 { ZERO } else { count as f64 }
}

/// An axis of counts, from 0 to beyond the largest.
fn counts(label: &str, largest: usize) -> Axis {
    Axis {
        label: label.into(),
        range: [ZERO * 0.5, largest.max(1) as f64 * 3.0],
        scale: Scale::Decades(1),
        format: Arc::new(|value| match value {
            value if value < 0.5 => "0".into(),
            value => grouped(value.round() as u64),
        }),
    }
}

/// An axis of nanoseconds around these values.
fn times(label: &str, values: impl Iterator<Item = f64> + Clone) -> Axis {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let most = values.fold(0.0, f64::max);
    Axis {
        label: label.into(),
        range: [least / 1.4, most * 1.6],
        scale: Scale::Log,
        format: Arc::new(|value| format!("{value}")),
    }
}

/// Marks that no line joins.
fn scatter(name: &str, color: Color, shape: MarkerShape, marks: Vec<Mark>) -> Series {
    Series {
        name: name.into(),
        color,
        shape,
        size: 5.0,
        joined: false,
        marks,
    }
}

/// Marks joined by a line, the last of which has the series' name beside it.
fn line(name: &str, color: Color, points: Vec<([f64; 2], String)>) -> Series {
    let last = points.len().saturating_sub(1);
    let marks = points
        .into_iter()
        .enumerate()
        .map(|(place, (at, title))| Mark {
            at,
            title,
            label: (place == last).then(|| name.to_owned()),
        });
    Series {
        size: 3.5,
        joined: true,
        ..scatter(name, color, MarkerShape::Circle, marks.collect())
    }
}

/// A power of ten with its exponent raised: 10⁻³.
fn power(value: f64) -> String {
    let exponent = value.log10().round() as i32;
    let exponent = exponent.to_string();
    let raised = exponent.chars().map(|digit| match digit {
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '-' => '⁻',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    });
    "10".chars().chain(raised).collect()
}

/// Nanoseconds, with a decimal below 100.
pub fn nanoseconds(ns: f64) -> String {
    if ns < 100.0 {
        format!("{ns:.1}")
    } else {
        grouped(ns.round() as u64)
    }
}
