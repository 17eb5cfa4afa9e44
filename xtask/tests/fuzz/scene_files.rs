//! Scene files: read or refused, and drawn.

use crate::properties::scene_file;
use crate::{cases, changed, changes, texts};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use std::ops::Range;
use std::path::Path;
use std::sync::LazyLock;
use xtask::scene_file::parse;

static SCENES: LazyLock<Vec<String>> = LazyLock::new(|| texts("scenes"));

/// Numbers as a scene file may have them: mostly of this range, few of any size or on the edge, very
/// few none; a scene has about forty.
fn number(usual: Range<f64>) -> impl Strategy<Value = String> {
    let edges = select(
        "0 -0.0 1 -1 1e-320 5e-324 1e-46 3.5e38 1e154 1.7e308 -1e308 inf -inf nan 1e999 \
            0x10 9223372036854775808 16777217 0.30000000000000004 1e-8"
            .split_whitespace()
            .collect::<Vec<_>>(),
    );
    let wrong = select(
        "true \"1\" [1] 1979-05-27 1. {} 0b2 --1"
            .split_whitespace()
            .collect::<Vec<_>>(),
    );
    prop_oneof![
        500 => usual.prop_map(|x| x.to_string()),
        5 => any::<f64>().prop_map(|x| format!("{x:e}")),
        10 => edges.prop_map(str::to_owned),
        1 => wrong.prop_map(str::to_owned),
    ]
}

/// Three numbers, or seldom another count.
fn triple(usual: Range<f64>) -> impl Strategy<Value = String> {
    let count = prop_oneof![300 => Just(3_usize), 1 => 0_usize..6];
    let number = move |count| prop::collection::vec(number(usual.clone()), count);
    let numbers = count.prop_flat_map(number);
    numbers.prop_map(|numbers| format!("[{}]", numbers.join(", ")))
}

/// A table with its keys; seldom one is missing, twice there or unknown.
fn table(
    header: &'static str,
    keys: &'static [(&'static str, bool)],
) -> impl Strategy<Value = String> {
    let value = |&(key, is_triple): &(&str, bool)| match (key, is_triple) {
        (_, false) => number(0.1..100.0).boxed(),
        ("color" | "background", true) => triple(0.0..1.0).boxed(),
        (_, true) => triple(-10.0..10.0).boxed(),
    };
    let values: Vec<_> = keys.iter().map(value).collect();
    let slip = prop_oneof![100 => Just(0_u8), 1 => Just(1), 1 => Just(2), 1 => Just(3)];
    (values, slip, any::<Index>()).prop_map(move |(values, slip, place)| {
        let pairs = keys.iter().zip(&values);
        let mut lines: Vec<String> = pairs
            .map(|((key, _), value)| format!("{key} = {value}\n"))
            .collect();
        match (slip, lines.is_empty()) {
            (1, false) => drop(lines.remove(place.index(lines.len()))),
            (2, false) => lines.push(lines[place.index(lines.len())].clone()),
            (3, _) => lines.push("zebra = 1\n".to_owned()),
            _ => {}
        }
        format!("{header}\n{}", lines.concat())
    })
}

/// A scene file by its grammar.
fn scene() -> impl Strategy<Value = String> {
    let objects = prop_oneof![
        table(
            "[[sphere]]",
            &[("center", true), ("radius", false), ("color", true)]
        ),
        table(
            "[[plane]]",
            &[("point", true), ("normal", true), ("color", true)]
        ),
        table(
            "[[light]]",
            &[("position", true), ("color", true), ("power", false)]
        ),
    ];
    (
        table("", &[("background", true), ("t_max", false)]),
        table(
            "[camera]",
            &[
                ("position", true),
                ("look_at", true),
                ("up", true),
                ("fov", false),
            ],
        ),
        prop::collection::vec(objects, 0..6),
    )
        .prop_map(|(head, camera, objects)| {
            let image = "[image]\nwidth = 3\nheight = 2\n";
            format!(
                "name = \"any\"\n{head}\n{camera}\n{image}\n{}",
                objects.join("\n")
            )
        })
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn scene_files_by_grammar(text in scene()) {
        scene_file(text.as_bytes());
    }

    #[test]
    fn scene_files_by_mutation(seed in any::<Index>(), changes in changes()) {
        let seed: &String = seed.get(&SCENES);
        scene_file(&changed(seed, changes));
    }
}

/// A grammar that is never obeyed tests little.
#[test]
fn the_grammar_makes_scenes_that_are_read() {
    let mut runner = TestRunner::deterministic();
    let read = (0..400).filter(|_| {
        let text = scene().new_tree(&mut runner).expect("a scene").current();
        parse(Path::new("any.toml"), text.into_bytes()).is_ok()
    });
    let read = read.count();
    assert!((40..360).contains(&read), "{read} of 400 are read");
}
