//! Numbers of assemblies: those of the list at the reference input, wherever else assemblies are
//! listed.

use linkage_runtime::{Circuits, Estimate};

use linkage_engine::Assembly;
use linkage_engine::Mechanism;

/// Distance of an assembly computed in two ways from itself, at most; a share of the size of the
/// mechanism.
const SAME: f64 = 1e-6;

/// For each assembly over the range, its number in the list at the reference input; the next ones
/// for those that do not reach it.
pub(super) fn numbers(
    mechanism: &Mechanism,
    dimensions: &[f64],
    circuits: &Circuits<Assembly<'_>>,
) -> Vec<usize> {
    let at = mechanism.reference();
    // Without an assembly at the reference nothing has been numbered.
    let listed = mechanism.assemblies(dimensions, &at).unwrap_or_default();
    let mut listed: Vec<Option<Vec<Estimate>>> = listed
        .iter()
        .map(|assembly| Some(assembly.unknowns(&at)))
        .collect();
    let mut next = listed.len();
    let branches = circuits.branches.iter();
    let found: Vec<Option<usize>> = branches
        .map(|branch| {
            let [low, high] = branch.ends.map(|end| end.x());
            let there = (low..=high)
                .contains(&at[0])
                .then(|| branch.assembly.unknowns(&at))?;
            let index = listed.iter().position(|states| {
                let states = states.as_ref();
                states.is_some_and(|states| is_same(states, &there))
            })?;
            listed[index] = None;
            Some(index + 1)
        })
        .collect();
    let numbered = found.into_iter().map(|number| {
        number.unwrap_or_else(|| {
            next += 1;
            next
        })
    });
    numbered.collect()
}

/// Returns true if all unknowns are in the same places.
fn is_same(a: &[Estimate], b: &[Estimate]) -> bool {
    let numbers =
        |estimate: &Estimate| estimate.numbers.iter().map(|x| x.abs()).fold(0.0, f64::max);
    let lengths = a.iter().filter(|a| !a.angle);
    let size = lengths.map(numbers).fold(0.0, f64::max);
    a.iter().zip(b).all(|(a, b)| {
        a.numbers
            .iter()
            .zip(&b.numbers)
            .all(|(x, y)| match a.angle {
                // Half a turn and minus half a turn are one direction.
                true => (0.5 * (x - y)).sin().abs() <= SAME,
                false => (x - y).abs() <= SAME * size,
            })
    })
}
