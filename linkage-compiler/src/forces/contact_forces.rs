//! The sizes of contact forces that depend on the friction that they cause.
//!
//! All forces are linear in the sizes, `R = R_0 + sum R_i s_i`, and each size is the length of such a
//! force, or the sum of two: `s = |R|`. For known directions `u = R / |R|` the sizes solve the linear
//! system `(I - u . R_i) s = u . R_0`. Each step solves it for the directions of the step before.
//! That is Newton's method, since the length of a vector changes along the vector alone: the number
//! of digits doubles with each step, where `s <- |R|` gains the same few digits in each. The first
//! directions are those without friction, so that the solution is the one to which friction leads as
//! it grows from zero.
//!
//! If the forces of friction are less than their causes in sum, for some scale of each size, every
//! pivot of the system is positive in any order. So none is chosen. A pivot that is not positive, or
//! steps that do not end, show joints that jam: the result is NaN.

use linkage_symbolic::program::Unary;
use linkage_symbolic::{Ex, Graph, Vn};

use crate::algebra::derivatives::by_rule::symbol_for_value;
use crate::algebra::{Algebra, DerivativeRule};

/// Steps. Where the friction of a contact force causes up to a tenth of that force, the fourth
/// correction is below 1e-7 in the worst of thousands of random cases; where it causes half, the
/// fifth is below 1e-5, and 1e-11 where the forces without friction are of similar size.
const STEPS: usize = 5;

/// Steps of the expression that derivatives are taken of. They begin at the solution: all derivatives
/// up to the third order are then exact.
const STEPS_OF_DERIVATIVES: usize = 2;

/// Forces below this size, N, have no direction, and cause no friction.
const NO_FORCE: f64 = 1e-30;

/// The contact force of a surface: that without friction, and its share for each size.
#[derive(Clone, Debug)]
pub(super) struct Surface<'m> {
    pub(super) start: Vn<'m>,
    pub(super) shares: Vec<Vn<'m>>,
}

/// Returns the sum of contact forces of each joint, given its surfaces. Derivatives follow it.
pub(super) fn sizes<'m>(algebra: &mut Algebra<'m>, joints: &[Vec<Surface<'m>>]) -> Vec<Ex<'m>> {
    let sizes = certified(algebra.graph, joints);
    differentiable(algebra, joints, &sizes)
}

/// Computes the sums of contact forces, NaN where joints jam.
fn certified<'m>(graph: &'m Graph, joints: &[Vec<Surface<'m>>]) -> Vec<Ex<'m>> {
    let mut sizes = vec![graph.number(0.0); joints.len()];
    let mut room = graph.number(1.0);
    for _ in 0..STEPS {
        let Solution { values, pivots } = step_from(graph, joints, &sizes);
        room = room_of_correction(graph, &values, &sizes);
        room = pivots.into_iter().fold(room, Ex::min);
        sizes = values;
    }
    let sizes = sizes.into_iter();
    sizes
        .map(|size| room.select(size, size.number(f64::NAN)))
        .collect()
}

/// Returns symbols for the sizes, whose derivatives are those of steps from the sizes: symbols
/// without a rule are constants in derivatives.
fn differentiable<'m>(
    algebra: &mut Algebra<'m>,
    joints: &[Vec<Surface<'m>>],
    sizes: &[Ex<'m>],
) -> Vec<Ex<'m>> {
    let held = |(number, size): (usize, &Ex<'m>)| {
        let (symbol, node) = algebra
            .graph
            .unknown(format!("held contact force {number}"));
        algebra.graph.define(symbol, size.id());
        algebra.graph.ex(node)
    };
    let held: Vec<Ex> = sizes.iter().enumerate().map(held).collect();
    let followed = (0..STEPS_OF_DERIVATIVES).fold(held, |sizes, _| {
        step_from(algebra.graph, joints, &sizes).values
    });
    let pairs = sizes.iter().zip(followed).enumerate();
    pairs
        .map(|(number, (&size, followed))| {
            symbol_for_value(
                algebra.graph,
                &mut algebra.solutions,
                format!("contact force {number}"),
                size,
                DerivativeRule::Follow(followed),
            )
        })
        .collect()
}

/// The solution of a linear system, and the pivots of its elimination.
struct Solution<'m> {
    values: Vec<Ex<'m>>,
    pivots: Vec<Ex<'m>>,
}

/// Solves the system for the directions that the forces have for given sizes.
fn step_from<'m>(graph: &'m Graph, joints: &[Vec<Surface<'m>>], sizes: &[Ex<'m>]) -> Solution<'m> {
    let (zero, one) = (graph.number(0.0), graph.number(1.0));
    let mut matrix = Vec::new();
    let mut right = Vec::new();
    for (joint, surfaces) in joints.iter().enumerate() {
        let unit = |column| if column == joint { one } else { zero };
        let mut row: Vec<Ex> = (0..joints.len()).map(unit).collect();
        let mut known = zero;
        for surface in surfaces {
            let direction = direction(surface, sizes);
            known += direction.dot(surface.start);
            for (entry, &share) in row.iter_mut().zip(&surface.shares) {
                *entry -= direction.dot(share);
            }
        }
        matrix.push(row);
        right.push(known);
    }
    eliminate(matrix, right)
}

