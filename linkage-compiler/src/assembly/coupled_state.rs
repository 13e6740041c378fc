//! A coupled group in a known state: its unknowns, and its preparation over the ranges of inputs.

use linkage_core::numeric::continuation::{End, Grid, Range, Refusal, Table, Terms, reached};
use linkage_core::range_check::rounded_inwards;

use crate::algebra::{Algebra, Nominal};
use crate::ir::{Coupled, PreparedTable};
use crate::machine::followed_range;
use crate::solve::{Prepared, Solved};

use super::assembler::Assembly;
use super::estimates::Position;
use super::refused_range::{FoundBox, RangeSurvey, shrunk};
use super::{continuation, estimates, unfollowed};

/// A part of a range ends so far before a turning point, as a share of the range: a table reaches
/// to a tenth of that.
const BEFORE_END: f64 = 1e-4;

/// An assembly of a coupled group.
pub(super) struct Candidate {
    pub(super) state: Vec<f64>,
    pub(super) position: Position,
}

/// The least determinants in ranges that are narrower than declared, as shares of that at the
/// reference: where a grid does not serve the first ranges, it may do so farther from dead points.
const LEAST: [f64; 3] = [0.1, 0.25, 0.5];

/// The number of times that ranges are halved: to a sixteenth, where a grid of several inputs has
/// cells of less than a degree of a full turn.
const HALVINGS: i32 = 4;

/// The number of times that the range of a table is halved, whose shortest cells are much shorter.
const HALVINGS_OF_TABLE: i32 = 8;

/// Prepares a group whose state is known; false if that was not possible. Over ranges that are
/// refused it is prepared as far as it goes, and the refusal is kept.
pub(super) fn prepare<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> bool {
    if prepared.has_table() {
        return prepare_table(assembly, solved, prepared, state);
    }
    let dead_point = continuation::dead_point(assembly, prepared, state);
    let mut refused = dead_point.map(|at| continuation::apart(assembly, solved, prepared, &at));
    let declared = (assembly.nominal.clone(), assembly.refused.clone());
    let mut narrower = None;
    loop {
        if let Some(refused) = &refused {
            // Whether polynomials serve narrower ranges does not matter for those that are refused.
            if prepared.in_cells == Terms::Polynomials {
                assembly.needs_slopes = true;
                return false;
            }
            let boxes = narrower
                .get_or_insert_with(|| narrower_boxes(assembly, prepared, state).into_iter());
            let Some((narrower, found)) = boxes.next() else {
                let refused = refused.clone();
                (*assembly.nominal, assembly.refused) = declared;
                refused.report(assembly.algebra.mechanism, None, &mut assembly.reporter);
                return false;
            };
            assembly.work_within(narrower, refused.clone(), found);
        }
        let start = start(assembly, prepared, state);
        if prepared.in_cells == Terms::Polynomials && !fits(assembly, prepared, &start) {
            assembly.needs_slopes = true;
            return false;
        }
        let unserved = match start {
            Ok(grid) => match continuation::unserved(assembly, solved, prepared, &grid) {
                None => {
                    assembly.machine.starts[prepared.number] = Some(PreparedTable::Grid(grid));
                    return true;
                }
                unserved => unserved,
            },
            Err(refusal) => Some(unfollowed::refused(assembly, solved, prepared, refusal)),
        };
        refused = refused.or(unserved);
    }
}

/// The same for a group that depends on one input.
fn prepare_table<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> bool {
    let input = prepared.inputs[0];
    let partial = assembly.nominal.ranges[input].is_none();
    let refusal = match table(assembly, prepared, state, partial) {
        Ok(table) => {
            assembly.machine.starts[prepared.number] = Some(PreparedTable::Table(table));
            return true;
        }
        Err(refusal) => refusal,
    };
    let refused = unfollowed::refused(assembly, solved, prepared, refusal);
    let Some((part, narrower, found)) = part_around_reference(assembly, prepared, state) else {
        let mechanism = assembly.algebra.mechanism;
        refused.report(mechanism, None, &mut assembly.reporter);
        return false;
    };
    assembly.work_within(narrower, refused, found);
    assembly.machine.starts[prepared.number] = Some(PreparedTable::Table(part));
    true
}

