//! Closing a coupled group at the reference input: all its assemblies are listed, the one nearest to the estimates is taken. Where they
//! cannot be listed, `assembly/followed.rs` goes on.

use crate::assembly::continuation;
use crate::assembly::estimates;
use crate::assembly::followed;
use crate::assembly::unfollowed;
use linkage_core::numeric::choose_assembly::{Ambiguity, choose_assembly, may_be_meant};
use linkage_core::numeric::continuation::{
    Grid, Range, Refusal, Table, Terms, meeting_states, states,
};
use linkage_core::numeric::roots::{self, Term, Unlisted};

use crate::algebra::Algebra;
use crate::ir::{Coupled, Start};
use crate::message_format::loop_list;
use crate::solve::{Prepared, Solved};

use super::estimates::{Choice, LISTED, Position};
use super::follow::followed_range;
use super::numbers::Numbers;
use super::reference::Assembly;

/// An assembly of a coupled group.
pub(super) struct Candidate {
    pub(super) state: Vec<f64>,
    pub(super) position: Position,
}

/// The real assemblies of a coupled group.
struct Listed {
    /// Those that are told apart, the nearest to the estimates first.
    candidates: Vec<Candidate>,
    /// How far from the estimates others are, about, that meet at a dead point.
    meeting: Vec<f64>,
}

/// Closes a coupled group; false if that was not possible.
pub(super) fn close_coupled<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
) -> bool {
    let loops = loop_list(&solved.group.loops);
    let unknowns = assembly.words.unknowns(&solved.group.unknowns);
    let place = assembly.words.at_reference(&assembly.nominal.inputs);
    let origin = assembly.algebra.mechanism.loops[solved.group.loops[0]].origin;
    if assembly.machine.closing.coupled[prepared.number].followed {
        return followed::close_followed(assembly, solved, prepared, None);
    }
    let Listed {
        candidates,
        meeting,
    } = match candidates(assembly, prepared.number) {
        Ok(listed) => listed,
        Err(Unlisted::NotFinite) => {
            followed::without_equations(assembly, solved);
            return false;
        }
        Err(reason) => return followed::close_followed(assembly, solved, prepared, Some(reason)),
    };
    let listed = candidates
        .iter()
        .take(LISTED)
        .map(|c| {
            format!(
                "`{}` at distance {:.4}",
                estimates::shown(assembly, &c.position),
                c.position.distance
            )
        })
        .collect::<Vec<_>>()
        .join(", ");
    let distances = candidates.iter().map(|one| one.position.distance);
    let chosen = choose_assembly(distances, Ambiguity::AS_WRITTEN);
    let distance = chosen.map_or(f64::INFINITY, |own| candidates[own.index].position.distance);
    let others_meet = !meeting.is_empty();
    let mut meeting = meeting.into_iter();
    if meeting.any(|other| may_be_meant(other, distance, Ambiguity::AS_WRITTEN)) {
        unfollowed::refused(assembly, solved, prepared, Refusal::NotASolution);
        return false;
    }
    let Some(chosen) = chosen else {
        assembly.reporter.error(
                origin,
                format!(
                    "{loops} ({unknowns}) cannot close{place}: no assembly is real\n\
                     help: change a length, or give a reference input at which the links reach each other"
                ),
            );
        return false;
    };
    let positions: Vec<&Position> = candidates.iter().map(|one| &one.position).collect();
    let choice = match others_meet {
        false => Choice::Listed,
        true => Choice::ListedApart,
    };
    if chosen.ambiguous && estimates::lacks_estimates(assembly, solved, &positions, choice) {
        return false;
    }
    if chosen.ambiguous {
        let unknown = solved.group.unknowns.first();
        let own = unknown.map(|&u| assembly.algebra.mechanism.unknowns[u].origin);
        assembly.reporter.error(
                own.unwrap_or(origin),
                format!(
                    "the start estimates of {unknowns} lie equally near to two assemblies of {loops}{place}; there are {}{}{}: \
                     {listed}\n\
                     help: move the estimates towards the assembly that is meant",
                    candidates.len(),
                    choice.beside(),
                    if candidates.len() > LISTED { ", the nearest" } else { "" }
                ),
            );
        return false;
    }
    if !estimates::meets_estimates(assembly, solved, &positions, choice) {
        return false;
    }
    prepare(assembly, solved, prepared, &candidates[chosen.index].state)
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
                Start::Grid(grid) => continuation::is_served(assembly, solved, prepared, grid),
                Start::Table(_) => true,
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

/// Whether polynomials serve the ranges.
fn fits<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    start: &Result<Start, Refusal>,
) -> bool {
    let Ok(Start::Grid(grid)) = start else {
        return false;
    };
    let (mut numbers, reference) = numbers(assembly, prepared.number);
    grid.left_out().is_none() && grid.serves(&mut numbers, &reference)
}

/// A coupled group at the reference inputs, and those of them that are its own.
pub(super) fn numbers<'a>(
    assembly: &'a Assembly<'_, '_>,
    number: usize,
) -> (Numbers<'a>, Vec<f64>) {
    Numbers::new(&assembly.machine, number, &assembly.nominal.inputs)
}

/// All real assemblies.
fn candidates(assembly: &mut Assembly<'_, '_>, number: usize) -> Result<Listed, Unlisted> {
    let (mut numbers, own) = numbers(assembly, number);
    let group = &assembly.machine.closing.coupled[number];
    let coefficients = numbers.run(&group.system, &[]);
    let coefficients: Vec<[f64; 2]> = coefficients.chunks(2).map(|c| [c[0], c[1]]).collect();
    let terms: Vec<Term> = group
        .terms
        .iter()
        .map(|(equation, exponents)| Term {
            equation: *equation,
            exponents,
        })
        .collect();
    let system = roots::System {
        variables: &group.variables,
        terms: &terms,
    };
    let listing = roots::solve(&system, &coefficients)?;
    let regular = states(&group.variables, &listing, &own, &mut numbers);
    let candidate = |state: Vec<f64>| {
        let placed = numbers.run(&group.placed, &state);
        candidate_of(assembly, group, state, &placed)
    };
    let mut candidates: Vec<Candidate> = regular.into_iter().map(candidate).collect();
    candidates.sort_by(|a, b| a.position.distance.total_cmp(&b.position.distance));
    let meeting = meeting_states(&group.variables, &listing).into_iter();
    let meeting = meeting.map(|state| candidate(state).position.distance);
    Ok(Listed {
        candidates,
        meeting: meeting.collect(),
    })
}

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
        position: estimates::position(assembly, values),
    }
}

/// Prepares the group over the declared ranges. Where none is declared, as far as the assembly goes.
fn start<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> Result<Start, Refusal> {
    let (mut numbers, at) = numbers(assembly, prepared.number);
    let ranges = prepared.inputs.iter().map(|&input| {
        let (low, high) = followed_range(assembly.algebra, assembly.nominal, input);
        let turn = is_angle(assembly.algebra, input);
        Range { low, high, turn }
    });
    let ranges: Vec<Range> = ranges.collect();
    match (&ranges[..], prepared.has_table()) {
        ([range], true) => {
            let partial = assembly.nominal.ranges[prepared.inputs[0]].is_none();
            Table::build(&mut numbers, at[0], state, *range, partial).map(Start::Table)
        }
        _ => Grid::build_all(&mut numbers, &at, state, &ranges, prepared.in_cells).map(Start::Grid),
    }
}

fn is_angle(algebra: &Algebra, input: usize) -> bool {
    algebra.mechanism.inputs[input].dimension.half_lengths == 0
}
