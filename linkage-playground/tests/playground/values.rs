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

/// All functions of all examples, bit by bit. Tangents and arcs of single numbers are those of the
/// machine's library, and no example has them.
#[test]
fn values_are_those_of_the_command() {
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
        let tables = here.as_array().unwrap_or_else(|| panic!("{name}: {here}"));
        for (table, other) in tables.iter().zip(there.as_array().expect("a list")) {
            let function = &table["function"];
            let bits = table["bits"].as_array().expect("a list");
            let different = bits.iter().zip(other["bits"].as_array().expect("a list"));
            let different = different.filter(|(a, b)| a != b).count();
            assert_eq!(
                different,
                0,
                "{name}, {function}: of {} numbers",
                bits.len()
            );
            count += bits.len();
        }
        assert_eq!(here, there, "{name}");
    }
    assert!(count > 50_000, "{count} numbers");
}
