//! All values of a text as bits, without fused multiply-adds: the same here and in a browser.

use linkage_engine::{Mechanism, Source, compile};
use serde_json::{Value, json};

use crate::document::FILE;
use crate::page::{arguments, positions, shown};

/// Returns the table of each function over the range of the first input, for all mechanisms that have
/// one: the bits of all values as hexadecimal numbers.
///
/// # Errors
///
/// The messages, if the text has mistakes.
pub(crate) fn values(text: &str, steps: usize) -> Result<String, String> {
    let source = Source::new(FILE, text).map_err(|error| error.to_string())?;
    let mechanisms = compile(FILE, text).map_err(|error| error.to_string())?;
    let mut tables = Vec::new();
    for mechanism in mechanisms {
        // A mechanism without an input has no page.
        let Ok(mechanism) = shown(&source, mechanism) else {
            continue;
        };
        let mechanism = mechanism.with_separate_multiply_adds();
        for function in 0..mechanism.headings().len() {
            tables.push(table(&mechanism, function, steps)?);
        }
    }
    Ok(Value::from(tables).to_string())
}

fn table(mechanism: &Mechanism, function: usize, steps: usize) -> Result<Value, String> {
    let assembly = mechanism.assemble(&mechanism.dimensions());
    let assembly = assembly.map_err(|error| error.to_string())?;
    let heading = mechanism.headings()[function];
    let input = &mechanism.inputs()[0];
    let mut given = arguments(mechanism, function);
    let input_index = heading
        .arguments
        .iter()
        .position(|argument| *argument == input.name);
    let bits = positions(input, steps).into_iter().flat_map(|position| {
        if let Some(index) = input_index {
            given[index] = position;
        }
        let results = assembly.call(function, &given).into_iter();
        results.map(|result| format!("{:016x}", result.to_bits()))
    });
    let bits: Vec<String> = bits.collect();
    Ok(json!({ "mechanism": mechanism.name(), "function": heading.function, "bits": bits }))
}
