//! Comments on arguments, dimensions and results, and on costs.

use linkage_compiler::ir::{Column, CompiledMechanism, Field, Input, Scalar, Shape, in_degrees};
use linkage_symbolic::count::Count;

/// Returns the unit and the range of an input: `rad, from -90 deg to 630 deg`.
pub(crate) fn input_note(input: &Input) -> String {
    let words = if input.angle { "rad" } else { &input.unit };
    match input.range {
        Some((low, high)) => {
            let [low, high] = [low, high].map(|end| in_degrees(end, words));
            format!("{words}, from {low} to {high}")
        }
        None => words.to_owned(),
    }
}

/// Returns the unit and the tolerances of a dimension.
pub(crate) fn dimension_note(scalars: &[Scalar]) -> String {
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
pub(crate) fn field_note(field: &Field, columns: &[Column]) -> String {
    let about = match &field.description()[..] {
        "" => "a number".to_owned(),
        // Comments of plain text have no mark for names.
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

/// Returns the reference inputs: `phi = 30 deg`.
pub(crate) fn reference_note(unit: &CompiledMechanism) -> String {
    let inputs = unit.inputs.iter().map(|input| {
        format!(
            "{} = {}",
            input.name,
            in_degrees(input.reference, &input.unit)
        )
    });
    inputs.collect::<Vec<_>>().join(", ")
}

/// Returns the unit of all lengths, if unknowns are lengths.
pub(crate) fn length_unit(unit: &CompiledMechanism) -> Option<&str> {
    let unknowns = unit.unknowns.iter();
    let mut lengths = unknowns.filter(|unknown| !unknown.is_number && !unknown.unit.is_empty());
    lengths.next().map(|unknown| &unknown.unit[..])
}

/// Returns the operations of a program as a sentence: `12 additions, 20 multiplications, 1 root.`
pub fn operations(count: &Count) -> String {
    let kinds = [
        (count.add, "addition"),
        (count.mul, "multiplication"),
        (count.div, "division"),
        (count.sqrt, "root"),
        (count.sin_cos, "sine and cosine"),
        (count.atan2, "arc tangent"),
        (count.other, "other operation"),
    ];
    let words = kinds.iter().filter(|(count, _)| *count > 0);
    let words = words.map(|(count, word)| match (count, *word) {
        (1, word) => format!("1 {word}"),
        (count, "sine and cosine") => format!("{count} sines and cosines"),
        (count, word) => format!("{count} {word}s"),
    });
    let words: Vec<String> = words.collect();
    match words.is_empty() {
        true => "No operation at all.".to_owned(),
        false => words.join(", ") + ".",
    }
}
