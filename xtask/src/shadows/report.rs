//! The tables of what was measured.

use super::count::Wrong;
use super::strategy::Strategy;
use super::time::Times;
use crate::table::{Table, grouped};
use serde::{Deserialize, Serialize};

/// What a strategy gets wrong on a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The scene.
    pub scene: String,
    /// The format.
    pub float: String,
    /// The strategy.
    pub strategy: String,
    /// The counts.
    #[serde(flatten)]
    pub wrong: Wrong,
}

/// What a strategy gets wrong on all scenes.
#[derive(Clone, Debug, Serialize)]
pub struct Total {
    /// The strategy.
    pub strategy: String,
    /// The format.
    pub float: String,
    /// The sums of the counts.
    #[serde(flatten)]
    pub wrong: Wrong,
    /// The scenes with a wrong shadow.
    pub scenes_wrong: usize,
}

/// The sums over all scenes, for each strategy and format in the order of the rows.
pub fn totals(rows: &[Row]) -> Vec<Total> {
    let mut totals: Vec<Total> = vec![];
    for row in rows {
        let place = totals
            .iter()
            .position(|total| total.strategy == row.strategy && total.float == row.float);
        let place = place.unwrap_or_else(|| {
            totals.push(Total {
                strategy: row.strategy.clone(),
                float: row.float.clone(),
                wrong: Wrong::default(),
                scenes_wrong: 0,
            });
            totals.len() - 1
        });
        let total = &mut totals[place];
        total.wrong.add(&row.wrong);
        total.scenes_wrong += usize::from(row.wrong.shadows() > 0);
    }
    totals
}

/// The table of all strategies: acne / false shadow / leak / turned, in how many scenes, how far
/// the edge of a shadow moves, and nanoseconds a shadow ray.
pub fn totals_table(rows: &[Row], times: &[Times]) -> String {
    let totals = totals(rows);
    let times: Vec<&Times> = times
        .iter()
        .filter(|times| times.float == "f32")
        .take(2)
        .collect();
    let floats = ["f32", "f64"];
    let mut heads = vec!["strategy".to_owned()];
    for float in floats {
        heads.push(format!("{float} acne/false/leak/turned"));
        heads.push("scenes".to_owned());
        heads.push("edge px".to_owned());
    }
    heads.extend(times.iter().map(|times| format!("ns {}", times.scene)));
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let mut table = Table::new(&heads);
    for (place, strategy) in Strategy::all().into_iter().enumerate() {
        let name = strategy.name();
        let mut cells = vec![name.clone()];
        for float in floats {
            let total = totals
                .iter()
                .find(|t| t.strategy == name && t.float == float);
            let Some(Total {
                wrong,
                scenes_wrong,
                ..
            }) = total
            else {
                cells.extend(["".into(), "".into(), "".into()]);
                continue;
            };
            cells.push(counts(wrong));
            cells.push(scenes_wrong.to_string());
            cells.push(shift(wrong));
        }
        cells.extend(
            times
                .iter()
                .map(|times| format!("{:.1}", times.ns_per_ray[place])),
        );
        table.row(cells);
    }
    let judged = |float: &str| totals.iter().find(|total| total.float == float);
    let mut text = table.render();
    for total in floats.into_iter().filter_map(judged) {
        let (rays, undecided) = (total.wrong.rays, total.wrong.undecided);
        text += &format!(
            "{}: {} shadow rays judged by {}, {} left out\n",
            total.float,
            grouped(rays as u64),
            total.strategy,
            grouped(undecided as u64)
        );
    }
    text
}

/// The table of every scene, strategy and format.
pub fn scenes_table(rows: &[Row], times: &[Times]) -> String {
    let mut table = Table::new(&[
        "scene", "strategy", "float", "rays", "acne", "false", "leak", "turned", "edge px", "ns",
    ]);
    let order: Vec<String> = Strategy::all().into_iter().map(Strategy::name).collect();
    for row in rows {
        let wrong = &row.wrong;
        let of = |times: &&Times| times.scene == row.scene && times.float == row.float;
        let place = order.iter().position(|name| *name == row.strategy);
        let ns = times.iter().find(of).zip(place);
        let mut cells = vec![row.scene.clone(), row.strategy.clone(), row.float.clone()];
        let counts = [
            wrong.rays,
            wrong.acne,
            wrong.false_shadow,
            wrong.leak,
            wrong.turned,
        ];
        cells.extend(counts.map(|count| grouped(count as u64)));
        cells.push(shift(wrong));
        cells.push(ns.map_or("".into(), |(times, place)| {
            format!("{:.1}", times.ns_per_ray[place])
        }));
        table.row(cells);
    }
    table.render()
}

/// Lines that say what the default costs.
pub fn costs(times: &[Times]) -> String {
    let line = |times: &Times| {
        format!(
            "a picture of {} in {}: sidedness {:.2} ms, ulp-offset {:.2} ms, ratio {:.2}\n",
            times.scene,
            times.float,
            times.ms_sidedness,
            times.ms_ulp_offset,
            times.sidedness_over_ulp_offset
        )
    };
    times.iter().map(line).collect()
}

/// Acne / false shadow / leak / turned.
fn counts(wrong: &Wrong) -> String {
    [wrong.acne, wrong.false_shadow, wrong.leak, wrong.turned]
        .map(|count| grouped(count as u64))
        .join("/")
}

fn shift(wrong: &Wrong) -> String {
    wrong
        .shift
        .map_or("-".into(), |shift| format!("{shift:.1}"))
}
