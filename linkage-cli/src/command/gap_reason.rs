//! The reason for which a mechanism has no assembly at a position.

use linkage_compiler::length_as_written;
use linkage_engine::{Assembly, Mechanism};

use super::assemblies::placed;
use super::rounded::rounded;
use crate::failure::listed;

/// Significant digits of a distance.
const DIGITS: usize = 3;

/// Returns `` at `x = 91 mm`: loop 1 (`psi`) misses by 1 mm ``, with joints and links if the text has
/// them. `inputs` are all inputs of the mechanism.
pub(super) fn reason_of_gap(mechanism: &Mechanism, assembly: &Assembly, inputs: &[f64]) -> String {
    let gaps = assembly.gaps(inputs);
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
            let (gap, unit) = length_as_written(rounded(gaps[open], DIGITS), unit);
            let loops = group.loop_names();
            let unknowns = listed(group.unknowns.iter().copied());
            let space = if unit.is_empty() { "" } else { " " };
            let miss = match group.loops {
                [_] => "misses",
                _ => "miss",
            };
            format!("{loops} ({unknowns}) {miss} by {gap}{space}{unit}")
        }
        None => {
            "the mechanism stands at a dead point or a change point, or cannot be assembled there"
                .to_owned()
        }
    };
    format!("{at}: {why}")
}
