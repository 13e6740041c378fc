//! Data with which the page computes, besides the programs, which are part of its script.

use serde_json::{Map, Value, json};

use crate::builder::Report;
use crate::json::motion_data::motion_value;

/// Arguments beside the input, modes, the picture's number among the tables, the text of the
/// mechanism.
pub(super) fn live_value(report: &Report) -> Value {
    let given = report.given.iter();
    let given: Map<_, _> = given
        .map(|(name, value)| (name.clone(), json!(value)))
        .collect();
    let modes = report.modes.iter().map(|mode| mode.sign());
    let mut tables = report.tables.iter().enumerate();
    let picture = tables.find_map(|(table, saved)| {
        let first = saved.heading.picture?.first;
        Some(json!({ "table": table, "first": first }))
    });
    let mut value = json!({
        "given": given,
        "modes": modes.collect::<std::vec::Vec<f64>>(),
        "picture": picture,
    });
    if let Some(source) = &report.source {
        value["source"] = json!(source);
    }
    if let Some(motion) = &report.motion {
        value["motion"] = motion_value(report, motion);
    }
    value
}
