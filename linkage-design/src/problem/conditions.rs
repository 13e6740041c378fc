//! Conditions that do not hold, with the size of the violation, and conditions in the way.

use std::string::String;
use std::vec::Vec;

use super::super::normal::Normal;
use super::super::violation::Violation;
use super::Problem;
use linkage_runtime::DimensionSet;

/// A condition that is violated by less than this part of its size holds: the last step met it to
/// second order.
const HOLDS: f64 = 1e-9;

/// One that has less to spare than this part of it is in the way: descents end that near to it.
const ACTIVE: f64 = 1e-6;

/// The effect of the bounds' widths on a condition counts as its size up to this many times the
/// size of its own numbers. So no condition holds that is violated by more than a millionth of
/// these.
const MOST: f64 = 1e3;

/// A row of a condition in a mechanism.
struct ConditionRow {
    /// The number of its objective.
    objective: usize,
    value: f64,
    /// The size with which its value is compared.
    size: f64,
}

impl<M: DimensionSet<N> + Copy, A, const N: usize> Problem<'_, M, A, N> {
    /// Returns true if all conditions hold.
    pub(crate) fn meets(&self, at: &Normal) -> bool {
        self.violations(at).is_empty()
    }

    /// The conditions that do not hold, each by its worst row.
    pub(crate) fn violations(&self, at: &Normal) -> Vec<Violation> {
        let rows = self.conditions(at);
        // A value that is no number holds nothing.
        let broken = rows.filter(|row| row.value.is_nan() || row.value < -HOLDS * row.size);
        let mut found: Vec<Violation> = Vec::new();
        for ConditionRow {
            objective,
            value,
            size,
        } in broken
        {
            let (by, part) = (-value, -value / size);
            match found.last_mut().filter(|last| last.objective == objective) {
                Some(last) if last.part >= part => {}
                Some(last) => {
                    *last = Violation {
                        objective,
                        by,
                        part,
                    }
                }
                None => found.push(Violation {
                    objective,
                    by,
                    part,
                }),
            }
        }
        found
    }

    /// The titles of the conditions that are met with nothing to spare.
    pub(crate) fn active(&self, at: &Normal) -> Vec<String> {
        let rows = self.conditions(at);
        let active = rows.filter(|row| row.value <= ACTIVE * row.size);
        let mut active: Vec<usize> = active.map(|row| row.objective).collect();
        active.dedup();
        active
            .into_iter()
            .map(|k| self.objectives[k].title())
            .collect()
    }

    /// The rows of all conditions.
    fn conditions(&self, at: &Normal) -> impl Iterator<Item = ConditionRow> {
        let widths = self.widths();
        let objectives = self.objectives.iter().enumerate();
        let conditions = objectives.filter(|(_, objective)| objective.is_condition());
        let owners = conditions.flat_map(|(k, objective)| (0..objective.rows()).map(move |_| k));
        let rows = owners.zip(&at.conditions).zip(&self.sizes);
        rows.map(move |((objective, (value, slopes)), size_of_row)| {
            let change: f64 = slopes.iter().zip(&widths).map(|(s, w)| (s * w).abs()).sum();
            let (value, size) = (*value, change.min(MOST * size_of_row));
            ConditionRow {
                objective,
                value,
                size,
            }
        })
    }
}
