//! How far inputs go: the robot is moved from its drawn position until a loop opens.

use super::analysis::Analysis;
use super::chain::{Chain, Pose};
use super::equations::Equation;
use crate::placement::{Vector, difference, length};

/// Newton steps for a position, and the error that is none.
const MOST_STEPS: usize = 30;
const CLOSED: f64 = 1e-12;

/// Positions to each side of the drawn one at which a range is tried.
const TRIES: usize = 90;

/// The corners of a box of more inputs are not tried.
const MOST_CORNERS: usize = 6;

/// Steps from the drawn position to a corner.
const CORNER_STEPS: usize = 20;

/// The factor of a shortening, and the most of them.
const SHORTER: f64 = 0.75;
const SHORTENINGS: usize = 12;

/// A pivot of the equations below this part of that of the drawn position is a dead point.
const FLAT: f64 = 0.02;

/// The range of an input about the drawn position in which all loops close, within limits, and
/// whether the limits were cut.
pub(super) fn reach(
    chain: &Chain,
    analysis: &Analysis,
    input: usize,
    [low, high]: [f64; 2],
) -> ([f64; 2], bool) {
    let start = chain.drawn();
    let margin = pivot(chain, analysis, &chain.rows(&start));
    let side = |end: f64| {
        let mut pose = start.clone();
        for number in 1..=TRIES {
            let step = end / TRIES as f64;
            let is_closed = advance(chain, analysis, &mut pose, input, step);
            let found = pivot(chain, analysis, &chain.rows(&pose));
            if !is_closed || found < FLAT * margin {
                return (step * (number - 1) as f64, true);
            }
        }
        (end, false)
    };
    let (below, is_cut_below) = side(low);
    let (above, is_cut_above) = side(high);
    ([below, above], is_cut_below || is_cut_above)
}

/// The factor by which the ranges of several inputs must be shortened so that the loops close at all
/// corners of their box.
pub(super) fn common_share(
    chain: &Chain,
    analysis: &Analysis,
    ranges: &[(usize, [f64; 2])],
) -> f64 {
    let count = ranges.len();
    if !(2..=MOST_CORNERS).contains(&count) {
        return 1.0;
    }
    let drawn = chain.drawn();
    let margin = pivot(chain, analysis, &chain.rows(&drawn));
    let mut share = 1.0;
    for _ in 0..SHORTENINGS {
        let is_closed = (0..1_usize << count).all(|corner| {
            let mut pose = drawn.clone();
            (0..CORNER_STEPS).all(|_| {
                let mut changes = vec![0.0; chain.coordinates.len()];
                for (k, (input, ends)) in ranges.iter().enumerate() {
                    changes[*input] = share * ends[corner >> k & 1] / CORNER_STEPS as f64;
                }
                settle(chain, analysis, &mut pose, &changes)
                    && pivot(chain, analysis, &chain.rows(&pose)) >= FLAT * margin
            })
        });
        if is_closed {
            return share;
        }
        share *= SHORTER;
    }
    share
}

/// True if a point of the robot, with its body, moves with an input.
pub(super) fn moves(
    chain: &Chain,
    analysis: &Analysis,
    input: usize,
    points: &[(usize, Vector)],
) -> bool {
    let drawn = chain.drawn();
    let mut pose = drawn.clone();
    let step = 1e-3
        * if chain.size > 1e-9 {
            chain.size.min(1.0)
        } else {
            1.0
        };
    if !advance(chain, analysis, &mut pose, input, step) {
        return true;
    }
    let shift = |(body, at): &(usize, Vector)| {
        let [before, after] = [&drawn, &pose].map(|pose| pose.bodies[*body].point(*at));
        length(difference(before, after))
    };
    let shifts = points.iter().map(shift);
    shifts.fold(0.0, f64::max) > 1e-6 * step * chain.size
}

/// Moves an input by a step and closes the loops. False if they do not close.
fn advance(chain: &Chain, analysis: &Analysis, pose: &mut Pose, input: usize, step: f64) -> bool {
    let mut changes = vec![0.0; chain.coordinates.len()];
    changes[input] = step;
    settle(chain, analysis, pose, &changes)
}

/// Moves the inputs and closes the loops. False if they do not close.
fn settle(chain: &Chain, analysis: &Analysis, pose: &mut Pose, changes: &[f64]) -> bool {
    chain.step(pose, changes);
    for _ in 0..MOST_STEPS {
        let rows = chain.rows(pose);
        let error = rows
            .iter()
            .fold(0.0, |most: f64, row| most.max(row.error.abs()));
        if error < CLOSED {
            return true;
        }
        let Some((correction, _)) = solved(chain, analysis, &rows) else {
            return false;
        };
        let largest = correction
            .iter()
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        if largest >= 1.0 || largest.is_nan() {
            return false;
        }
        chain.step(pose, &correction);
    }
    // Files have some eight decimals: redundant loops may keep a gap.
    let rows = chain.rows(pose);
    rows.iter().all(|row| row.error.abs() < 1e-6)
}

/// The smallest pivot of the needed equations.
fn pivot(chain: &Chain, analysis: &Analysis, rows: &[Equation]) -> f64 {
    solved(chain, analysis, rows).map_or(0.0, |(_, pivot)| pivot)
}

/// The step of all coordinates but the inputs that closes the needed equations, and the smallest
/// pivot.
fn solved(chain: &Chain, analysis: &Analysis, rows: &[Equation]) -> Option<(Vec<f64>, f64)> {
    if !analysis.effort.step(rows.len()) {
        return None;
    }
    let free: Vec<usize> = (0..chain.coordinates.len())
        .filter(|index| {
            let coordinate = &chain.coordinates[*index];
            !analysis.inputs.contains(index) && chain.is_independent(coordinate)
        })
        .collect();
    let needed = rows
        .iter()
        .zip(&analysis.is_needed)
        .filter(|(_, is_needed)| **is_needed);
    let mut matrix: Vec<Vec<f64>> = needed
        .map(|(row, _)| {
            let numbers = free.iter().map(|index| row.changes[*index]);
            numbers.chain([-row.error]).collect()
        })
        .collect();
    let size = free.len();
    if matrix.len() != size {
        return None;
    }
    let mut least = f64::INFINITY;
    for column in 0..size {
        let pivot = (column..size).max_by(|i, j| {
            let [a, b] = [*i, *j].map(|row: usize| matrix[row][column].abs());
            a.total_cmp(&b)
        })?;
        matrix.swap(column, pivot);
        let pivot = matrix[column].clone();
        least = least.min(pivot[column].abs());
        if pivot[column].abs() <= 1e-9 || pivot[column].is_nan() {
            return None;
        }
        for row in &mut matrix[column + 1..] {
            let factor = row[column] / pivot[column];
            for (number, pivot) in row.iter_mut().zip(&pivot) {
                *number -= factor * pivot;
            }
        }
    }
    let mut changes = vec![0.0; chain.coordinates.len()];
    let mut found = vec![0.0; size];
    for index in (0..size).rev() {
        let row = &matrix[index];
        let known: f64 = (index + 1..size)
            .map(|other| row[other] * found[other])
            .sum();
        found[index] = (row[size] - known) / row[index];
        changes[free[index]] = found[index];
    }
    Some((changes, least))
}
