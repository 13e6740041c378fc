//! Straight paths from the reference to the ends of the ranges of several inputs.
//!
//! A dead point on such a path is in the ranges. It is found in a moment, while a grid over ranges
//! with dead points in them takes seconds.

use linkage_core::numeric::continuation::{self, Grid, LeftOut};

use crate::solve::{Prepared, Solved};

use super::assembler::Assembly;
use super::refused_range::{FoundBox, OR_LENGTHS, RefusedRange, range_of};

/// A range may end at a dead point: the rest of the way does not count.
const END: f64 = 1e-9;

/// The largest numbers of inputs with paths to every half of edges and faces, to their middles, and
/// to corners alone: always some hundred paths at most.
const HALVES: usize = 3;
const MIDDLES: usize = 4;
const INPUTS: usize = 8;

/// Returns the inputs at the dead point of a coupled group that is nearest to the reference,
/// measured as a share of its path. Returns `None` if there is none, without ranges, and with one
/// input, whose table finds its own dead points.
pub(super) fn dead_point<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> Option<Vec<f64>> {
    if prepared.has_table() {
        return None;
    }
    let (mut numbers, from) = assembly.coupled(prepared.number);
    let mut nearest: Option<(f64, Vec<f64>)> = None;
    for to in ends(assembly, prepared, &from) {
        let share = continuation::dead_point(&mut numbers, &from, state, &to);
        let Some(share) = share.filter(|share| *share < 1.0 - END) else {
            continue;
        };
        if nearest.as_ref().is_none_or(|(least, _)| share < *least) {
            let at = from.iter().zip(&to).map(|(a, b)| a + share * (b - a));
            nearest = Some((share, at.collect()));
        }
    }
    let (_, at) = nearest?;
    let mut inputs = assembly.nominal.inputs.clone();
    for (&input, x) in prepared.inputs.iter().zip(at) {
        inputs[input] = x;
    }
    Some(inputs)
}

/// Returns points on the border of the declared ranges: the corners, then, unless they are too
/// many, the points between them at which some inputs stay or go half of their way.
fn ends(assembly: &Assembly<'_, '_>, prepared: &Prepared, from: &[f64]) -> Vec<Vec<f64>> {
    let ranges = || {
        prepared
            .inputs
            .iter()
            .map(|&input| assembly.nominal.ranges[input])
    };
    let declared = ranges().flatten().count();
    if declared > INPUTS {
        return Vec::new();
    }
    let mut ends = vec![(Vec::new(), false)];
    for (range, &at) in ranges().zip(from) {
        let (low, high) = range.unwrap_or((at, at));
        let mut places = vec![(low, true), (high, true)];
        if declared <= MIDDLES {
            places.push((at, false));
        }
        if declared <= HALVES {
            places.extend([low, high].map(|end| (0.5 * (at + end), false)));
        }
        if range.is_none() {
            places = vec![(at, false)];
        }
        let longer = ends.iter().flat_map(|(end, border)| {
            let with_input = |(input, is_end): &(f64, bool)| {
                ([end.as_slice(), &[*input]].concat(), *border || *is_end)
            };
            places.iter().map(with_input)
        });
        ends = longer.collect();
    }
    let border = ends.into_iter().filter(|(_, border)| *border);
    border
        .map(|(end, _)| end)
        .filter(|end| end != from)
        .collect()
}

/// Checks that a grid covers the positions that it should: the reference, and, as far as is known,
/// all positions at which the mechanism is regular. Returns the refusal if it does not.
pub(super) fn unserved<'m>(
    assembly: &Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    grid: &Grid,
) -> Option<RefusedRange> {
    if let Some(left_out) = grid.left_out() {
        return Some(leaves_out(assembly, solved, prepared, left_out));
    }
    let (mut numbers, reference) = assembly.coupled(prepared.number);
    let served = grid.serves(&mut numbers, &reference);
    (!served).then(|| beside_dead_point(assembly, solved, prepared))
}

/// A grid that does not reach the reference: its margin would be that of a dead point,
/// although it is at none.
fn beside_dead_point<'m>(
    assembly: &Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
) -> RefusedRange {
    let mechanism = assembly.algebra.mechanism;
    let origin = prepared
        .inputs
        .first()
        .map_or(mechanism.loops[solved.group.loops[0]].origin, |&input| {
            mechanism.inputs[input].origin
        });
    let fact = format!(
        "{} ({}) cannot be prepared at the reference inputs {}: a dead point is so near that the smallest cells of linkage do not reach \
             the assembly there; the reference itself is none",
        assembly.words.loops(&solved.group.loops),
        assembly.words.unknowns(&solved.group.unknowns),
        assembly
            .words
            .inputs(&assembly.nominal.inputs, &prepared.inputs),
    );
    RefusedRange {
        origins: [origin; 2],
        fact,
        narrower: "shorten the ranges",
        otherwise: ", or move the reference away from the dead point".to_owned(),
        found: FoundBox::Largest,
    }
}

/// A grid that leaves out positions at which the mechanism is regular.
fn leaves_out<'m>(
    assembly: &Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    left_out: &LeftOut,
) -> RefusedRange {
    let mut inputs = assembly.nominal.inputs.clone();
    for (&input, &x) in prepared.inputs.iter().zip(&left_out.at) {
        inputs[input] = x;
    }
    let ranges = prepared.inputs.iter();
    let declared = ranges.map(|&input| &assembly.algebra.mechanism.inputs[input]);
    let declared: Vec<_> = declared.filter(|input| input.range.is_some()).collect();
    let origins = declared.first().map_or(
        [assembly.algebra.mechanism.loops[solved.group.loops[0]].origin; 2],
        |input| range_of(input),
    );
    let fact = format!(
        "{} ({}) cannot be prepared over these ranges: {:.1} % of their positions would be left out, {} among them, though no dead point \
             is near; this is a limit of linkage, not a mistake of yours",
        assembly.words.loops(&solved.group.loops),
        assembly.words.unknowns(&solved.group.unknowns),
        100.0 * left_out.share,
        assembly.words.inputs(&inputs, &prepared.inputs),
    );
    RefusedRange {
        origins,
        fact,
        narrower: "shorten the ranges",
        otherwise: String::new(),
        found: FoundBox::Largest,
    }
}

/// A mechanism that comes apart within the ranges of several inputs.
pub(super) fn apart<'m>(
    assembly: &Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    inputs: &[f64],
) -> RefusedRange {
    let mechanism = assembly.algebra.mechanism;
    let moved = |&&input: &&usize| inputs[input] != assembly.nominal.inputs[input];
    let first = prepared.inputs.iter().find(moved);
    let origins = first.map_or(
        [mechanism.loops[solved.group.loops[0]].origin; 2],
        |&input| range_of(&mechanism.inputs[input]),
    );
    let reach = match solved.group.loops.len() {
        1 => "reaches",
        _ => "reach",
    };
    let fact = format!(
        "the mechanism comes apart in this range: {} ({}) {reach} a dead point at {}",
        assembly.words.loops(&solved.group.loops),
        assembly.words.unknowns(&solved.group.unknowns),
        assembly.words.inputs(inputs, &prepared.inputs),
    );
    RefusedRange {
        origins,
        fact,
        narrower: "restrict the range",
        otherwise: OR_LENGTHS.to_owned(),
        found: FoundBox::Largest,
    }
}
