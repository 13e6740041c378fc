//! The test that evaluators reach the solution from a cell.

use super::super::follow::{Follower, SETTLED};
use super::super::{ALLOWED_CONTRACTION, Correction, STEPS_BESIDE};
use super::terms::Terms;
use alloc::vec::Vec;

/// On the border of a cell each step is smaller than the one before by this factor. Evaluators
/// allow a quarter: the margin is for positions between the tested ones.
const CONTRACTION: f64 = 0.1;

/// The limit of evaluators for the last step, and for no other one.
const TINY: f64 = <f64 as crate::scalar::Scalar>::CORRECTION_LIMIT;

/// Brings a state of a cell to the solution as evaluators do; returns the determinant. `None`
/// unless it gets there with something to spare.
pub(super) fn served(
    follower: &mut Follower<'_>,
    terms: Terms,
    x: &[f64],
    state: &mut [f64],
) -> Option<f64> {
    if terms == Terms::Slopes {
        return follower.settle_within(x, state, STEPS_BESIDE, CONTRACTION);
    }
    let step = follower.correct(x, state)?;
    (step.size <= SETTLED).then_some(step.determinant)
}

/// Returns whether evaluators give the solution, from a state and its floor.
pub(super) fn serves(
    correction: &mut dyn Correction,
    terms: Terms,
    x: &[f64],
    state: &mut [f64],
    floor: f64,
) -> bool {
    if terms == Terms::Polynomials {
        let step = correction.correct(x, state);
        return step.size <= TINY && step.determinant * floor >= floor * floor;
    }
    let steps: Vec<_> = (0..STEPS_BESIDE)
        .map(|_| correction.correct(x, state))
        .collect();
    let sound = steps.iter().all(|step| step.determinant * floor >= 0.0);
    let mut pairs = steps.windows(2);
    let smaller =
        pairs.all(|pair| pair[1].size <= f64::max(ALLOWED_CONTRACTION * pair[0].size, TINY));
    sound && smaller && steps.last().is_some_and(|last| last.size <= TINY)
}
