//! No mechanism is returned that does not assemble over its whole range on one circuit.
//!
//! Its assemblies are found over the range, each with its ends: those of groups with a closed form by bounds of their
//! discriminants, so that none is missed; those of coupled groups as far as listings at some inputs and steps along their curves
//! see. One of them must run through the whole range, a turn must close, and at all inputs that the wishes ask for it must give the rows of the
//! optimum: so it is the assembly that was optimised, all its positions are on one circuit, and they are reached without a dead
//! point between them.

use alloc::vec::Vec;
use core::fmt;

use super::problem::{Evaluator, Problem};
use super::search::Optimum;
use crate::words::rounded;
use crate::{AssemblyError, Branch, BranchEnd, Circuits, Dimensions};

/// Rows of the same assembly differ by less than this part of what the bounds' widths do to them; those of other ones by far more.
const SAME: f64 = 1e-6;

/// The least margin that is no dead point: that which the compiler asks of a declaration.
const LEAST: f64 = 1e-6;

/// A local optimum that does not run through its whole range.
#[derive(Clone, Debug, PartialEq)]
pub struct Interrupted {
    /// Its sum of squares.
    pub sum: f64,
    /// Why it does not.
    pub why: Interruption,
}

/// Why a mechanism does not run through its whole range.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Interruption {
    /// No single assembly has all positions that are wanted: it would have to be taken apart between two of them.
    Apart,
    /// It assembles between these inputs only.
    Ends(Vec<[f64; 2]>),
    /// It has a dead point at this input.
    DeadPoint(f64),
    /// After a full turn of the input it is in another assembly.
    Other,
}

impl fmt::Display for Interrupted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the best of these, with a sum of squares of {}, ",
            rounded(self.sum)
        )?;
        match &self.why {
            Interruption::Apart => {
                f.write_str("would have to be taken apart between two of its positions")
            }
            Interruption::Ends(intervals) => {
                f.write_str("assembles only between the inputs ")?;
                for (k, [from, to]) in intervals.iter().enumerate() {
                    let and = if k > 0 { ", and between " } else { "" };
                    write!(f, "{and}{} and {}", rounded(*from), rounded(*to))?;
                }
                Ok(())
            }
            Interruption::DeadPoint(input) => {
                write!(f, "has a dead point at input {}", rounded(*input))
            }
            Interruption::Other => {
                f.write_str("is in another assembly after a full turn of the input")
            }
        }
    }
}

/// The assembly of an optimum over the whole range, or why there is none.
pub(crate) fn certify<M: Dimensions<N> + Copy, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    evaluator: &mut Evaluator<'_, M, A, N>,
    assembly: &A,
    optimum: &Optimum,
    circuits: &dyn Fn(&M) -> Result<Circuits<A>, AssemblyError>,
) -> Result<Branch<A>, Interruption> {
    let found = circuits(&problem.mechanism(&optimum.x)).map_err(|_| Interruption::Apart)?;
    let turns = super::turn(&found.cycle).is_some();
    let place = || core::iter::once(&optimum.x[..]);
    evaluator.evaluate(assembly, place());
    let own = values(problem, evaluator);
    let sizes = sizes(problem, evaluator);
    let mut parts = Vec::new();
    for branch in found.branches {
        evaluator.evaluate(&branch.assembly, place());
        let others = values(problem, evaluator);
        let same = |((a, b), size): ((&f64, &f64), &f64)| (a - b).abs() <= SAME * size;
        if !own.iter().zip(&others).zip(&sizes).all(same) {
            continue;
        }
        if !branch.is_whole() {
            // A mode that is real in several intervals has a branch in each.
            parts.push(branch.ends.map(BranchEnd::x));
        } else if turns && !branch.closed {
            return Err(Interruption::Other);
        } else if branch.margin > LEAST {
            return Ok(branch);
        } else {
            return Err(Interruption::DeadPoint(branch.at));
        }
    }
    Err(match parts.is_empty() {
        true => Interruption::Apart,
        false => Interruption::Ends(parts),
    })
}

/// The rows of all wishes.
fn values<M: Dimensions<N> + Copy, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    evaluator: &Evaluator<'_, M, A, N>,
) -> Vec<f64> {
    let wishes = 0..problem.wishes.len();
    let rows = wishes.map(|wish| evaluator.rows(wish));
    rows.flat_map(|rows| (0..rows.count()).map(|row| rows.row(0, row).0))
        .collect()
}

/// What the bounds' widths do to each row.
fn sizes<M: Dimensions<N> + Copy, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    evaluator: &Evaluator<'_, M, A, N>,
) -> Vec<f64> {
    let width = |j: usize| problem.limits.upper[j] - problem.limits.lower[j];
    let wishes = 0..problem.wishes.len();
    let rows = wishes.map(|wish| evaluator.rows(wish));
    rows.flat_map(|rows| {
        (0..rows.count()).map(|row| {
            let (_, slopes, _) = rows.row(0, row);
            problem
                .varied
                .iter()
                .enumerate()
                .map(|(j, &index)| (slopes[index] * width(j)).abs())
                .sum()
        })
    })
    .collect()
}
