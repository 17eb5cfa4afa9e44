//! The generator: complete, well formed, the same every time, and not too large.

use ombrage_oracle::case::KINDS;
use ombrage_oracle::families::{cases, cases_of, write_jsonl};
use serde_json::Value;
use std::collections::{BTreeMap, HashSet};
use std::path::Path;

/// `kind.family.prec`
fn stem(case: &Value) -> String {
    ["kind", "family", "prec"]
        .map(|key| case[key].as_str().unwrap())
        .join(".")
}

#[test]
fn every_sample_family_in_both_formats() {
    let generated: HashSet<String> = cases().map(|case| stem(&case)).collect();
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let mut samples = 0;
    for kind in KINDS {
        let text = std::fs::read_to_string(data.join(format!("{kind}.jsonl"))).unwrap();
        for line in text.lines() {
            let stem = stem(&serde_json::from_str(line).unwrap());
            assert!(generated.contains(&stem), "{stem} is not generated");
            samples += 1;
        }
    }
    assert_eq!(samples, 338);
}

#[test]
fn numbered_from_one_and_unique() {
    let mut last: BTreeMap<String, usize> = BTreeMap::new();
    for case in cases() {
        let count = last.entry(stem(&case)).or_default();
        *count += 1;
        assert_eq!(case["id"], format!("{}.{count:04}", stem(&case)));
    }
    assert!(last.values().sum::<usize>() >= 3000);
    for stem in last.keys() {
        let other = stem.replace(".f32", ".f64");
        assert!(last.contains_key(&other), "{other} is missing");
    }
}

#[test]
fn no_family_says_the_same_twice() {
    let mut seen: BTreeMap<String, String> = BTreeMap::new();
    let twins: Vec<String> = cases()
        .filter_map(|case| {
            let id = case["id"].to_string();
            let first = seen.insert(format!("{} {}", stem(&case), case["in"]), id.clone())?;
            Some(format!("{first} = {id}"))
        })
        .collect();
    assert!(
        twins.is_empty(),
        "{} twins:\n{}",
        twins.len(),
        twins.join("\n")
    );
}

#[test]
fn lines_of_json_within_five_megabytes() {
    let mut size = 0;
    for kind in KINDS {
        let text = write_jsonl(kind);
        assert_eq!(text.lines().count(), cases_of(kind).count());
        for line in text.lines() {
            let case: Value = serde_json::from_str(line).unwrap();
            assert_eq!(case["kind"], kind);
        }
        size += text.len();
    }
    assert!(size < 5_000_000, "{size} bytes");
}

/// FNV-1a of the whole output: the same on every machine, until a recipe or the truth changes.
#[test]
fn the_same_everywhere() {
    let hash = KINDS
        .iter()
        .flat_map(|kind| write_jsonl(kind).into_bytes())
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    assert_eq!(format!("{hash:016x}"), "4ddfcb25d734f2ef");
}
