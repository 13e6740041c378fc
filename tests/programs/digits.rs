//! References of more digits than a double has: numbers that are written as strings of digits.

#![allow(dead_code, reason = "no example needs every kind of list")]

use serde_json::Value;
use std::error::Error;

/// A number.
pub(crate) fn number(value: &Value) -> Result<f64, Box<dyn Error>> {
    Ok(value.as_str().ok_or("digits")?.parse()?)
}

/// So many of them.
pub(crate) fn numbers<const N: usize>(values: &Value) -> Result<[f64; N], Box<dyn Error>> {
    let mut found = [0.0; N];
    for (k, found) in found.iter_mut().enumerate() {
        *found = number(&values[k])?;
    }
    Ok(found)
}

/// Those of several places.
pub(crate) fn all<'v>(
    values: impl IntoIterator<Item = &'v Value>,
) -> Result<Vec<f64>, Box<dyn Error>> {
    values.into_iter().map(number).collect()
}
