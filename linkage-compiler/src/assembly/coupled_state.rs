//! A coupled group in a known state: its unknowns, and its preparation over the ranges of inputs.

use linkage_core::numeric::continuation::{Grid, Range, Refusal, Table, Terms};

use crate::algebra::Algebra;
use crate::ir::{Coupled, PreparedTable};
use crate::machine::followed_range;
use crate::solve::{Prepared, Solved};

use super::assembler::Assembly;
use super::estimates::Position;
use super::{continuation, estimates, unfollowed};

/// An assembly of a coupled group.
pub(super) struct Candidate {
    pub(super) state: Vec<f64>,
    pub(super) position: Position,
}

/// Prepares a group whose state is known; false if that was not possible.
pub(super) fn prepare<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> bool {
    if let Some(inputs) = continuation::dead_point(assembly, prepared, state) {
        continuation::apart(assembly, solved, prepared, &inputs);
        return false;
    }
    let start = start(assembly, prepared, state);
    if prepared.in_cells == Terms::Polynomials && !fits(assembly, prepared, &start) {
        assembly.needs_slopes = true;
        return false;
    }
    match start {
        Ok(start) => {
            let served = match &start {
                PreparedTable::Grid(grid) => {
                    continuation::is_served(assembly, solved, prepared, grid)
                }
                PreparedTable::Table(_) => true,
            };
            assembly.machine.starts[prepared.number] = Some(start);
            served
        }
        Err(refusal) => {
            unfollowed::refused(assembly, solved, prepared, refusal);
            false
        }
    }
}

/// Checks that polynomials fit over the ranges.
fn fits<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    start: &Result<PreparedTable, Refusal>,
) -> bool {
    let Ok(PreparedTable::Grid(grid)) = start else {
        return false;
    };
    let (mut numbers, reference) = assembly.coupled(prepared.number);
    grid.left_out().is_none() && grid.serves(&mut numbers, &reference)
}

/// The assembly with a state, whose unknowns are `placed`.
pub(super) fn candidate_of(
    assembly: &Assembly<'_, '_>,
    group: &Coupled,
    state: Vec<f64>,
    placed: &[f64],
) -> Candidate {
    let mut next = placed.iter().copied();
    let mut values: Vec<(usize, Vec<f64>)> = Vec::new();
    for unknown in &group.unknowns {
        let mut number = || next.next().unwrap_or(f64::NAN);
        let value = match unknown.angle {
            true => estimates::angle_near_estimate(assembly, unknown.unknown, [number(), number()]),
            false => number(),
        };
        match values.last_mut() {
            Some((last, components)) if *last == unknown.unknown => components.push(value),
            _ => values.push((unknown.unknown, vec![value])),
        }
    }
    Candidate {
        state,
        position: estimates::position(assembly, values, &[]),
    }
}

/// Prepares the group over the declared ranges; if none is declared, as far as the assembly goes.
fn start<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> Result<PreparedTable, Refusal> {
    let (mut numbers, at) = assembly.coupled(prepared.number);
    let ranges = prepared.inputs.iter().map(|&input| {
        let (low, high) = followed_range(assembly.algebra, assembly.nominal, input);
        let turn = is_angle(assembly.algebra, input);
        Range { low, high, turn }
    });
    let ranges: Vec<Range> = ranges.collect();
    match (&ranges[..], prepared.has_table()) {
        ([range], true) => {
            let partial = assembly.nominal.ranges[prepared.inputs[0]].is_none();
            Table::build(&mut numbers, at[0], state, *range, partial).map(PreparedTable::Table)
        }
        _ => Grid::build_all(&mut numbers, &at, state, &ranges, prepared.in_cells)
            .map(PreparedTable::Grid),
    }
}

fn is_angle(algebra: &Algebra, input: usize) -> bool {
    algebra.mechanism.inputs[input].dimension.half_lengths == 0
}
