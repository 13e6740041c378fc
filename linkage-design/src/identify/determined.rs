//! Combinations of parameters that the readings determine, with their errors.

use std::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::reading::ReadingRow;

/// The information of the readings about the parameters, each in terms of its range: near the
/// estimate, to first order.
#[derive(Clone, Debug)]
pub(super) struct Determined {
    /// Derivatives of the readings over their standard deviations, by the parameters over their
    /// ranges.
    pub(super) jacobian: DMatrix<f64>,
    /// Differences over standard deviations.
    pub(super) differences: DVector<f64>,
    left: DMatrix<f64>,
    /// Directions of the parameters, one in each row, best determined first.
    pub(super) directions: DMatrix<f64>,
    /// The effect of a step along each on the readings.
    pub(super) singular: Vec<f64>,
    /// The number of determined combinations.
    pub(super) rank: usize,
    /// The sum of squares.
    pub(super) sum: f64,
    readings: usize,
    /// True if standard deviations are found from the scatter.
    estimated: bool,
}

impl Determined {
    pub(super) fn new(rows: &[ReadingRow], ranges: &[f64], estimated: bool) -> Self {
        let n = ranges.len();
        // At least as many rows as parameters: a parameter that no reading determines has a
        // direction, too.
        let m = rows.len().max(n);
        let entry = |i: usize, j: usize| {
            rows.get(i)
                .map_or(0.0, |row| ranges[j] * row.slopes[j] / row.deviation)
        };
        let jacobian = DMatrix::from_fn(m, n, entry);
        let difference = |i: usize| {
            rows.get(i)
                .map_or(0.0, |row| row.difference / row.deviation)
        };
        let differences = DVector::from_fn(m, |i, _| difference(i));
        let svd = jacobian.clone().svd(true, true);
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|&a, &b| svd.singular_values[b].total_cmp(&svd.singular_values[a]));
        // Both were asked for.
        let empty = || DMatrix::zeros(0, 0);
        let (u, v) = (svd.u.unwrap_or_else(empty), svd.v_t.unwrap_or_else(empty));
        let mut determined = Self {
            left: DMatrix::from_fn(m, n, |i, k| u[(i, order[k])]),
            directions: DMatrix::from_fn(n, n, |k, j| v[(order[k], j)]),
            singular: order.iter().map(|&k| svd.singular_values[k]).collect(),
            rank: n,
            sum: differences.norm_squared(),
            readings: rows.len(),
            estimated,
            jacobian,
            differences,
        };
        determined.rank = determined
            .singular
            .iter()
            .filter(|&&s| s >= determined.needed())
            .count();
        determined
    }

    /// Returns the change of the readings below which a combination is not determined over its
    /// range: one standard deviation, as the root of the sum of squares of all changes, but never
    /// less than the rounding of the largest one.
    pub(super) fn needed(&self) -> f64 {
        /// The rounding of a derivative of 0, as part of the largest one.
        const ROUNDING: f64 = 1e-11;
        let largest = self.singular.first().copied().unwrap_or(0.0);
        (ROUNDING * largest).max(self.deviation())
    }

    /// Returns true for a change of the readings within rounding.
    pub(super) fn is_nothing(&self, change: f64) -> bool {
        /// The same part for sums over a few hundred readings.
        const NOTHING: f64 = 1e-9;
        change <= NOTHING * self.singular.first().copied().unwrap_or(0.0)
    }

    /// Returns the number of readings less the number of determined combinations.
    pub(super) fn degrees_of_freedom(&self) -> usize {
        self.readings.saturating_sub(self.rank)
    }

    /// Returns true if standard deviations are found from the scatter.
    pub(super) fn is_estimated(&self) -> bool {
        self.estimated
    }

    /// The standard deviation of a reading over that which was given: 1 unless it is found from the
    /// scatter; NaN if there is none.
    pub(super) fn deviation(&self) -> f64 {
        match (self.estimated, self.degrees_of_freedom()) {
            (false, _) => 1.0,
            (true, 0) => f64::NAN,
            (true, freedom) => (self.sum / freedom as f64).sqrt(),
        }
    }

    /// Returns the step that leaves the least differences when it is subtracted from the
    /// parameters.
    pub(super) fn step(&self) -> Vec<f64> {
        let n = self.singular.len();
        let mut step = std::vec![0.0; n];
        for k in 0..self.rank {
            let along = self.left.column(k).dot(&self.differences) / self.singular[k];
            for (j, step) in step.iter_mut().enumerate() {
                *step += along * self.directions[(k, j)];
            }
        }
        step
    }

    /// Returns the covariance of parameters `i` and `j` within the determined combinations.
    pub(super) fn covariance(&self, i: usize, j: usize) -> f64 {
        let part =
            |k: usize| self.directions[(k, i)] * self.directions[(k, j)] / self.singular[k].powi(2);
        self.deviation().powi(2) * (0..self.rank).map(part).sum::<f64>()
    }

    /// Returns true for a parameter that is part of no undetermined combination.
    pub(super) fn is_determined(&self, j: usize) -> bool {
        /// A part of such a combination that is as small does nothing: a thousandth of the
        /// parameter's range.
        const PART: f64 = 1e-3;
        let parts = (self.rank..self.singular.len()).map(|k| self.directions[(k, j)].powi(2));
        parts.sum::<f64>().sqrt() < PART
    }

    /// Returns the part of each reading in its own estimate.
    pub(super) fn leverage(&self, i: usize) -> f64 {
        (0..self.rank).map(|k| self.left[(i, k)].powi(2)).sum()
    }
}
