use ombrage::Quality;
use ombrage::conformance::{Case, Kernel, Kernels, answer, vectors};
use serde_json::Value;
use std::sync::LazyLock;
use xtask::conform;

/// Some cases of every kind in every format, which are called 0, 1 and so on.
static GROUPS: LazyLock<Vec<Vec<Case>>> = LazyLock::new(|| {
    let groups = Kernel::ALL.into_iter().flat_map(|kernel| {
        let cases = vectors(kernel).expect("valid");
        ["f32", "f64"].map(|float| group(cases.iter().filter(|case| case.float() == float)))
    });
    groups.collect()
});

/// How many cases a group has: more than may fail in a row.
const CASES: usize = 20;

fn group<'a>(cases: impl Iterator<Item = &'a Case>) -> Vec<Case> {
    let cases: Vec<&Case> = cases.collect();
    let some = cases.iter().step_by(cases.len() / CASES).take(CASES);
    let renamed = |(number, case): (usize, &&Case)| {
        let mut value = case.value().clone();
        value["id"] = number.to_string().into();
        Case::new(value).expect("a case")
    };
    some.enumerate().map(renamed).collect()
}

/// What the kit's best kernels print about a group, after the byte that chooses it.
pub fn right_answers(group: usize) -> Option<String> {
    let choice = char::from(b'A' + u8::try_from(group).ok()?);
    let kernels = Kernels {
        quality: Quality::Wide,
        shadow: None,
    };
    let right = |case: &Case| answer(&kernels, &case.request()).expect("an answer");
    let lines = GROUPS
        .get(group)?
        .iter()
        .map(|case| format!("{}\n", right(case)));
    Some(format!("{choice}{}", lines.collect::<String>()))
}

/// Whatever a program prints, it is judged, and the report is JSON, and text that controls no
/// terminal. The first byte chooses
/// what it is asked and held to, from `A` on; form feeds part the output of one process from the
/// next. Returns the verdict.
pub fn adapter_answer(bytes: &[u8]) -> String {
    let (choice, output) = bytes.split_first().unwrap_or((&b'A', &[]));
    let choice = usize::from(choice.wrapping_sub(b'A'));
    let cases = &GROUPS[choice % GROUPS.len()];
    let quality = (choice / GROUPS.len()).checked_sub(1);
    let quality = quality.and_then(|quality| Quality::ALL.get(quality).copied());
    let outputs: Vec<&[u8]> = output.split(|&byte| byte == b'\x0c').collect();
    let [text, json] = conform::judge(cases, &outputs, quality).expect("a report");
    assert!(
        text.chars().all(|c| c == '\n' || !c.is_control()),
        "{text:?}"
    );
    let report: Value = serde_json::from_str(&json).expect("JSON");
    let counts = ["passed", "failed", "unsupported"].map(|key| report["kinds"][0][key].as_u64());
    let sum: u64 = counts
        .into_iter()
        .map(|count| count.expect("a count"))
        .sum();
    assert_eq!(sum, CASES as u64, "{text}");
    report["verdict"].as_str().expect("a verdict").to_owned()
}
