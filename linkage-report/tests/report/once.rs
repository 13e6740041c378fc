//! Numbers that the JSON has once.

use crate::data::{json, numbers};
use crate::fixture::FourBar;
use crate::four_bar;
use serde_json::Value;
use std::collections::BTreeSet;

/// The numbers of a series, which may stand in a column.
pub(crate) fn series(json: &Value, value: &Value) -> Vec<f64> {
    match (value["table"].as_u64(), value["column"].as_u64()) {
        (Some(table), Some(column)) => {
            numbers(&json["tables"][table as usize]["columns"][column as usize]["values"])
        }
        _ => numbers(value),
    }
}

/// All lists of numbers as long as the report, wherever they stand.
fn lists<'a>(value: &'a Value, found: &mut Vec<&'a Value>) {
    match value {
        Value::Array(items) if items.len() == 361 => found.push(value),
        Value::Array(items) => items.iter().for_each(|item| lists(item, found)),
        Value::Object(members) => members.values().for_each(|item| lists(item, found)),
        _ => {}
    }
}

#[test]
fn numbers_stand_in_it_once() {
    let json = json(&four_bar(FourBar::GAPPED).speed(1.0, 0.0));
    let mut found = Vec::new();
    lists(&json, &mut found);
    let different: BTreeSet<String> = found.iter().map(|list| list.to_string()).collect();
    assert_eq!(found.len(), different.len());
    // The picture's own table has them; at a speed of one, true velocities are the derivatives.
    let tables = serde_json::json!({ "table": 2, "column": 4 });
    assert_eq!(json["picture"]["points"][2]["at"][0], tables);
    assert_eq!(
        json["true"][0]["values"],
        serde_json::json!({ "table": 0, "column": 2 })
    );
}
