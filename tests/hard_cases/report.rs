//! A failing case in full: inputs, expected and actual, as decimal, hex and bits.

use ombrage::conformance::Judged;
use serde_json::Value;
use std::fmt::Write;

/// The case, what it expects, what was answered, and the distance in between.
pub fn describe(judged: &Judged) -> String {
    let Judged {
        case, out, verdict, ..
    } = judged;
    let mut text = format!(
        "{} ({:?}, {:.3} ulp",
        case.id(),
        verdict.wrong,
        verdict.ulps
    );
    if let Some(bounds) = verdict.bounds {
        // Writing to a string cannot fail.
        let _ = write!(text, ", {bounds:.3} u B");
    }
    text += ")\n";
    for (what, value) in [
        ("in", &case.value()["in"]),
        ("expected", case.truth()),
        ("actual", out),
    ] {
        let _ = writeln!(text, "  {what}");
        lines(value, what, &mut text);
    }
    text
}

fn lines(value: &Value, path: &str, text: &mut String) {
    match value {
        Value::Object(fields) => {
            for (key, value) in fields {
                lines(value, key, text);
            }
        }
        Value::Array(values) if !values.is_empty() => {
            for (place, value) in values.iter().enumerate() {
                lines(value, &format!("{path}[{place}]"), text);
            }
        }
        _ => {
            let _ = writeln!(text, "    {path:<12} {}", number(value));
        }
    }
}

/// A float given by its bits: decimal, hex and bits. Anything else as it is.
pub fn number(value: &Value) -> String {
    let digits = value.as_str().unwrap_or_default();
    let hex = u64::from_str_radix(digits, 16);
    match (digits.len(), hex) {
        (8, Ok(bits)) => format!("{:e}  {digits}  {bits:032b}", f32::from_bits(bits as u32)),
        (16, Ok(bits)) => format!("{:e}  {digits}  {bits:064b}", f64::from_bits(bits)),
        _ => value.to_string(),
    }
}

#[test]
fn a_number_is_shown_three_ways() {
    let one = number(&Value::from("3f800000"));
    assert_eq!(one, "1e0  3f800000  00111111100000000000000000000000");
    assert!(number(&Value::from("c000000000000000")).starts_with("-2e0  c000000000000000  11000"));
    assert_eq!(number(&Value::Null), "null");
}
