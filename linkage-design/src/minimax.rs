//! The least of a largest value: sequential quadratic programming with a trust region, for
//! functions that are maxima of smooth ones.
//!
//! The objective and every condition is a *group*: the largest of some rows, each smooth. Which
//! rows there are may change from place to place, as extremes of a cycle come and go, as long as
//! their largest value is continuous. A step is the minimum of the linearised groups and of a
//! curvature gathered on the way, within a box. Where the largest values follow a curve on which
//! several rows are equal, such a step leaves it by the square of its length; so a second, shortest
//! step leads back to the conditions, with the derivatives at the place that was reached.
//!
//! Sources: R. Fletcher, "Practical methods of optimization", 2nd edition 1987, sections 12.4 (the
//! exact penalty function and its trust region) and 14.4 (second steps); K. Madsen, "An algorithm
//! for minimax solution of overdetermined systems of non-linear equations", J. Inst. Maths Applics
//! 16 (1975).

mod curvature;
mod rows;
mod step;
#[cfg(test)]
mod tests;
mod walk;

use std::vec::Vec;

pub(crate) use rows::{FunctionRow, Groups, Key, SearchSettings, largest};

use super::limits::Limits;
use walk::{End, Walk};

/// The end of a search.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Minimum {
    pub(crate) x: Vec<f64>,
    pub(crate) groups: Groups,
    /// Steps, those that were taken back among them.
    pub(crate) rounds: usize,
    /// Evaluations of the groups.
    pub(crate) evaluations: usize,
    /// True if the first-order conditions hold.
    pub(crate) converged: bool,
}

/// Searches for the least objective that keeps all conditions, from a place within the limits.
/// `None` if the groups have no value there.
///
/// `evaluate` gives the groups, or `None` where there are none; `stopped` ends the search between
/// two steps.
pub(crate) fn minimise(
    start: &[f64],
    limits: &Limits,
    search: &SearchSettings,
    mut evaluate: impl FnMut(&[f64]) -> Option<Groups>,
    stopped: impl Fn() -> bool,
) -> Option<Minimum> {
    let here = evaluate(start)?;
    let mut walk = Walk::new((start, here), limits, search, evaluate);
    let (mut rounds, mut end) = (0, None);
    while end.is_none() && rounds < search.rounds && !stopped() {
        rounds += 1;
        end = walk.round();
    }
    Some(Minimum {
        x: walk.x,
        groups: walk.here,
        rounds,
        evaluations: walk.evaluations,
        converged: end == Some(End::Stationary),
    })
}
