//! What programs print to `cargo xtask conform`: judged, whatever it is.

use crate::properties::{adapter_answer, right_answers};
use crate::{cases, changed, changes, texts};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::sync::LazyLock;

static SEEDS: LazyLock<Vec<String>> = LazyLock::new(|| texts("fuzz/seeds/adapter_answer"));

/// Values that are well formed somewhere, or nearly.
fn value() -> impl Strategy<Value = String> {
    let edges = select(
        r#"null true 0 255 256 -1 1e999 {} [] "" "7fc00000" "7f800000" "00000000" "80000000"
            "7ff8000000000000" "7ff0000000000000" "0000000000000001" "3ff0000000000000"
            {"none":true} {"none":false} {"t":null} {"occluded":true} {"byte":7}"#
            .split_whitespace()
            .collect::<Vec<_>>(),
    );
    prop_oneof![
        2 => edges.prop_map(str::to_owned),
        1 => any::<u32>().prop_map(|bits| format!("\"{bits:08x}\"")),
        1 => any::<u64>().prop_map(|bits| format!("\"{bits:016x}\"")),
    ]
}

/// What somebody does to output that is right.
#[derive(Clone, Debug)]
enum Fault {
    /// Lines from one to another go, or come first.
    Drop(Index, Index),
    Swap(Index, Index),
    Twice(Index),
    /// The process ends here, and another is started.
    Ends(Index),
    /// One of the values of a line is another.
    Value(Index, Index, String),
    Other(&'static str, Index),
}

fn fault() -> impl Strategy<Value = Fault> {
    let index = any::<Index>;
    let others = vec![
        "hello",
        "",
        "{}",
        "[[[[",
        "\u{0}",
        "\u{1b}[2J",
        "{\"id\":\"3\",\"out\":\"\u{7f}\"}",
        "{\"id\":\"\u{9b}\",\"out\":null}",
        r#"{"id":"3"}"#,
        r#"{"id":"3","unsupported":"no"}"#,
        r#"{"id":"zebra","out":null}"#,
        r#"{"id":3,"out":{"t":null}}"#,
        r#"{"line":1,"error":"no request"}"#,
    ];
    prop_oneof![
        1 => (index(), index()).prop_map(|(from, to)| Fault::Drop(from, to)),
        1 => (index(), index()).prop_map(|(a, b)| Fault::Swap(a, b)),
        1 => index().prop_map(Fault::Twice),
        1 => index().prop_map(Fault::Ends),
        6 => (index(), index(), value()).prop_map(|(line, at, to)| Fault::Value(line, at, to)),
        2 => (select(others), index()).prop_map(|(line, at)| Fault::Other(line, at)),
    ]
}

/// Lines with a fault.
fn faulty(lines: &mut Vec<String>, fault: Fault) {
    let length = lines.len();
    let place = |at: Index| at.index(length + 1);
    match fault {
        Fault::Drop(from, to) => {
            let (from, to) = (place(from), place(to));
            drop(lines.drain(from.min(to)..from.max(to)));
        }
        Fault::Swap(a, b) if length > 0 => lines.swap(a.index(length), b.index(length)),
        Fault::Twice(at) if length > 0 => lines.push(lines[at.index(length)].clone()),
        Fault::Value(line, at, value) if length > 0 => {
            let line = &mut lines[line.index(length)];
            let starts: Vec<usize> = line
                .match_indices([':', '['])
                .map(|(at, _)| at + 1)
                .collect();
            if !starts.is_empty() {
                let start = *at.get(&starts);
                let end = line[start..].find([',', '}', ']']).unwrap_or(0);
                line.replace_range(start..start + end, &value);
            }
        }
        Fault::Ends(at) => lines.insert(place(at), "\u{c}".into()),
        Fault::Other(other, at) => lines.insert(place(at), other.into()),
        Fault::Swap(..) | Fault::Twice(_) | Fault::Value(..) => {}
    }
}

/// Output that is right but for some faults, which is held to any of the qualities.
fn output() -> impl Strategy<Value = String> {
    let faults = prop::collection::vec(fault(), 0..4);
    (any::<Index>(), 0_u8..4, faults).prop_map(|(seed, quality, faults)| {
        let (group, text) = seed.get(&SEEDS).split_at(1);
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        for fault in faults {
            faulty(&mut lines, fault);
        }
        let choice = char::from(group.as_bytes()[0] + quality * SEEDS.len() as u8);
        format!("{choice}{}", lines.join("\n"))
    })
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn adapter_answers(output in output()) {
        adapter_answer(output.as_bytes());
    }

    #[test]
    fn adapter_answers_by_mutation(seed in any::<Index>(), changes in changes()) {
        let seed: &String = seed.get(&SEEDS);
        adapter_answer(&changed(seed, changes));
    }
}

/// The seeds are the kit's best answers, so what they become by a change is nearly right. Where one
/// is not, the message has what belongs in its file.
#[test]
fn seeds_are_right() {
    let right = (0..).map_while(right_answers);
    assert!(
        SEEDS.iter().cloned().eq(right),
        "{:?}",
        (0..).map_while(right_answers)
    );
    for seed in SEEDS.iter() {
        assert_eq!(adapter_answer(seed.as_bytes()), "conforms", "{seed}");
        let (first, rest) = seed.split_once('\n').expect("lines");
        assert_eq!(adapter_answer(rest.as_bytes()), "faults", "without {first}");
    }
}
