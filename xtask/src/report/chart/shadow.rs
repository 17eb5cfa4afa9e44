//! Shadow strategies, and what makes acne.

use super::{count, counts, line, nanoseconds, power, scatter, times};
use crate::report::data::Data;
use crate::report::height::{Acne, Height};
use crate::report::plot::{Axis, Color, Mark, Plot, Scale, Series};
use crate::shadows::{Offsets, Strategy, Total, totals};
use crate::table::grouped;
use kuva::plot::scatter::MarkerShape;
use std::sync::Arc;

/// Nanoseconds a shadow ray of a strategy, on the scene of two objects.
pub fn cost(data: &Data, strategy: &str, float: &str) -> Option<f64> {
    let order = Strategy::all().into_iter().map(Strategy::name);
    let place = order.into_iter().position(|name| name == strategy)?;
    let times = data.times.iter().find(|times| times.float == float)?;
    times.ns_per_ray.get(place).copied()
}

/// What a shadow ray costs against how many shadows are wrong, in one format.
pub fn pareto(data: &Data, float: &str) -> Plot {
    let totals = totals(&data.shadows);
    let of_float = totals.iter().filter(|total| total.float == float);
    let timed: Vec<(&Total, f64)> = of_float
        .filter_map(|total| Some((total, cost(data, &total.strategy, float)?)))
        .collect();
    let own = Strategy::Sidedness.name();
    let marks = |is_own: bool| {
        let marks = timed
            .iter()
            .filter(|(total, _)| (total.strategy == own) == is_own);
        marks.map(|(total, ns)| mark(total, *ns)).collect()
    };
    let largest = timed.iter().map(|(total, _)| total.wrong.shadows()).max();
    Plot {
        id: format!("pareto-{float}"),
        alt: format!(
            "Nanoseconds a shadow ray against wrong pixels in {float}; lower left is better. The table \
             of all strategies has the same numbers."
        ),
        x: times("nanoseconds a shadow ray", timed.iter().map(|(_, ns)| *ns)),
        y: counts("wrong pixels, all scenes", largest.unwrap_or(0)),
        heights: [440.0, 440.0],
        series: vec![
            scatter(&own, Color::Blue, MarkerShape::Diamond, marks(true)),
            scatter(
                "others",
                Color::Vermillion,
                MarkerShape::Circle,
                marks(false),
            ),
        ],
        levels: vec![],
    }
}

fn mark(total: &Total, ns: f64) -> Mark {
    let wrong = &total.wrong;
    let [all, acne, false_shadow, leak] =
        [wrong.shadows(), wrong.acne, wrong.false_shadow, wrong.leak].map(|n| grouped(n as u64));
    Mark {
        at: [ns, count(wrong.shadows())],
        title: format!(
            "{}, {}: {} ns a shadow ray; {all} wrong pixels in {} scenes: {acne} acne, {false_shadow} \
             false shadow, {leak} leak",
            total.strategy,
            total.float,
            nanoseconds(ns),
            total.scenes_wrong,
        ),
        label: Some(total.strategy.clone()),
    }
}

/// Which constant offsets serve which scene, in one format: a bar from the least without acne to
/// the largest that neither leaks nor casts a false shadow; scenes that any offset serves left out.
pub fn offsets(data: &Data, float: &str) -> Plot {
    let picky = |offsets: &&Offsets| offsets.float == float && ends(offsets) != [LEAST, MOST];
    let rows: Vec<&Offsets> = data.offsets.iter().filter(picky).collect();
    let series = rows
        .iter()
        .enumerate()
        .map(|(row, offsets)| bar(offsets, row));
    let names: Vec<String> = rows.iter().map(|offsets| offsets.scene.clone()).collect();
    let height = 24.0 * rows.len() as f64 + 70.0;
    Plot {
        id: format!("offsets-{float}"),
        alt: format!(
            "For each scene the constant offsets that serve it in {float}: no vertical line crosses all bars."
        ),
        x: Axis {
            label: "constant offset, in scene units".into(),
            range: [LEAST / 3.0, MOST * 3.0],
            scale: Scale::Decades(4),
            format: Arc::new(power),
        },
        y: Axis {
            label: String::new(),
            range: [-(rows.len() as f64), 1.0],
            scale: Scale::Linear(1.0),
            format: Arc::new(move |value| {
                let row = -value.round();
                let name = (row >= 0.0).then(|| names.get(row as usize)).flatten();
                name.cloned().unwrap_or_default()
            }),
        },
        heights: [height, height],
        series: series.collect(),
        levels: vec![],
    }
}

/// The ends of the offsets that are searched, where `xtask shadows --least-offset` stops.
const LEAST: f64 = 1e-18;
const MOST: f64 = 1e6;

fn ends(offsets: &Offsets) -> [f64; 2] {
    [offsets.least.unwrap_or(MOST), offsets.most.unwrap_or(LEAST)]
}

fn bar(offsets: &Offsets, row: usize) -> Series {
    let serves = offsets.serve();
    let [least, most] = ends(offsets);
    let title = if serves {
        format!(
            "{}: offsets from {least:.1e} to {most:.1e} serve",
            offsets.scene
        )
    } else {
        let most = offsets
            .most
            .map_or("any".into(), |most| format!("more than {most:.1e}"));
        format!(
            "{}: none serves; less than {least:.1e} has acne, {most} is wrong too",
            offsets.scene
        )
    };
    let mark = |offset| Mark {
        at: [offset, -(row as f64)],
        title: title.clone(),
        label: None,
    };
    let (color, shape) = if serves {
        (Color::Blue, MarkerShape::Circle)
    } else {
        (Color::Vermillion, MarkerShape::Cross)
    };
    let marks = if serves {
        vec![mark(least), mark(most)]
    } else {
        vec![mark(least)]
    };
    Series {
        joined: serves,
        size: 4.0,
        ..scatter(&title, color, shape, marks)
    }
}

/// How much of the plane is acne, against its height.
pub fn heights(data: &Data) -> Plot {
    let series = |name: &str, color, of: fn(&Height) -> Acne, acne: fn(&Acne) -> usize| {
        let points = data.heights.iter().map(|height| {
            let counted = of(height);
            let percent = 100.0 * acne(&counted) as f64 / counted.lit as f64;
            let title = format!("plane at y = {}, {name}: {percent:.1} % acne", height.y);
            ([-height.y, percent], title)
        });
        line(name, color, points.collect())
    };
    let floats: [fn(&Height) -> Acne; 2] = [|height| height.f32, |height| height.f64];
    Plot {
        id: "heights".into(),
        alt: "Acne on the plane against its height: with 0 counted at every height half of it or more; \
              with 0 not counted none at some heights, and a fifth at others."
            .into(),
        x: Axis {
            label: "depth of the plane below the camera".into(),
            range: [1.0, 5.4],
            scale: Scale::Linear(0.5),
            format: Arc::new(|value| format!("{value}")),
        },
        y: Axis {
            label: "lit pixels of the plane that are acne, %".into(),
            range: [-2.0, 100.0],
            scale: Scale::Linear(20.0),
            format: Arc::new(|value| format!("{value}")),
        },
        heights: [400.0, 340.0],
        series: vec![
            series("0 counts, f32", Color::Vermillion, floats[0], |acne| acne.closed),
            series("0 counts, f64", Color::Purple, floats[1], |acne| acne.closed),
            series("0 does not, f32", Color::Blue, floats[0], |acne| acne.open),
            series("0 does not, f64", Color::Green, floats[1], |acne| acne.open),
        ],
        levels: vec![],
    }
}
