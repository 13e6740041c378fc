//! Published numbers, computed with 60 digits.

use linkage::Parameter;
use serde_json::Value;

pub(crate) fn cyclogram() -> Value {
    read(include_str!("cyclogram.json"))
}

pub(crate) fn mutual() -> Value {
    read(include_str!("mutual.json"))
}

fn read(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

/// A number, which is written as a string of digits unless it is a whole one.
pub(crate) fn number(value: &Value) -> f64 {
    if let Some(whole) = value.as_i64() {
        return whole as f64;
    }
    value
        .as_str()
        .and_then(|digits| digits.parse().ok())
        .unwrap_or_else(|| panic!("a number: {value}"))
}

/// The number in radians.
pub(crate) fn radians(value: &Value) -> f64 {
    number(value).to_radians()
}

/// The derivatives by the parameters, in their order. `member` stands before the names of the reference: `hook` and
/// `P1x` are `hook_p1.x`. 0 for a parameter of another organ.
pub(crate) fn derivatives(value: &Value, member: &str, parameters: &[Parameter]) -> Vec<f64> {
    let plain = |name: &str| name.replace(['.', '_'], "").to_lowercase();
    let known = value.as_object().expect("an object");
    let mut used = 0;
    let of = |parameter: &Parameter| {
        let mut own = known
            .iter()
            .filter(|(name, _)| plain(&format!("{member}{name}")) == plain(parameter.name));
        own.next().map_or(0.0, |(_, value)| {
            used += 1;
            number(value)
        })
    };
    let found = parameters.iter().map(of).collect();
    // Lengths and angles that only the reference has do nothing.
    let idle = known
        .iter()
        .filter(|(_, value)| number(value) == 0.0)
        .count();
    assert!(
        used + idle >= known.len(),
        "{used} of {} {member}",
        known.len()
    );
    found
}
