//! Checks that an estimate is where the sum of squares is least.
//!
//! A descent also ends where the mechanism falls apart: at a flat triangle no step leads on,
//! derivatives grow without limit, and standard errors from them become arbitrarily small.
//! Therefore an estimate is checked without the descent.

use std::vec::Vec;

use nalgebra::DMatrix;

use super::determined::Determined;
use super::setup::Identification;
use super::{fit, rows};
use crate::limits::Limits;
use linkage_runtime::Dimensions;

/// An estimate is settled that is off by less than this part of its standard errors.
const SETTLED: f64 = 1e-3;

/// The step to the least sum of squares of the linearised readings.
struct Step {
    /// Taken off the parameters, in terms of their ranges.
    step: Vec<f64>,
    /// Its length in standard deviations of readings.
    length: f64,
}

/// Returns true if no step within the bounds makes the sum of squares smaller. Such steps are made
/// before it returns false.
pub(super) fn settle<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
    limits: &Limits,
    x: &mut Vec<f64>,
    ranges: &[f64],
    unknown: &[usize],
    found: &mut Determined,
) -> bool {
    for _ in 0..fit::POLISH {
        let Step { step, length } = found.within(limits, x);
        if found.is_settled(length) {
            return true;
        }
        let next: Vec<f64> = (0..x.len()).map(|j| x[j] - ranges[j] * step[j]).collect();
        if !limits.hold(&next) {
            return false;
        }
        let rows = rows::rows(identification, &next, unknown);
        let finite = |x: &f64| x.is_finite();
        if !rows
            .iter()
            .all(|row| finite(&row.difference) && row.slopes.iter().all(finite))
        {
            return false;
        }
        let there = Determined::new(&rows, ranges, rows::estimates_deviations(identification));
        if there.rank != found.rank || there.sum > found.sum {
            return false;
        }
        (*x, *found) = (next, there);
    }
    let Step { length, .. } = found.within(limits, x);
    found.is_settled(length)
}

impl Determined {
    fn is_settled(&self, length: f64) -> bool {
        length <= SETTLED * self.deviation() || self.is_nothing(length)
    }

    /// The step of all parameters but those that are at a bound with the sum of squares falling
    /// beyond it.
    fn within(&self, limits: &Limits, x: &[f64]) -> Step {
        let n = x.len();
        let slope = |j: usize| self.jacobian.column(j).dot(&self.differences);
        let stays = |j: usize| {
            let (low, high) = (x[j] <= limits.lower[j], x[j] >= limits.upper[j]);
            (low && slope(j) >= 0.0) || (high && slope(j) <= 0.0)
        };
        let free: Vec<usize> = (0..n).filter(|&j| !stays(j)).collect();
        let mut step = std::vec![0.0; n];
        if free.is_empty() {
            return Step { step, length: 0.0 };
        }
        let rows = self.jacobian.nrows();
        let columns = DMatrix::from_fn(rows, free.len(), |i, k| self.jacobian[(i, free[k])]);
        let svd = columns.svd(true, true);
        let (Some(left), Some(directions)) = (svd.u, svd.v_t) else {
            return Step {
                step,
                length: f64::NAN,
            };
        };
        let needed = self.needed();
        let mut square = 0.0;
        for (k, &singular) in svd.singular_values.iter().enumerate() {
            // NaN is no direction that is left out.
            if singular < needed {
                continue;
            }
            let along = left.column(k).dot(&self.differences);
            square += along * along;
            for (index, &j) in free.iter().enumerate() {
                step[j] += along / singular * directions[(k, index)];
            }
        }
        Step {
            step,
            length: square.sqrt(),
        }
    }
}
