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

use alloc::vec::Vec;

use super::limits::Limits;
use curvature::Curvature;
use step::{Aim, step};

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

    fn merit(&self, price: f64) -> f64 {
        self.value()
            + self
                .excesses()
                .map(|excess| cost(price, excess))
                .sum::<f64>()
    }
}

fn largest(rows: &[Row]) -> f64 {
    rows.iter()
        .map(|row| row.value)
        .fold(f64::NEG_INFINITY, f64::max)
}

/// What a violation costs. The square keeps the quadratic programs strictly convex; the slope at zero makes it exact.
fn cost(price: f64, excess: f64) -> f64 {
    price * (excess + 0.5 * excess * excess)
}

/// How a search begins and ends.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Search {
    /// How far each variable may go in the first step. They are measured by it.
    pub(crate) reach: Vec<f64>,
    /// A step that promises less than this ends the search.
    pub(crate) precision: f64,
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
    /// Whether no step promised more.
    pub(crate) converged: bool,
}

/// A step that gains less than this part of its promise is taken back; the smallest part that keeps searches from stalling.
const TAKEN: f64 = 1e-4;
/// Gains below the first part of the promise make the box smaller, above the second one larger (Fletcher's).
const POOR: f64 = 0.25;
const GOOD: f64 = 0.75;
/// A box of this part of the first one is nothing but rounding.
const STUCK: f64 = 1e-12;
/// A variable is at a bound if it is nearer than this part of its first step: the programs are solved to some hundred roundoffs.
const BESIDE: f64 = 1e-11;
/// What rounding leaves of a merit: some hundred roundoffs.
const ROUNDING: f64 = 1e-14;
/// A price above this leaves nothing of the objective in double precision.
const HIGHEST: f64 = 1e9;

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
    let mut x = start.to_vec();
    let mut here = evaluate(&x)?;
    let mut curvature = Curvature::new(&search.reach);
    let (mut radius, mut price, mut rounds, mut evaluations) = (1.0, 1.0, 0, 1);
    let mut converged = false;
    while rounds < search.rounds && radius > STUCK && !stopped() {
        rounds += 1;
        let aim = Aim {
            limits,
            reach: &search.reach,
            radius,
            price,
        };
        let Some(plan) = step(&x, &here, Some(&curvature), &aim) else {
            // Rounding: a shorter step is better conditioned.
            radius *= POOR;
            continue;
        };
        let now = here.merit(price);
        let promise = now - plan.merit;
        if plan.excess > search.tolerance && plan.excess > 0.5 * here.excess() && price < HIGHEST {
            price *= 10.0;
            continue;
        }
        if promise <= search.precision.max(ROUNDING * now.abs()) {
            if here.excess() > search.tolerance && price < HIGHEST {
                // Little is promised for what little is violated.
                price *= 10.0;
                continue;
            }
            converged = true;
            break;
        }
        let mut trial = moved(&x, &plan.d, limits, &search.reach);
        let mut there = evaluate(&trial);
        evaluations += 1;
        let gain = |there: &Option<Groups>| {
            there
                .as_ref()
                .map_or(f64::NEG_INFINITY, |g| (now - g.merit(price)) / promise)
        };
        let mut part = gain(&there);
        if let Some(out) = there
            .as_ref()
            .filter(|out| part < GOOD && out.excess() > search.tolerance)
        {
            // The shortest way back.
            let back = step(
                &trial,
                out,
                None,
                &Aim {
                    price: HIGHEST,
                    ..aim
                },
            );
            let place = back.map(|back| moved(&trial, &back.d, limits, &search.reach));
            let again = place.as_deref().and_then(&mut evaluate);
            evaluations += 1;
            if gain(&again) > part {
                part = gain(&again);
                trial = place.unwrap_or(trial);
                there = again;
            }
        }
        if let Some(there) = &there {
            curvature.update([&x, &trial], [&here, there], &plan.multipliers);
        }
        if part < POOR {
            radius = POOR * plan.length;
        } else if part > GOOD && plan.length > 0.9 * radius {
            radius *= 2.0;
        }
        if let Some(there) = there.filter(|_| part > TAKEN) {
            here = there;
            x = trial;
        }
    }
    Some(Found {
        x,
        groups: here,
        rounds,
        evaluations,
        converged,
    })
}

/// The place after a step. What a step leaves of the way to a bound by rounding is none.
fn moved(x: &[f64], d: &[f64], limits: &Limits, reach: &[f64]) -> Vec<f64> {
    let mut moved: Vec<f64> = x.iter().zip(d).map(|(x, d)| x + d).collect();
    for (j, x) in moved.iter_mut().enumerate() {
        let bounds = [limits.lower[j], limits.upper[j]];
        let near = |bound: &f64| (*x - bound).abs() <= BESIDE * reach[j];
        *x = bounds.into_iter().find(near).unwrap_or(*x);
    }
    limits.clamp(&mut moved);
    moved
}
