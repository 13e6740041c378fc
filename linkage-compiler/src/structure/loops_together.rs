//! All loops of a set together on numbers: at the reference and at positions around it.

use crate::algebra::names::Names;
use crate::algebra::{Bound, Nominal};
use crate::model::Dimension;
use crate::structure::equations;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::simultaneous::SimultaneousLoops;

/// Positions besides the reference, as shares of a small motion to both sides.
const POSITIONS: [f64; 5] = [0.0, 0.5, 1.0, -0.5, -1.0];

/// The motion at most: so far the assembly is not left, and lengths that fit by chance at the
/// reference fit no more.
const TURN: f64 = 0.2;

const SHIFT: f64 = 0.02;

/// The unknowns with all components where all loops close, if they do so wherever the inputs go.
pub(crate) fn all_closed<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<Vec<Vec<f64>>> {
    let together = simultaneous_loops(names, nominal, equations, coordinates)?;
    let found = closed_at(nominal, &together, &positions(names, nominal))?;
    let mut values: Vec<Vec<f64>> = vec![Vec::new(); nominal.estimates.len()];
    for (coordinate, x) in coordinates.iter().zip(&found[0]) {
        values[coordinate.unknown?].push(*x);
    }
    Some(values)
}

/// The coordinates at all positions, if every loop closes at each.
pub(crate) fn closed_at(
    nominal: &Nominal,
    together: &SimultaneousLoops,
    places: &[Vec<f64>],
) -> Option<Vec<Vec<f64>>> {
    // An input that does not move proves nothing.
    let moves = places.iter().any(|position| *position != places[0]);
    let mut found: Vec<Vec<f64>> = Vec::new();
    for inputs in places {
        let at = Nominal {
            inputs: inputs.clone(),
            ..nominal.clone()
        };
        let near = found.first().unwrap_or(&together.estimates).clone();
        found.push(together.closed(near, &at)?);
    }
    moves.then_some(found)
}

/// Inputs at the reference and around it. Several go their ways in different steps.
pub(crate) fn positions(names: &Names<'_>, nominal: &Nominal) -> Vec<Vec<f64>> {
    let longest = longest(names, nominal);
    let inputs = names.mechanism.inputs.iter().enumerate();
    let ends: Vec<[f64; 3]> = inputs
        .map(|(k, input)| {
            let at = nominal.inputs[k];
            let most = match input.dimension.half_lengths {
                0 => TURN,
                _ => SHIFT * longest,
            };
            let (low, high) = nominal.ranges[k].unwrap_or((at - most, at + most));
            [
                at,
                (0.5 * (at - low)).min(most),
                (0.5 * (high - at)).min(most),
            ]
        })
        .collect();
    let position = |step: usize| {
        let inputs = ends.iter().enumerate().map(|(k, [at, below, above])| {
            let share = match step {
                0 => 0.0,
                _ => POSITIONS[1 + (step - 1 + k) % (POSITIONS.len() - 1)],
            };
            at + share * if share < 0.0 { below } else { above }
        });
        inputs.collect()
    };
    (0..POSITIONS.len()).map(position).collect()
}

/// The largest length among parameters and estimates.
pub(crate) fn longest(names: &Names<'_>, nominal: &Nominal) -> f64 {
    let parameters = &names.mechanism.scalar_parameters;
    let lengths = parameters.iter().zip(&nominal.parameters);
    let lengths = lengths.filter(|(p, _)| p.dimension.fits(Dimension::LENGTH));
    let bound = names.bound.iter().zip(&nominal.estimates);
    let slides = bound.filter(|(bound, _)| matches!(bound, Bound::Lengths(_)));
    let all = lengths
        .map(|(_, x)| *x)
        .chain(slides.flat_map(|(_, x)| x.iter().copied()));
    let longest = all.map(f64::abs).fold(0.0, f64::max);
    if longest > 0.0 { longest } else { 1.0 }
}

/// The loops on numbers; `None` if there is an unknown that the compiler introduced, of which
/// nothing is estimated.
pub(crate) fn simultaneous_loops<'m, 'c>(
    names: &Names<'m>,
    nominal: &Nominal,
    equations: &[Equation<'m>],
    coordinates: &'c [Coordinate],
) -> Option<SimultaneousLoops<'c, 'm>> {
    let longest = longest(names, nominal);
    let mut estimates = Vec::new();
    let mut scales = Vec::new();
    for (k, coordinate) in coordinates.iter().enumerate() {
        let unknown = coordinate.unknown?;
        let before = coordinates[..k].iter();
        let component = before.filter(|c| c.unknown == Some(unknown)).count();
        estimates.push(*nominal.estimates[unknown].get(component)?);
        scales.push(match coordinate.kind {
            CoordinateKind::Angle(_) => 1.0,
            CoordinateKind::Length(_) => longest,
        });
    }
    Some(SimultaneousLoops {
        rows: equations.iter().flat_map(|e| e.rows.clone()).collect(),
        coordinates,
        symbols: coordinates
            .iter()
            .map(|c| equations::symbols(names, c))
            .collect(),
        estimates,
        scales,
    })
}