/// Returns the table over the part of the range that is reached from the reference, and the
/// mechanism with this part as its range. Near a turning point the shortest cells of a wide range
/// are too long: then the range is halved towards the reference.
fn part_around_reference<'m>(
    assembly: &mut Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> Option<(Table, Nominal, FoundBox)> {
    let input = prepared.inputs[0];
    assembly.nominal.ranges[input]?;
    let declared = assembly.nominal.clone();
    let found = (0..=HALVINGS_OF_TABLE).find_map(|count| {
        let found = match count {
            0 => FoundBox::Largest,
            _ => {
                let share = 0.5f64.powi(count);
                let mechanism = assembly.algebra.mechanism;
                *assembly.nominal = shrunk(mechanism, &declared, &prepared.inputs, share);
                FoundBox::Halved
            }
        };
        let part = table(assembly, prepared, state, true).ok()?;
        let narrower = reached_range(assembly, input, &part)?;
        Some((part, narrower, found))
    });
    *assembly.nominal = declared;
    found
}

/// Returns the mechanism with the range that a table reaches, rounded inwards as far as the
/// reference at most.
fn reached_range(assembly: &Assembly<'_, '_>, input: usize, part: &Table) -> Option<Nominal> {
    let (low, high) = assembly.nominal.ranges[input]?;
    let inside = BEFORE_END * (high - low);
    let reach = [(0, low, inside), (1, high, -inside)].map(|(side, declared, inside)| {
        match part.ends()[side] {
            End::Closed | End::Range(_) => declared,
            End::TurningPoint(at) | End::Lost(at) => at + inside,
        }
    });
    let at = assembly.nominal.inputs[input];
    let is_angle = is_angle(assembly.algebra, input);
    let ([from, to], _) = rounded_inwards(reach, at, [low, high], is_angle);
    let mut narrower = assembly.nominal.clone();
    narrower.ranges[input] = Some((from.min(at), to.max(at)));
    Some(narrower)
}

/// Returns the mechanism with narrower ranges, the widest first: the boxes far enough from dead
/// points, then ranges that are halved towards the reference. These serve where no dead point is
/// near, and the states change too fast for the cells of a grid.
fn narrower_boxes<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> Vec<(Nominal, FoundBox)> {
    let boxes = narrowed(assembly, prepared, state).into_iter();
    let boxes = boxes.map(|narrower| (narrower, FoundBox::Largest));
    let halved = (1..=HALVINGS).map(|count| {
        let share = 0.5f64.powi(count);
        let mechanism = assembly.algebra.mechanism;
        let narrower = shrunk(mechanism, assembly.nominal, &prepared.inputs, share);
        (narrower, FoundBox::Halved)
    });
    boxes.chain(halved).collect()
}

/// Returns the mechanism with the ranges of the largest boxes in which the determinant of a group
/// is not less than some shares of that at the reference.
fn narrowed<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> Vec<Nominal> {
    let Some(survey) = RangeSurvey::new(assembly.nominal, &prepared.inputs) else {
        return Vec::new();
    };
    let (mut numbers, _) = assembly.coupled(prepared.number);
    let shares = reached(&mut numbers, &survey.lines, &survey.start, state);
    let mechanism = assembly.algebra.mechanism;
    let boxes = LEAST.iter().filter_map(|&least| {
        let works: Vec<bool> = shares.iter().map(|&share| share >= least).collect();
        survey.narrowed(mechanism, assembly.nominal, &works)
    });
    let mut boxes: Vec<Nominal> = boxes.collect();
    boxes.retain(|narrower| narrower.ranges != assembly.nominal.ranges);
    boxes.dedup_by(|a, b| a.ranges == b.ranges);
    boxes
}

/// Checks that polynomials fit over the ranges.
fn fits<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    start: &Result<Grid, Refusal>,
) -> bool {
    let Ok(grid) = start else {
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

/// Prepares the group over the ranges of several inputs, or of none.
fn start<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> Result<Grid, Refusal> {
    let (mut numbers, at) = assembly.coupled(prepared.number);
    let ranges = prepared.inputs.iter().map(|&input| {
        let (low, high) = followed_range(assembly.algebra, assembly.nominal, input);
        let turn = is_angle(assembly.algebra, input);
        Range { low, high, turn }
    });
    let ranges: Vec<Range> = ranges.collect();
    Grid::build_all(&mut numbers, &at, state, &ranges, prepared.in_cells)
}

/// Prepares the group over the range of its only input, or a part of it.
fn table<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    state: &[f64],
    partial: bool,
) -> Result<Table, Refusal> {
    let (mut numbers, at) = assembly.coupled(prepared.number);
    let input = prepared.inputs[0];
    let (low, high) = followed_range(assembly.algebra, assembly.nominal, input);
    let turn = is_angle(assembly.algebra, input);
    let range = Range { low, high, turn };
    Table::build(&mut numbers, at[0], state, range, partial)
}

fn is_angle(algebra: &Algebra, input: usize) -> bool {
    algebra.mechanism.inputs[input].dimension.half_lengths == 0
}
