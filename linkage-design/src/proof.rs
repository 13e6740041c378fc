//! The assembly of a least sum of squares: the one with the same rows.

use std::vec::Vec;

use super::certificate::{Interruption, alike, certify};
use super::optimum::Optimum;
use super::problem::{Evaluator, Problem};
use linkage_runtime::{AssemblyError, Branch, Circuits, DimensionSet};

/// The assembly of an optimum over the whole range, or why there is none.
pub(crate) fn certify_optimum<M: DimensionSet<N> + Copy, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    evaluator: &mut Evaluator<'_, M, A, N>,
    assembly: &A,
    optimum: &Optimum,
    circuits: &dyn Fn(&M) -> Result<Circuits<A>, AssemblyError>,
) -> Result<Branch<A>, Interruption> {
    let optimum_x = || core::iter::once(&optimum.x[..]);
    evaluator.evaluate(assembly, optimum_x());
    let expected = values(problem, evaluator);
    let sizes = sizes(problem, evaluator);
    certify(circuits(&problem.mechanism(&optimum.x)), |branch| {
        evaluator.evaluate(&branch.assembly, optimum_x());
        alike(
            &expected,
            &values(problem, evaluator),
            sizes.iter().copied(),
        )
    })
}

/// The rows of all objectives.
fn values<M: DimensionSet<N> + Copy, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    evaluator: &Evaluator<'_, M, A, N>,
) -> Vec<f64> {
    let rows = (0..problem.objectives.len()).map(|objective| evaluator.rows(objective));
    rows.flat_map(|rows| (0..rows.count()).map(|row| rows.row(0, row).0))
        .collect()
}

/// Returns the effect of the bounds' widths on each row.
fn sizes<M: DimensionSet<N> + Copy, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    evaluator: &Evaluator<'_, M, A, N>,
) -> Vec<f64> {
    let width = |j: usize| problem.limits.upper[j] - problem.limits.lower[j];
    let rows = (0..problem.objectives.len()).map(|objective| evaluator.rows(objective));
    rows.flat_map(|rows| {
        (0..rows.count()).map(|row| {
            let (_, slopes, _) = rows.row(0, row);
            let varied = problem.varied.iter().enumerate();
            varied
                .map(|(j, &index)| (slopes[index] * width(j)).abs())
                .sum()
        })
    })
    .collect()
}
