//! Sweeps for measurements.

use linkage_engine::{Mechanism, Table};
use serde_json::json;

use crate::page::{arguments, positions};

/// Sweeps a function over the range of the first input, again and again. The answer has the sum of
/// the last results, so that none is left out.
///
/// # Errors
///
/// The messages, if the text has mistakes or no such function.
pub(crate) fn sweep(
    text: &str,
    function: &str,
    count: usize,
    repeats: usize,
) -> Result<String, String> {
    let mechanism = Mechanism::compile(text).map_err(|error| error.to_string())?;
    let function = mechanism.function(function);
    let function = function.map_err(|error| error.to_string())?;
    let assembly = mechanism.assemble(&mechanism.dimensions());
    let assembly = assembly.map_err(|error| error.to_string())?;
    let positions = positions(&mechanism.inputs()[0], count);
    let given = arguments(&mechanism, function);
    let mut slices: Vec<&[f64]> = given.chunks(1).collect();
    slices[0] = &positions;
    let mut columns = assembly.sweep(function, &slices);
    for _ in 1..repeats {
        assembly.sweep_into(function, &slices, &mut columns);
    }
    let indices = 0..columns.heading().columns.len();
    let sum: f64 = indices.flat_map(|index| columns.column(index)).sum();
    Ok(json!({ "sum": sum }).to_string())
}
