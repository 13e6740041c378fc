//! The least of a largest value: sequential quadratic programming with a trust region, for functions that are maxima of smooth ones.
//!
//! The objective and every condition is a *group*: the largest of some rows, each smooth. Which rows there are may change from place to place, as
//! extremes of a cycle come and go, as long as their largest value is continuous. A step is the minimum of the linearised groups and of
//! a curvature gathered on the way, within a box. Where the largest values follow a curve on which several rows are equal, such a step leaves it
//! by the square of its length; so a second, shortest step leads back to the conditions, with the derivatives at the place that
//! was reached.
//!
//! Sources: R. Fletcher, "Practical methods of optimization", 2nd edition 1987, sections 12.4 (the exact penalty function and its trust region) and
//! 14.4 (second steps); K. Madsen, "An algorithm for minimax solution of overdetermined systems of non-linear equations", J. Inst. Maths
//! Applics 16 (1975).

mod curvature;
mod step;
#[cfg(test)]
mod tests;
mod walk;

use alloc::vec::Vec;

use super::limits::Limits;
use walk::{End, Walk};

/// Which row it is, so that it is known again at another place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Key {
    /// The one with this number.
    Nth(usize),
    /// The one at this input.
    At(f64),
}

/// One of the smooth functions of which the largest counts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) key: Key,
    pub(crate) value: f64,
    /// Its derivatives by all variables.
    pub(crate) slopes: Vec<f64>,
}

/// The objective and the conditions at a place.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Groups {
    /// Their largest is to be least.
    pub(crate) objective: Vec<Row>,
    /// None of them may be above zero; 1 is a violation that matters.
    pub(crate) conditions: Vec<Vec<Row>>,
    /// Rows of whose squares the objective is the sum, if it is one: most of its curvature is known from them.
    pub(crate) squares: Vec<Row>,
}

impl Groups {
    pub(crate) fn value(&self) -> f64 {
        largest(&self.objective)
    }

    /// By how much each condition is violated.
    pub(crate) fn excesses(&self) -> impl Iterator<Item = f64> {
        self.conditions.iter().map(|rows| largest(rows).max(0.0))
    }

    /// By how much the worst condition is violated.
    pub(crate) fn excess(&self) -> f64 {
        self.excesses().fold(0.0, f64::max)
    }

    /// What all violations cost at a price of 1.
    fn missed(&self) -> f64 {
        self.excesses().map(cost).sum()
    }

    fn merit(&self, price: f64) -> f64 {
        self.value() + price * self.missed()
    }
}

/// The largest value of some rows.
pub(crate) fn largest(rows: &[Row]) -> f64 {
    rows.iter()
        .map(|row| row.value)
        .fold(f64::NEG_INFINITY, f64::max)
}

/// What a violation costs at a price of 1. The square keeps the quadratic programs strictly convex; the slope at zero makes it exact.
fn cost(excess: f64) -> f64 {
    excess + 0.5 * excess * excess
}

/// How a search begins and ends.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Search {
    /// How far each variable may go in the first step. They are measured by it.
    pub(crate) reach: Vec<f64>,
    /// Where steps promise less than this the search ends, if the first-order conditions hold.
    pub(crate) precision: f64,
    /// They hold where no step as long as the first one makes the objective, and what violations cost, smaller by more than this, to first order.
    pub(crate) slope: f64,
    /// A violation that is none.
    pub(crate) tolerance: f64,
    /// The most steps.
    pub(crate) rounds: usize,
}

/// Where a search ended.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Found {
    pub(crate) x: Vec<f64>,
    pub(crate) groups: Groups,
    /// Steps, those that were taken back among them.
    pub(crate) rounds: usize,
    /// Evaluations of the groups.
    pub(crate) evaluations: usize,
    /// Whether the first-order conditions hold.
    pub(crate) converged: bool,
}

/// Searches for the least objective that keeps all conditions, from a place within the limits. `None` if the groups have no value there.
///
/// `evaluate` gives the groups, or `None` where there are none; `stopped` ends the search between two steps.
pub(crate) fn minimise(
    start: &[f64],
    limits: &Limits,
    search: &Search,
    mut evaluate: impl FnMut(&[f64]) -> Option<Groups>,
    stopped: impl Fn() -> bool,
) -> Option<Found> {
    let here = evaluate(start)?;
    let mut walk = Walk::new((start, here), limits, search, evaluate);
    let (mut rounds, mut end) = (0, None);
    while end.is_none() && rounds < search.rounds && !stopped() {
        rounds += 1;
        end = walk.round();
    }
    Some(Found {
        x: walk.x,
        groups: walk.here,
        rounds,
        evaluations: walk.evaluations,
        converged: end == Some(End::Stationary),
    })
}
