//! The position at which a result is wanted: outside of the range, or out of reach of the links.

use linkage_compiler::length_as_written;
use linkage_engine::Mechanism;
use linkage_runtime::Input;

use crate::command::assemblies::{placed, shown};
use crate::failure::{Failure, listed};

/// The part of a range by which rounding may go beyond its ends.
const ROUNDING: f64 = 1e-12;

/// Returns all inputs: those among the arguments of a function, the others at their references.
pub(super) fn inputs_given(mechanism: &Mechanism, function: usize, arguments: &[f64]) -> Vec<f64> {
    let mut inputs = mechanism.reference();
    let indices = &mechanism.compiled().functions[function].arguments;
    for (&index, &x) in indices.iter().zip(arguments) {
        if let Some(input) = inputs.get_mut(index) {
            *input = x;
        }
    }
    inputs
}

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

/// Returns `` at `x = 91 mm`: loop 1 (`psi`) misses by 1 mm ``.
pub(super) fn reason_of_gap(
    mechanism: &Mechanism,
    dimensions: &[f64],
    inputs: &[f64],
) -> Result<String, Failure> {
    let gaps = mechanism.assemble(dimensions)?.gaps(inputs);
    let pairs = mechanism.inputs().iter().zip(inputs);
    let positions: Vec<String> = pairs.map(|(input, &x)| placed(input, x)).collect();
    let at = match positions.is_empty() {
        true => "here".to_owned(),
        false => format!("at {}", listed(positions.iter().map(String::as_str))),
    };
    let why = match gaps.iter().position(|gap| *gap > 0.0) {
        Some(open) => {
            let group = mechanism.structure().groups[open];
            let unit = &mechanism.compiled().groups[open].gap_unit;
            let (gap, unit) = length_as_written(rounded(gaps[open]), unit);
            let loops: Vec<String> = group.loops.iter().map(ToString::to_string).collect();
            let unknowns = listed(group.unknowns.iter().copied());
            let space = if unit.is_empty() { "" } else { " " };
            match &loops[..] {
                [only] => format!("loop {only} ({unknowns}) misses by {gap}{space}{unit}"),
                all => format!(
                    "loops {} ({unknowns}) miss by {gap}{space}{unit}",
                    all.join(", ")
                ),
            }
        }
        None => {
            "the mechanism stands at a dead point or a change point, or cannot be assembled there"
                .to_owned()
        }
    };
    Ok(format!("{at}: {why}"))
}

/// Returns the range of an input that is outside of it.
fn range_left(input: &Input, x: f64) -> Option<String> {
    let (low, high) = input.range?;
    let spare = ROUNDING * (high - low);
    let is_inside = (low - spare..=high + spare).contains(&x);
    let ends = [low, high].map(|end| shown(input, end));
    (!is_inside).then(|| format!("{} .. {}", ends[0], ends[1]))
}

/// Three digits of a distance.
fn rounded(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}
