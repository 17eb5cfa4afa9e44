//! What was measured, for people.

use super::result::{Bench, Hierarchy, Instructions, Limit, Operations, Row};
use crate::table::{Table, grouped};
use std::fmt::Write;

/// All tables.
pub fn text(bench: &Bench) -> String {
    let machine = &bench.machine;
    let mut text = format!(
        "{}, {} core(s), {}; load {}\n",
        machine.processor,
        machine.cores,
        machine.levels.join(", "),
        machine
            .load
            .map_or("unknown".into(), |load| format!("{load:.2}")),
    );
    if !machine.optimised {
        text += "built without optimisations: the times below mean nothing\n";
    }
    for rows in bench
        .rows
        .chunk_by(|a, b| (a.width, a.height) == (b.width, b.height))
    {
        let [width, height] = [rows[0].width, rows[0].height];
        text += &format!("\nFigure 3(c), {width}x{height}, one thread unless it says otherwise\n");
        text += &pictures(rows);
    }
    text += "\nGrowth with pixels: Figure 3(c), ns/pixel and wrong bytes\n";
    let size = |row: &Row| format!("{}x{}", row.width, row.height);
    text += &growth("size", &bench.growth_with_pixels, size);
    text += "Growth with spheres: a plane under them, 64x48, ns/pixel and wrong bytes\n";
    let spheres = |row: &Row| grouped(row.spheres as u64);
    text += &growth("spheres", &bench.growth_with_spheres, spheres);
    for Hierarchy {
        float,
        level,
        pays_from,
    } in &bench.hierarchy
    {
        let pays = pays_from.map_or("never pays here".into(), |n| {
            format!("pays from {n} spheres")
        });
        let _ = writeln!(text, "a hierarchy in {float} at {level} {pays}");
    }
    text += "\nThe machine's limits, one core, ns an operation on a packet\n";
    text += &limits(&bench.limits);
    for store in &bench.stores {
        let (width, height, ns) = (store.width, store.height, store.ns_per_pixel);
        let _ = writeln!(
            text,
            "to fill a new picture of {width}x{height}: {ns:.2} ns/pixel"
        );
    }
    text += "\nOperations a pixel in Figure 3(c); a packet counts for all its lanes\n";
    text + &operations(&bench.operations)
}

/// Each way in `f32`, and beside it in `f64`.
fn pictures(rows: &[Row]) -> String {
    let mut table = Table::new(&[
        "way",
        "level",
        "f32 ns/pixel",
        "x",
        "wrong",
        "limit",
        "f64 ns/pixel",
        "x",
        "wrong",
        "limit",
    ]);
    for row in rows.iter().filter(|row| row.float == "f32") {
        let mut cells = vec![way(row), level(row)];
        for float in ["f32", "f64"] {
            let same = rows.iter().find(|other| {
                (&*other.float, way(other), level(other)) == (float, way(row), level(row))
            });
            cells.extend(same.map_or_else(|| vec![String::new(); 4], measured));
        }
        table.row(cells);
    }
    table.render() + &proofs(rows)
}

/// What a proof costs: a line for each level.
fn proofs(rows: &[Row]) -> String {
    let line = |row: &Row| {
        let ratio = row.ratio_to_plain?;
        let level = level(row);
        Some(format!(
            "a proof takes {ratio:.2} times as long as the plain picture in f32, {level}\n"
        ))
    };
    rows.iter().filter_map(line).collect()
}

/// The chain, and how it differs from Figure 3(c)'s.
fn way(row: &Row) -> String {
    let mut name = row.chain.clone();
    if row.chain == "lab" {
        name += ", ";
        name += &row.shadow;
        if row.quality.as_deref() != Some("textbook") {
            let _ = write!(name, ", {}", row.quality.as_deref().unwrap_or_default());
        }
        if row.query.as_deref() == Some("nearest") {
            name += ", nearest hit";
        }
    }
    name
}

fn level(row: &Row) -> String {
    match row.threads {
        1 => row.level.clone(),
        threads => format!("{} x {threads} threads", row.level),
    }
}

fn measured(row: &Row) -> Vec<String> {
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    vec![
        format!("{:.2}", row.ns_per_pixel),
        format!("{:.1}", row.ratio_to_lab_way),
        grouped(row.wrong_bytes as u64),
        row.share_of_limit.map_or_else(String::new, percent),
    ]
}

