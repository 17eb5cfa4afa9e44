//! The oracle against 338 vectors whose truth another program computed, from the same definitions, in another language:
//! every field, to the last digit.

use ombrage_oracle::case::KINDS;
use ombrage_oracle::truth;
use serde_json::Value;
use std::path::Path;

/// The vectors of `data/`, in order.
fn vectors() -> Vec<Value> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let lines = |kind: &str| std::fs::read_to_string(data.join(format!("{kind}.jsonl"))).unwrap();
    let parse = |line: &str| serde_json::from_str(line).unwrap();
    KINDS
        .iter()
        .flat_map(|kind| lines(kind).lines().map(parse).collect::<Vec<Value>>())
        .collect()
}

/// The paths at which two values differ.
fn differences(path: &str, given: &Value, found: &Value) -> Vec<String> {
    match (given, found) {
        (Value::Object(a), Value::Object(b)) if a.keys().eq(b.keys()) => a
            .iter()
            .flat_map(|(key, x)| differences(&format!("{path}.{key}"), x, &b[key]))
            .collect(),
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => a
            .iter()
            .zip(b)
            .enumerate()
            .flat_map(|(i, (x, y))| differences(&format!("{path}[{i}]"), x, y))
            .collect(),
        _ if given == found => Vec::new(),
        _ => vec![format!("{path}: given {given}, found {found}")],
    }
}

#[test]
fn every_field_of_every_vector() {
    let vectors = vectors();
    assert_eq!(vectors.len(), 338);
    let wrong: Vec<String> = vectors
        .iter()
        .flat_map(|case| {
            let found = truth(case).unwrap();
            differences(case["id"].as_str().unwrap(), &case["exp"], &found)
        })
        .collect();
    assert!(
        wrong.is_empty(),
        "{} fields differ:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

/// A copy of `value` with the last digit of the string at `pointer` changed.
fn with_another_last_digit(value: &Value, pointer: &str) -> Value {
    let mut value = value.clone();
    let text = value.pointer_mut(pointer).unwrap();
    let mut digits = text.as_str().unwrap().to_owned();
    let last = digits.pop().unwrap();
    digits.push(if last == '0' { '1' } else { '0' });
    *text = digits.into();
    value
}

#[test]
fn one_wrong_digit_is_found() {
    let generic = vectors()
        .into_iter()
        .find(|case| case["id"] == "ray_sphere.generic.f64.0001")
        .unwrap();
    for pointer in ["/t0/bits", "/t0/dec", "/p/2/bits", "/n_out/0/dec"] {
        let wrong = with_another_last_digit(&generic["exp"], pointer);
        assert_eq!(
            differences("", &wrong, &truth(&generic).unwrap()).len(),
            1,
            "{pointer}"
        );
    }
    for pointer in ["/in/o/0", "/in/r"] {
        let other = with_another_last_digit(&generic, pointer);
        assert!(
            !differences("", &generic["exp"], &truth(&other).unwrap()).is_empty(),
            "{pointer}"
        );
    }
}