/// The direction of a contact force, given the sizes of all.
fn direction<'m>(surface: &Surface<'m>, sizes: &[Ex<'m>]) -> Vn<'m> {
    let shares = surface.shares.iter().zip(sizes);
    let shares = shares.filter(|(_, size)| !size.is_zero());
    let force = shares.fold(surface.start, |sum, (&share, &size)| sum + size * share);
    match force.len() {
        1 => force.map(|x| x.unary(Unary::Sign)),
        _ => 1.0 / (length(force) + NO_FORCE) * force,
    }
}

fn length(force: Vn) -> Ex {
    match force.len() {
        1 => force.at(0).abs(),
        _ => force.length(),
    }
}

/// Gaussian elimination without a choice of pivots.
fn eliminate<'m>(mut matrix: Vec<Vec<Ex<'m>>>, mut right: Vec<Ex<'m>>) -> Solution<'m> {
    let size = right.len();
    let mut reciprocals = Vec::new();
    for k in 0..size {
        let pivot = matrix[k][k];
        let reciprocal = pivot.number(1.0).quotient(pivot);
        for i in k + 1..size {
            let (above, below) = matrix.split_at_mut(i);
            let (pivot_row, row) = (&above[k], &mut below[0]);
            if row[k].is_zero() {
                continue;
            }
            let factor = row[k] * reciprocal;
            for (entry, &above) in row.iter_mut().zip(pivot_row).skip(k + 1) {
                *entry -= factor * above;
            }
            let known = right[k];
            right[i] -= factor * known;
        }
        reciprocals.push(reciprocal);
    }
    for k in (0..size).rev() {
        for j in k + 1..size {
            let value = right[j];
            right[k] -= matrix[k][j] * value;
        }
        right[k] = right[k] * reciprocals[k];
    }
    Solution {
        values: right,
        pivots: (0..size).map(|k| matrix[k][k]).collect(),
    }
}

/// Returns a number that is not negative if the last correction is small enough: the error after it
/// is about its square, as a share of all sizes, and that is rounding of the numbers that a program
/// runs on.
fn room_of_correction<'m>(graph: &'m Graph, values: &[Ex<'m>], before: &[Ex<'m>]) -> Ex<'m> {
    let zero = graph.number(0.0);
    let size = values.iter().fold(zero, |sum, &value| sum + value.abs());
    let corrections = values.iter().zip(before);
    let correction = corrections.fold(zero, |sum, (&value, &before)| sum + (value - before).abs());
    let rounding = size.number(1.0).unary(Unary::Slack);
    rounding.sqrt() * size - correction
}

#[cfg(test)]
mod tests;
