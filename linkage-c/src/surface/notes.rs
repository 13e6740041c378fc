//! Comments on arguments, dimensions and results.

use linkage_compiler::ir::{Column, CompiledMechanism, Shape, in_degrees};

/// `rad, from -90 deg to 630 deg`
pub(super) fn input_note(unit: &CompiledMechanism, index: usize) -> String {
    let input = &unit.inputs[index];
    let words = if input.angle { "rad" } else { &input.unit };
    match input.range {
        Some((low, high)) => {
            let [low, high] = [low, high].map(|end| in_degrees(end, words));
            format!("{words}, from {low} to {high}")
        }
        None => words.to_owned(),
    }
}

pub(super) fn dimension_note(scalars: &[linkage_compiler::ir::Scalar]) -> String {
    let unit = match &scalars[0].unit[..] {
        "" => "a number",
        unit => unit,
    };
    let tolerances: Vec<String> = scalars
        .iter()
        .map(|scalar| in_degrees(scalar.tolerance, &scalar.unit))
        .collect();
    match scalars.iter().any(|entry| entry.tolerance != 0.0) {
        true => format!("{unit}; tolerance {}", tolerances.join(", ")),
        false => unit.to_owned(),
    }
}

/// Returns the meaning with its unit, and the names of the entries of an array.
pub(super) fn field_note(field: &linkage_compiler::ir::Field, columns: &[Column]) -> String {
    let about = match &field.description()[..] {
        "" => "a number".to_owned(),
        // In C there is no mark for names.
        about => about.strip_prefix("in ").unwrap_or(about).replace('`', ""),
    };
    match field.shape {
        Shape::Array(..) => {
            let names: Vec<&str> = columns.iter().map(|column| &column.name[..]).collect();
            format!("{about}: {}", names.join(", "))
        }
        Shape::Scalar | Shape::Vector(_) | Shape::Frame | Shape::PlaneFrame => about,
    }
}

/// Returns the reference inputs for comments.
pub(crate) fn reference(unit: &CompiledMechanism) -> String {
    let inputs = unit.inputs.iter();
    let places: Vec<String> = inputs
        .map(|input| {
            format!(
                "{} = {}",
                input.name,
                in_degrees(input.reference, &input.unit)
            )
        })
        .collect();
    places.join(", ")
}
