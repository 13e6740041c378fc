//! Values as text.

use linkage_core::range_check::{position_as_written, significant};

use crate::name_values::Value;

/// Returns a number with its unit, angles in degrees: `30deg`, `12.5mm`, `0.3N*mm`.
pub(crate) fn number(x: f64, unit: &str) -> String {
    match unit {
        "rad" => position_as_written(x, true, unit),
        "m" | "cm" | "mm" | "um" | "inch" => position_as_written(x, false, unit),
        _ => format!("{}{unit}", significant(x)),
    }
}

/// Returns the value at the reference: `30deg`, `(1mm, 2mm)`.
pub(crate) fn reference(value: &Value) -> String {
    let numbers = value.reference.iter().map(|x| number(*x, &value.unit));
    joined(numbers.collect())
}

/// Returns the value at the reference as [`reference`] does, with five digits.
pub(crate) fn short(value: &Value) -> String {
    let numbers = value.reference.iter().map(|x| {
        let shown = if value.unit == "rad" {
            x.to_degrees()
        } else {
            *x
        };
        let rounded: f64 = format!("{shown:.4e}").parse().unwrap_or(shown);
        match value.unit.as_str() {
            "rad" => format!("{}deg", significant(rounded)),
            unit => number(rounded, unit),
        }
    });
    joined(numbers.collect())
}

/// Returns the extremes of each component: `12mm..15mm`, `x 1mm..2mm, y -3mm..4mm`. `None` if there
/// are none, or nothing changes.
pub(crate) fn extremes(value: &Value) -> Option<String> {
    let changes = |(low, high): &(f64, f64)| low < high;
    if !value.extremes.iter().any(changes) {
        return None;
    }
    let range = |(low, high): &(f64, f64)| {
        format!(
            "{} to {}",
            number(*low, &value.unit),
            number(*high, &value.unit)
        )
    };
    Some(match &value.extremes[..] {
        [one] => range(one),
        several => {
            let named = several.iter().zip(["x", "y", "z"]);
            let named = named.map(|(extremes, name)| format!("{name} {}", range(extremes)));
            named.collect::<Vec<_>>().join(", ")
        }
    })
}

fn joined(texts: Vec<String>) -> String {
    match &texts[..] {
        [one] => one.clone(),
        several => format!("({})", several.join(", ")),
    }
}
