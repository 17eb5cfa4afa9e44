//! Lines of the kernel protocol: each is answered in its place.

use crate::properties::protocol_line;
use crate::{cases, changed, changes, texts};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use serde_json::Value;
use std::sync::LazyLock;

/// The requests of tests/vectors, without their truth.
static REQUESTS: LazyLock<Vec<Value>> = LazyLock::new(|| {
    let files = texts("vectors");
    let lines = files.iter().flat_map(|file| file.lines().step_by(7));
    lines
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect()
});

/// Another value for a float: its bits, or none.
fn value() -> impl Strategy<Value = Value> {
    let edges = select(
        "00000000 80000000 3f800000 7f800000 ff800000 7fc00000 00000001 7f7fffff \
            0000000000000000 3ff0000000000000 7ff0000000000000 7ff8000000000000 \
            0000000000000001 7fefffffffffffff zebra +f800000"
            .split_whitespace()
            .collect::<Vec<_>>(),
    );
    prop_oneof![
        4 => any::<u32>().prop_map(|bits| format!("{bits:08x}").into()),
        4 => any::<u64>().prop_map(|bits| format!("{bits:016x}").into()),
        6 => edges.prop_map(Value::from),
        1 => Just(Value::Null),
        1 => any::<f64>().prop_map(Value::from),
        1 => prop::collection::vec(any::<i8>(), 0..5).prop_map(Value::from),
        1 => Just(serde_json::json!({})),
    ]
}

/// Replaces the leaf of this number; how many leaves there were.
fn replace(json: &mut Value, leaf: usize, value: &Value) -> usize {
    let inner: Vec<&mut Value> = match json {
        Value::Array(list) => list.iter_mut().collect(),
        Value::Object(map) => map.values_mut().collect(),
        _ => {
            if leaf == 0 {
                *json = value.clone();
            }
            return 1;
        }
    };
    let mut seen = 0;
    for inner in inner {
        seen += replace(inner, leaf.wrapping_sub(seen), value);
    }
    seen
}

/// A request with other floats in it, or a changed text of one.
fn line() -> impl Strategy<Value = Vec<u8>> {
    let other = prop::collection::vec((0_usize..40, value()), 1..4);
    let regular = (any::<Index>(), other).prop_map(|(seed, leaves)| {
        let mut request = seed.get(&REQUESTS).clone();
        for (leaf, value) in leaves {
            replace(&mut request["in"], leaf, &value);
        }
        request.to_string().into_bytes()
    });
    let mutated = (any::<Index>(), changes())
        .prop_map(|(seed, changes)| changed(&seed.get(&REQUESTS).to_string(), changes));
    let line = prop_oneof![3 => regular, 1 => mutated];
    line.prop_map(|bytes| bytes.into_iter().filter(|&byte| byte != b'\n').collect())
}

/// Every line gets an answer in its place, in each quality.
#[test]
fn protocol_lines() {
    let count = cases(3000).cases as usize;
    let mut runner = TestRunner::new(ProptestConfig::default());
    let lines: Vec<Vec<u8>> = (0..count)
        .map(|_| line().new_tree(&mut runner).expect("a line").current())
        .collect();
    let answered = protocol_line(&lines.join(&b'\n'));
    assert!(
        answered > count / 10 && answered < count,
        "{answered} of {count} are requests"
    );
}
