//! Rows, groups of rows, and the limits of a search.

use std::vec::Vec;

/// The identity of a row, with which it is found at another place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Key {
    /// The one with this number.
    Nth(usize),
    /// The one at this input.
    At(f64),
}

/// One of the smooth functions of which the largest counts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FunctionRow {
    pub(crate) key: Key,
    pub(crate) value: f64,
    /// Its derivatives by all variables.
    pub(crate) slopes: Vec<f64>,
}

/// The objective and the conditions at a place.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Groups {
    /// Their largest is to be least.
    pub(crate) objective: Vec<FunctionRow>,
    /// None of them may be above zero; 1 is a violation that matters.
    pub(crate) conditions: Vec<Vec<FunctionRow>>,
    /// Rows of whose squares the objective is the sum, if it is one: most of its curvature is known
    /// from them.
    pub(crate) squares: Vec<FunctionRow>,
}

impl Groups {
    pub(crate) fn value(&self) -> f64 {
        largest(&self.objective)
    }

    /// Returns the violation of each condition.
    pub(crate) fn excesses(&self) -> impl Iterator<Item = f64> {
        self.conditions.iter().map(|rows| largest(rows).max(0.0))
    }

    /// Returns the violation of the worst condition.
    pub(crate) fn excess(&self) -> f64 {
        self.excesses().fold(0.0, f64::max)
    }

    /// Returns the cost of all violations at a price of 1.
    pub(super) fn missed(&self) -> f64 {
        self.excesses().map(cost).sum()
    }

    pub(super) fn merit(&self, price: f64) -> f64 {
        self.value() + price * self.missed()
    }
}

/// The largest value of some rows.
pub(crate) fn largest(rows: &[FunctionRow]) -> f64 {
    rows.iter()
        .map(|row| row.value)
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Returns the cost of a violation at a price of 1. The square keeps the quadratic programs
/// strictly convex; the slope at zero makes it exact.
pub(super) fn cost(excess: f64) -> f64 {
    excess + 0.5 * excess * excess
}

/// The settings of a search.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SearchSettings {
    /// The length of the first step in each variable. Variables are measured by it.
    pub(crate) reach: Vec<f64>,
    /// The search ends where steps promise less than this, if the first-order conditions hold.
    pub(crate) precision: f64,
    /// They hold where no step as long as the first one makes the objective and the cost of
    /// violations smaller by more than this, to first order.
    pub(crate) slope: f64,
    /// A violation that is none.
    pub(crate) tolerance: f64,
    /// The most steps.
    pub(crate) rounds: usize,
}
