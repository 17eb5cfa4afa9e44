//! Lines of the kernel protocol: each is answered in its place.

use crate::{cases, changed, changes, seeds};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use serde_json::Value;
use std::io::Write;
use std::process::{Command, Stdio};
use std::sync::LazyLock;
use std::thread;

/// The requests of tests/vectors, without their truth.
static REQUESTS: LazyLock<Vec<Value>> = LazyLock::new(|| {
    let files = seeds("vectors");
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
    for options in [
        ["--quality", "textbook"],
        ["--quality", "stable"],
        ["--quality", "wide"],
        ["--shadow", "error-bound"],
    ] {
        let lines: Vec<Vec<u8>> = (0..count)
            .map(|_| line().new_tree(&mut runner).expect("a line").current())
            .collect();
        let mut program = Command::new(env!("CARGO_BIN_EXE_xtask"));
        program.arg("kernels").args(options);
        program
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = program.spawn().expect("the program starts");
        let mut input = child.stdin.take().expect("an input");
        let text = lines.join(&b'\n');
        // Ends early where the program does, which the answers then show.
        let writer = thread::spawn(move || drop(input.write_all(&text)));
        let output = child.wait_with_output().expect("an end");
        writer.join().expect("the lines are written");
        let answers = String::from_utf8(output.stdout).expect("UTF-8");
        let shown = |number: usize| String::from_utf8_lossy(&lines[number]).into_owned();
        let mut answered = 0;
        for (number, answer) in answers.lines().enumerate() {
            let answer: Value = serde_json::from_str(answer).expect("JSON");
            let kinds = ["out", "unsupported", "error"].map(|key| answer.get(key).is_some());
            let one = kinds.into_iter().filter(|&is| is).count() == 1;
            assert!(one, "{}: {answer}", shown(number));
            answered += usize::from(kinds[0]);
            if kinds[2] {
                assert_eq!(answer["line"], number + 1, "{}", shown(number));
            }
        }
        let all = answers.lines().count();
        assert_eq!(
            all,
            lines.len(),
            "after {}",
            shown(all.min(lines.len() - 1))
        );
        assert_eq!(String::from_utf8_lossy(&output.stderr), "");
        assert!(
            answered > count / 10 && answered < count,
            "{answered} of {count} are requests"
        );
    }
}
