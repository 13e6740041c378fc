//! Preparation of all coupled groups of a mechanism, one group after the other.

use super::group::CoupledGroup;
use super::initial_state::InitialState;
use super::programs::CoupledPrograms;
use super::solution::CoupledSolution;
use super::solve::{list_solutions, nearest_solution};
use crate::error::AssemblyError;
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::numeric::continuation::{Grid, Range, Refusal, Table};

/// The assemblies to prepare.
#[derive(Clone, Copy, Debug)]
pub enum Which<'a> {
    /// The one nearest to the start estimates.
    Nearest,
    /// Every real one, the nearest to the estimates first.
    All,
    /// The one nearest to another.
    Like(&'a [InitialState]),
}

/// Prepares the coupled groups in their order. `programs` returns the programs of group `k`, given
/// the initial states of those before it; `at` are all inputs of the mechanism, and `nothing` is
/// the list `S` of as many initial states as groups with [`InitialState::Nothing`] alone.
///
/// # Errors
///
/// Where a wanted assembly is not there, or cannot be prepared.
pub fn initial_states<S: AsMut<[InitialState]> + Clone, P: CoupledPrograms>(
    groups: &[CoupledGroup],
    nothing: S,
    at: &[f64],
    wanted: Which<'_>,
    programs: impl Fn(usize, &S) -> Result<P, AssemblyError>,
) -> Result<Vec<S>, AssemblyError> {
    let mut found = vec![nothing];
    for (number, group) in groups.iter().enumerate() {
        let x = group.inputs_among(at);
        let mut next = Vec::new();
        let mut missed = None;
        for before in found {
            let mut programs = programs(number, &before)?;
            let solutions = match wanted {
                Which::Nearest => vec![nearest_solution(group, &mut programs, &x)?],
                Which::All => match list_solutions(group, &mut programs, &x) {
                    // Other assemblies of the groups before may let it close.
                    Err(error) if error.is_a_miss() => {
                        missed = Some(error);
                        continue;
                    }
                    listed => listed?,
                },
                Which::Like(like) => {
                    let state = like[number].state(&x);
                    let solutions = list_solutions(group, &mut programs, &x)?;
                    nearest(solutions, &state).into_iter().collect()
                }
            };
            for solution in solutions {
                let every = matches!(wanted, Which::All);
                let mut initial_states = before.clone();
                let ranges = group.ranges();
                let initial_state =
                    start(group, &mut programs, &x, &solution.state, &ranges, every)?;
                initial_states.as_mut()[number] = initial_state;
                next.push(initial_states);
            }
        }
        if let (true, Some(error)) = (next.is_empty(), missed) {
            return Err(error);
        }
        found = next;
    }
    Ok(found)
}

/// The solution with the nearest state.
fn nearest(solutions: Vec<CoupledSolution>, state: &[f64]) -> Option<CoupledSolution> {
    let distance = |solution: &CoupledSolution| -> f64 {
        let pairs = solution.state.iter().zip(state);
        pairs.map(|(a, b)| (a - b) * (a - b)).sum()
    };
    solutions
        .into_iter()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// Prepares a group from a solution at its inputs `x`. Where no range is declared, and for `every`
/// assembly that was requested, as far as the solution goes; one that cannot be followed at all is
/// prepared for these inputs alone.
fn start(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
    state: &[f64],
    ranges: &[Range],
    every: bool,
) -> Result<InitialState, AssemblyError> {
    let mut made = over(group, programs, x, state, ranges, every);
    let mut serves = |start: &InitialState| match start {
        InitialState::Grid(grid) => grid.serves(programs, x),
        InitialState::Nothing | InitialState::Table(_) => true,
    };
    let nothing = !made.as_ref().is_ok_and(&mut serves);
    if every && nothing {
        let here = x.iter().map(|&x| Range {
            low: x,
            high: x,
            turn: false,
        });
        made = over(
            group,
            programs,
            x,
            state,
            &here.collect::<Vec<Range>>(),
            every,
        );
    }
    let start = made.map_err(|refusal| group.refused(refusal))?;
    match &start {
        InitialState::Grid(grid) if !every => match grid.left_out() {
            Some(left_out) => Err(group.leaves_out(left_out)),
            None if nothing => Err(group.beside_dead_point(x)),
            None => Ok(start),
        },
        _ => Ok(start),
    }
}

/// Prepares a group over these ranges.
fn over(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
    state: &[f64],
    ranges: &[Range],
    every: bool,
) -> Result<InitialState, Refusal> {
    match group.inputs {
        [input] => {
            let partial = every || !input.declared;
            Table::build(programs, x[0], state, ranges[0], partial).map(InitialState::Table)
        }
        _ if every => {
            Grid::build(programs, x, state, ranges, group.in_cells).map(InitialState::Grid)
        }
        _ => Grid::build_all(programs, x, state, ranges, group.in_cells).map(InitialState::Grid),
    }
}

/// Prepares a group from a solution at its inputs `x` over these ranges, as far as it goes.
///
/// # Errors
///
/// If that is no solution.
pub fn prepared(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
    state: &[f64],
    ranges: &[Range],
) -> Result<InitialState, AssemblyError> {
    start(group, programs, x, state, ranges, true)
}

/// Prepares all groups from known states, as `assemble()` does from those that estimates choose;
/// `at` are all inputs of the mechanism, `initial_states` has a place for each group.
///
/// # Errors
///
/// Where a state cannot be followed over the range.
pub(in crate::support) fn prepared_over<S: AsMut<[InitialState]>, P: CoupledPrograms>(
    groups: &[CoupledGroup],
    mut initial_states: S,
    at: &[f64],
    states: &[Vec<f64>],
    programs: impl Fn(usize, &S) -> Result<P, AssemblyError>,
) -> Result<S, AssemblyError> {
    for (number, group) in groups.iter().enumerate() {
        let x = group.inputs_among(at);
        let mut programs = programs(number, &initial_states)?;
        let ranges = group.ranges();
        let found = start(group, &mut programs, &x, &states[number], &ranges, false)?;
        initial_states.as_mut()[number] = found;
    }
    Ok(initial_states)
}
