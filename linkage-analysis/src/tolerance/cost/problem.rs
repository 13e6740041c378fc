//! Costs of values, and conditions on them.

use alloc::vec::Vec;

/// The cost `cost / u^exponent` of a value.
#[derive(Clone, Copy, Debug)]
pub(in crate::tolerance) struct Term {
    pub(in crate::tolerance) cost: f64,
    pub(in crate::tolerance) exponent: f64,
}

impl Term {
    pub(in crate::tolerance) fn evaluate(&self, value: f64) -> f64 {
        self.cost / value.powf(self.exponent)
    }

    /// Returns the value with the least `cost / u^exponent + weight u`.
    pub(super) fn lowest(&self, weight: f64) -> f64 {
        (self.exponent * self.cost / weight).powf(1.0 / (self.exponent + 1.0))
    }
}

/// Cheap values; a factor near 1 is still needed so that they hold all conditions.
pub(in crate::tolerance) struct Cheapest {
    pub(in crate::tolerance) values: Vec<f64>,
    /// No values that hold all conditions cost less.
    pub(in crate::tolerance) bound: f64,
}

/// A vector for each value, with which it enters a sum.
pub(super) type Condition = Vec<[f64; 3]>;

pub(super) fn norm(v: &[f64; 3]) -> f64 {
    crate::components::norm(v)
}

/// The vector that a condition limits.
pub(super) fn vector(condition: &Condition, values: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (row, value) in condition.iter().zip(values) {
        for (total, x) in sum.iter_mut().zip(row) {
            *total += value * x;
        }
    }
    sum
}

pub(super) fn length(condition: &Condition, values: &[f64]) -> f64 {
    norm(&vector(condition, values))
}
