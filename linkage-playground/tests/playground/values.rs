//! Values in a browser are those of this machine.

use linkage_playground::answer;
use serde_json::{Value, json};

use crate::node::answers;

/// Positions of each function.
const STEPS: usize = 61;

fn examples() -> Vec<(String, String)> {
    let all: Value =
        serde_json::from_str(&answer(&json!({ "do": "examples" }).to_string())).expect("JSON");
    let text = |example: &Value, name: &str| example[name].as_str().expect("a text").to_owned();
    let all = all.as_array().expect("a list").iter();
    all.map(|example| (text(example, "name"), text(example, "text")))
        .collect()
}

/// Numbers of all functions of a mechanism.
fn numbers(tables: &Value) -> Vec<f64> {
    let tables = tables.as_array().expect("a list").iter();
    let bits = tables.flat_map(|table| table["bits"].as_array().expect("a list"));
    let number = |bits: &Value| u64::from_str_radix(bits.as_str().expect("a text"), 16);
    bits.map(|bits| f64::from_bits(number(bits).expect("bits")))
        .collect()
}

/// All functions of all examples, bit by bit.
#[test]
fn values_are_those_of_this_machine() {
    let examples = examples();
    let request = |text: &str| json!({ "do": "values", "text": text, "steps": STEPS });
    let requests: Vec<Value> = examples.iter().map(|(_, text)| request(text)).collect();
    let Some(answered) = answers(&requests) else {
        return;
    };
    assert_eq!(answered.len(), examples.len());
    let mut count = 0;
    for (((name, _), request), there) in examples.iter().zip(&requests).zip(answered) {
        let [here, there]: [Value; 2] = [answer(&request.to_string()), there.answer]
            .map(|answer| serde_json::from_str(&answer).expect("JSON"));
        let pairs = numbers(&here).into_iter().zip(numbers(&there));
        let different = pairs.filter(|(here, there)| here.to_bits() != there.to_bits());
        assert_eq!(different.count(), 0, "{name}");
        assert_eq!(here, there, "{name}");
        count += numbers(&here).len();
    }
    assert!(count > 20_000, "{count} numbers");
}
