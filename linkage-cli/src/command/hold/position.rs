//! The position at which a result is wanted: outside of the range, or out of reach of the links.

use linkage_engine::Mechanism;
use linkage_runtime::Input;

use crate::command::assemblies::{placed, shown};

/// The part of a range by which rounding may go beyond its ends.
const ROUNDING: f64 = 1e-12;

/// Prints a note for each input outside of its range, except for the one that is sought.
pub(super) fn note_of_range(mechanism: &Mechanism, inputs: &[f64], sought: &str) {
    let pairs = mechanism.inputs().iter().zip(inputs);
    for (input, &x) in pairs.filter(|(input, _)| input.name != sought) {
        if let Some(range) = range_left(input, x) {
            eprintln!(
                "note: `{}` is outside of its range {range}",
                placed(input, x)
            );
        }
    }
}

/// Returns the range of an input that is outside of it.
fn range_left(input: &Input, x: f64) -> Option<String> {
    let (low, high) = input.range?;
    let spare = ROUNDING * (high - low);
    let is_inside = (low - spare..=high + spare).contains(&x);
    let ends = [low, high].map(|end| shown(input, end));
    (!is_inside).then(|| format!("{} .. {}", ends[0], ends[1]))
}
