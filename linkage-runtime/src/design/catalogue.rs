//! Parameters that take some values only: branch and bound from a local optimum.
//!
//! The bound of a branch is the sum of a local optimum of it, so a better one in a branch that is left may be missed where there
//! are several: the result is the best of what is near the optimum, not a proof.

use alloc::vec::Vec;

use super::least_squares::{State, minimise};
use super::limits::Limits;
use super::problem::{Evaluator, Problem};
use super::search::Optimum;
use crate::Dimensions;

/// The best optimum near this one with all catalogue parameters at values of their lists; `None` if none assembles.
pub(crate) fn rounded<M: Dimensions<N> + Copy, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    evaluator: &mut Evaluator<'_, M, A, N>,
    assembly: &A,
    optimum: Optimum,
    most: usize,
) -> Option<Optimum> {
    let mut best = None;
    let root = Node {
        limits: problem.limits.clone(),
        open: (0..problem.catalogues.len()).collect(),
    };
    let mut rounding = Rounding {
        problem,
        evaluator,
        assembly,
        most,
    };
    rounding.branch(root, optimum, &mut best);
    best
}

/// A part of the search: limits, and the catalogues whose parameters are not yet set.
struct Node {
    limits: Limits,
    open: Vec<usize>,
}

struct Rounding<'r, 'a, 'e, M, A, const N: usize> {
    problem: &'r Problem<'a, M, A, N>,
    evaluator: &'r mut Evaluator<'e, M, A, N>,
    assembly: &'r A,
    most: usize,
}

impl<M: Dimensions<N> + Copy, A, const N: usize> Rounding<'_, '_, '_, M, A, N> {
    fn branch(&mut self, node: Node, optimum: Optimum, best: &mut Option<Optimum>) {
        if best.as_ref().is_some_and(|best| best.sum <= optimum.sum) {
            return;
        }
        let Some((&number, open)) = node.open.split_first() else {
            *best = Some(optimum);
            return;
        };
        let (place, values) = &self.problem.catalogues[number];
        let x = optimum.x[*place];
        let above = values
            .partition_point(|value| *value < x)
            .min(values.len() - 1);
        let mut sides = Vec::from([above, above.saturating_sub(1)]);
        sides.dedup();
        // The nearer value first: its optimum is likely to cut the other one off.
        sides.sort_by(|a, b| (values[*a] - x).abs().total_cmp(&(values[*b] - x).abs()));
        for side in sides {
            let mut limits = node.limits.clone();
            (limits.lower[*place], limits.upper[*place]) = (values[side], values[side]);
            if let Some(next) = self.descend(&limits, &optimum) {
                self.branch(
                    Node {
                        limits,
                        open: open.to_vec(),
                    },
                    next,
                    best,
                );
            }
        }
    }

    /// The optimum within narrower limits, from that within wider ones.
    fn descend(&mut self, limits: &Limits, optimum: &Optimum) -> Option<Optimum> {
        let start = limits.nearest(&optimum.x)?;
        let (problem, evaluator, assembly) = (self.problem, &mut *self.evaluator, self.assembly);
        let (descent, state) = minimise(start, limits, self.most, |x, normal| {
            evaluator.evaluate(assembly, core::iter::once(x));
            evaluator.normal(0, normal);
        });
        let valid = descent.here.sum.is_finite() && problem.meets(&descent.here);
        valid.then(|| Optimum {
            zero: optimum.zero && descent.is_zero(),
            x: descent.x,
            sum: descent.here.sum,
            converged: state == State::Converged,
            ..optimum.clone()
        })
    }
}
