//! A motion under forces as JSON.

use serde_json::{Value, json};
use std::vec::Vec;

use crate::builder::Report;
use crate::driven_motion::{DrivenMotion, Watched};

/// Returns a motion as JSON, with tables by their index.
pub(super) fn motion_value(report: &Report, motion: &DrivenMotion) -> Value {
    let table = |name: &str| {
        let mut tables = report.tables.iter();
        tables.position(|table| table.heading.function == name)
    };
    let inputs = motion.inputs.iter().map(|input| {
        json!({
            "name": input.name,
            "speed": input.speed,
            "acceleration": input.acceleration,
            "column": input.column,
        })
    });
    let stops = motion.stops.iter().map(|stop| {
        let (input, speed, column) = match stop.watched {
            Watched::Input(input) => (Some(input), None, None),
            Watched::Speed(speed) => (None, Some(speed), None),
            Watched::Column(column) => (None, None, Some(column)),
        };
        json!({ "text": stop.text, "input": input, "speed": speed, "column": column, "value": stop.value })
    });
    let energy = motion.energy.as_ref().map(|energy| {
        json!({ "table": table(&energy.table), "loads": energy.loads, "weights": energy.weights })
    });
    json!({
        "table": table(&motion.function),
        "state": table(&motion.state),
        "inputs": inputs.collect::<Vec<Value>>(),
        "energy": energy,
        "until": motion.until,
        "tolerance": motion.tolerance,
        "stops": stops.collect::<Vec<Value>>(),
        "end": motion.end,
    })
}
