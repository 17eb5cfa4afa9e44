//! Whatever JSON comes in, the oracle answers or names the key that is wrong, with its value.

use ombrage_oracle::truth;
use serde_json::{Value, json};

/// One good request of each kind.
fn requests() -> Vec<Value> {
    let zero = json!(["00000000", "00000000", "00000000"]);
    let z = json!(["00000000", "00000000", "3f800000"]);
    let plane = json!({"type": "plane", "q": z, "n": z, "color": z});
    let sphere = json!({"type": "sphere", "c": z, "r": "3f000000", "color": z});
    let ray = json!({"o": zero, "d": z, "tmin": "00000000", "tmax": "7f800000"});
    let with = |more: Value| {
        let mut all = ray.clone();
        all.as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        all
    };
    let inputs = [
        ("ray_plane", with(json!({"q": z, "n": z}))),
        ("ray_sphere", with(json!({"c": z, "r": "3f000000"}))),
        ("any_hit", with(json!({"objs": [plane, sphere]}))),
        (
            "light_sample",
            json!({"p": zero, "light": z, "power": "3f800000", "color": z}),
        ),
        (
            "shade",
            with(
                json!({"objs": [plane, sphere], "light": zero, "power": "3f800000", "light_color": z, "background": "3f000000"}),
            ),
        ),
        (
            "offset",
            json!({"o": zero, "d": z, "obj": sphere, "p": z, "n": z}),
        ),
        ("quantise", json!({"x": "3f000000"})),
    ];
    inputs
        .map(|(kind, input)| json!({"kind": kind, "prec": "f32", "in": input}))
        .into()
}

/// The pointers to everything inside a value, and to itself.
fn pointers(value: &Value, path: &str) -> Vec<String> {
    let children: Vec<(String, &Value)> = match value {
        Value::Object(map) => map
            .iter()
            .map(|(key, value)| (key.clone(), value))
            .collect(),
        Value::Array(list) => list
            .iter()
            .enumerate()
            .map(|(i, value)| (i.to_string(), value))
            .collect(),
        _ => Vec::new(),
    };
    let below = children
        .into_iter()
        .flat_map(|(key, value)| pointers(value, &format!("{path}/{key}")));
    below.chain([path.to_owned()]).collect()
}

#[test]
fn good_requests_have_a_truth() {
    for request in requests() {
        assert!(truth(&request).is_ok(), "{request}");
    }
}

#[test]
fn any_part_replaced_by_nonsense_is_an_error_that_names_it() {
    for request in requests() {
        for pointer in pointers(&request, "") {
            for nonsense in [
                json!(null),
                json!(1.5),
                json!("zebra"),
                json!([]),
                json!({}),
                json!("3f8000000"),
            ] {
                let mut broken = request.clone();
                *broken.pointer_mut(&pointer).unwrap() = nonsense.clone();
                if let Err(error) = truth(&broken) {
                    assert!(error.to_string().contains('"'), "{error}");
                } else {
                    assert!(
                        pointer.ends_with("/objs") && nonsense == json!([])
                            || !is_read(&request, &pointer),
                        "{pointer} = {nonsense}: {request}"
                    );
                }
            }
        }
    }
}

/// A colour is not read where it means nothing.
fn is_read(request: &Value, pointer: &str) -> bool {
    request["kind"] == "shade" || !pointer.contains("/color")
}

#[test]
fn messages() {
    let mut request = requests().swap_remove(1);
    request["in"]["r"] = json!("3f80000g");
    assert_eq!(
        truth(&request).unwrap_err().to_string(),
        "\"r\" is \"3f80000g\", expected the bits of an f32 as 8 hexadecimal digits"
    );
    request["in"].as_object_mut().unwrap().remove("r");
    assert_eq!(
        truth(&request).unwrap_err().to_string(),
        "key \"r\" is missing"
    );
}

#[test]
fn every_special_float_everywhere() {
    for request in requests() {
        for pointer in pointers(&request["in"], "/in") {
            for bits in [
                "7fc00000", "7f800000", "ff800000", "80000000", "00000001", "7f7fffff", "ff7fffff",
            ] {
                let mut special = request.clone();
                let value = special.pointer_mut(&pointer).unwrap();
                if value.as_str().is_some_and(|s| s.len() == 8) {
                    *value = json!(bits);
                    let refused =
                        pointer == "/in/background" && bits.contains("f8") | bits.contains("7fc");
                    assert_eq!(truth(&special).is_err(), refused, "{special}");
                }
            }
        }
    }
}

/// xorshift64: patterns of every size, most of them far outside any scene.
struct Bits(u64);

impl Bits {
    fn next(&mut self) -> String {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        format!("{:016x}", self.0)
    }

    /// A copy of `value` with bits of an f64 in the place of those of every f32.
    fn scramble(&mut self, value: &Value) -> Value {
        match value {
            Value::String(bits) if bits.len() == 8 => self.next().into(),
            Value::Array(list) => list.iter().map(|value| self.scramble(value)).collect(),
            Value::Object(map) => map
                .iter()
                .map(|(key, value)| (key.clone(), self.scramble(value)))
                .collect::<serde_json::Map<_, _>>()
                .into(),
            other => other.clone(),
        }
    }
}

#[test]
fn random_bits_have_a_truth() {
    let mut bits = Bits(0x9e37_79b9_7f4a_7c15);
    for request in requests() {
        for _ in 0..60 {
            let mut random = request.clone();
            random["prec"] = json!("f64");
            random["in"] = bits.scramble(&request["in"]);
            match truth(&random) {
                Ok(_) => {}
                Err(error) => assert!(error.to_string().contains("\"background\""), "{error}"),
            }
        }
    }
}
