//! Numbers in attributes.

use crate::error::ImportError;
use crate::names::shown;
use crate::number::decimal;
use crate::placement::{Vector, unit};
use crate::xml::XmlElement;

/// The largest number of a file that describes a mechanism in metres and kilograms.
const LARGEST: f64 = 1e9;

/// The numbers of a text, `name` in messages.
pub(super) fn numbers(text: &str, name: &str) -> Result<Vec<f64>, ImportError> {
    let words = text.split_whitespace();
    words
        .map(|word| {
            let value = decimal(word, name)?.value;
            match value.abs() < LARGEST {
                true => Ok(value),
                false => Err(ImportError::new(format!(
                    "{name} is `{}`, which is too large",
                    shown(word)
                ))),
            }
        })
        .collect()
}

/// As many numbers of a text.
pub(super) fn exactly<const N: usize>(text: &str, name: &str) -> Result<[f64; N], ImportError> {
    let found = numbers(text, name)?;
    let count = found.len();
    found.try_into().map_err(|_| {
        ImportError::new(format!(
            "{name} has {count} numbers where {N} are expected: `{}`",
            shown(text)
        ))
    })
}

/// As many numbers of an attribute, if it exists.
pub(super) fn attribute<const N: usize>(
    element: &XmlElement,
    name: &str,
) -> Result<Option<[f64; N]>, ImportError> {
    let text = element.attribute(name);
    let full = || format!("`{name}` of `{}`", shown(&element.name));
    text.map(|text| exactly(text, &full())).transpose()
}

/// Returns the axis of a joint as a unit vector.
pub(super) fn axis_of(axis: Vector, name: &str) -> Result<Vector, ImportError> {
    unit(axis)
        .ok_or_else(|| ImportError::new(format!("the axis of the joint `{}` is zero", shown(name))))
}
