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
    let size = size(value);
    let numbers = value.reference.iter().map(|x| {
        let x = &without_noise(*x, size);
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
    let size = size(value);
    let range = |(low, high): &(f64, f64)| {
        let shown = |x| number(without_noise(x, size), &value.unit);
        format!("{} to {}", shown(*low), shown(*high))
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

/// Returns the largest magnitude among the components, at the reference and over the range.
fn size(value: &Value) -> f64 {
    let extremes = value.extremes.iter().flat_map(|(low, high)| [low, high]);
    let numbers = value.reference.iter().chain(extremes);
    numbers.fold(0.0, |largest, x| x.abs().max(largest))
}

/// Returns 0 for a number that is a rounding error of numbers of a size.
fn without_noise(x: f64, size: f64) -> f64 {
    const ROUNDING: f64 = 1e-12;
    if x.abs() < ROUNDING * size { 0.0 } else { x }
}

fn joined(texts: Vec<String>) -> String {
    match &texts[..] {
        [one] => one.clone(),
        several => format!("({})", several.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(reference: &[f64], extremes: &[(f64, f64)]) -> Value {
        Value {
            reference: reference.to_vec(),
            extremes: extremes.to_vec(),
            unit: "mm".to_owned(),
        }
    }

    #[test]
    fn rounding_errors_are_zero() {
        let pin = value(&[8.9e-16, 40.0], &[(-40.0, 40.0), (-8.9e-16, 40.0)]);
        assert_eq!(short(&pin), "(0mm, 40mm)");
        let shown = extremes(&pin).expect("it changes");
        assert_eq!(shown, "x -40mm to 40mm, y 0mm to 40mm");
        assert_eq!(short(&value(&[8.9e-16], &[(8.9e-16, 3.0)])), "0mm");
        // A small number is none by itself.
        assert_eq!(short(&value(&[2e-9], &[])), number(2e-9, "mm"));
    }
}