/// For each format and level a table: a line for each step of the growth, the times of all chains,
/// and their wrong bytes.
fn growth(head: &str, rows: &[Row], step: impl Fn(&Row) -> String) -> String {
    let mut text = String::new();
    for (float, level) in formats_and_levels(rows) {
        let fits = |row: &&Row| row.float == float && (row.level == level || is_baseline(row));
        let rows: Vec<&Row> = rows.iter().filter(fits).collect();
        let steps: Vec<&[&Row]> = rows.chunk_by(|a, b| step(a) == step(b)).collect();
        let Some(first) = steps.first() else { continue };
        let mut heads = vec![format!("{head}, {float}, {level}")];
        heads.extend(first.iter().map(|row| chain(row)));
        heads.extend(
            first
                .iter()
                .filter(|row| is_judged(row))
                .map(|row| format!("{} wrong", chain(row))),
        );
        let mut table = Table::new(&heads.iter().map(String::as_str).collect::<Vec<_>>());
        for rows in steps {
            let mut cells = vec![step(rows[0])];
            cells.extend(rows.iter().map(|row| {
                let digits = if row.ns_per_pixel < 100.0 { 2 } else { 0 };
                format!("{:.digits$}", row.ns_per_pixel)
            }));
            let judged = rows.iter().filter(|row| is_judged(row));
            cells.extend(judged.map(|row| grouped(row.wrong_bytes as u64)));
            table.row(cells);
        }
        text += &table.render();
        text += "\n";
    }
    text
}

fn formats_and_levels(rows: &[Row]) -> Vec<(&str, &str)> {
    let mut found = vec![];
    for row in rows {
        let both = (&*row.float, &*row.level);
        if !found.contains(&both) {
            found.push(both);
        }
    }
    found
}

fn is_baseline(row: &Row) -> bool {
    row.chain == "lab-way"
}

/// Whether the wrong bytes of a chain stand in the table: the tree and nearest hits have those of
/// the lab's chain, and two threads those of one.
fn is_judged(row: &Row) -> bool {
    is_baseline(row) || ["lab", "relative"].contains(&&*chain(row))
}

/// A chain's name in the head of a column.
fn chain(row: &Row) -> String {
    match (&*row.chain, row.query.as_deref()) {
        ("lab", Some("nearest")) => "lab, nearest hit".into(),
        (chain, _) if row.threads > 1 => format!("{chain} x {} threads", row.threads),
        (chain, _) => chain.into(),
    }
}

fn limits(limits: &[Limit]) -> String {
    let heads = [
        "float",
        "level",
        "lanes",
        "add, mul",
        "compare, select",
        "divide",
        "sqrt",
    ];
    let mut table = Table::new(&heads);
    for limit in limits {
        let times = [
            limit.add_mul_ns,
            limit.compare_select_ns,
            limit.divide_ns,
            limit.sqrt_ns,
        ];
        let mut cells = vec![
            limit.float.clone(),
            limit.level.clone(),
            limit.lanes.to_string(),
        ];
        cells.extend(times.map(|ns| format!("{ns:.3}")));
        table.row(cells);
    }
    table.render()
}

fn operations(operations: &[Operations]) -> String {
    let heads = [
        "chain",
        "float",
        "together",
        "add, mul",
        "compare, select",
        "divide",
        "sqrt",
    ];
    let mut table = Table::new(&heads);
    for counted in operations {
        let counts = [
            counted.add_mul,
            counted.compare_select,
            counted.divide,
            counted.sqrt,
        ];
        let mut cells = vec![
            counted.chain.clone(),
            counted.float.clone(),
            counted.lanes.to_string(),
        ];
        cells.extend(counts.map(|count| format!("{count:.2}")));
        table.row(cells);
    }
    table.render()
}

/// Instructions a pixel, and how many there may be. Nothing, where none were counted.
pub fn instructions(counted: &[Instructions]) -> String {
    if counted.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["chain", "float", "level", "instructions/pixel", "at most"]);
    for of in counted {
        table.row(vec![
            of.chain.clone(),
            of.float.clone(),
            of.level.clone(),
            format!("{:.2}", of.per_pixel),
            of.allowed
                .map_or_else(String::new, |allowed| format!("{allowed:.0}")),
        ]);
    }
    table.render()
}
