//! Changes of the sign of a function over a range, for searches along an input.

use linkage_core::numeric::bracket::{self, Sample};

/// Returns the values of a function at the ends of all `parts` of a range.
pub(crate) fn samples(
    function: impl Fn(f64) -> f64,
    [low, high]: [f64; 2],
    parts: usize,
) -> Vec<Sample> {
    let width = (high - low) / parts.max(1) as f64;
    let sample = |i: usize| {
        let input = if i == parts {
            high
        } else {
            low + width * i as f64
        };
        (input, function(input))
    };
    (0..=parts).map(sample).collect()
}

/// Locates the change of the sign between two samples, to the last digit; `None` if the signs are
/// equal, or a value is zero or NaN.
pub(crate) fn change_of_sign(
    function: impl Fn(f64) -> f64,
    before: Sample,
    after: Sample,
) -> Option<f64> {
    let mut value_at = |x: f64| [function(x), f64::NAN];
    (before.1 * after.1 < 0.0).then(|| bracket::root(before, after, &mut value_at))
}
