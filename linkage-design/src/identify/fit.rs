//! The least sum of squares of an identification.

use std::vec::Vec;

use super::determined::Determined;
use super::rows;
use super::setup::Identification;
use crate::error::DesignError;
use crate::least_squares::{State, minimise};
use crate::limits::Limits;
use crate::normal::Normal;
use linkage_runtime::Dimensions;

/// The most evaluations of a fit: a hundred times those of a fit that begins near its end.
const STEPS: usize = 1000;
/// The weight of a change of all parameters over their ranges, in standard deviations of readings,
/// during the descent. It keeps combinations that readings do not determine near their start, and
/// is taken out again afterwards.
const HOLD: f64 = 0.1;
/// The most steps without it: one takes out all but the curvature.
pub(super) const POLISH: usize = 3;

/// Returns the least sum of squares, with a hold on combinations that readings do not determine.
pub(super) fn descend<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
    limits: &Limits,
    start: &[f64],
    ranges: &[f64],
    unknown: &[usize],
) -> Result<Vec<f64>, DesignError> {
    let places: Vec<usize> = (0..unknown.len()).collect();
    let evaluate = |x: &[f64], normal: &mut Normal| {
        for row in rows::rows(identification, x, unknown) {
            let slopes: Vec<f64> = row
                .slopes
                .iter()
                .map(|slope| slope / row.deviation)
                .collect();
            normal.add(row.difference / row.deviation, &places, &slopes);
        }
        for (j, range) in ranges.iter().enumerate() {
            normal.add(HOLD * (x[j] - start[j]) / range, &[j], &[HOLD / range]);
        }
    };
    match minimise(start.to_vec(), limits, STEPS, evaluate) {
        (descent, State::Converged) => Ok(descent.x),
        _ => Err(DesignError::Unsettled { steps: STEPS }),
    }
}

/// Removes the hold from determined combinations. Parameters at a bound stay there, and then all
/// others stay, too.
pub(super) fn polished<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
    limits: &Limits,
    mut x: Vec<f64>,
    ranges: &[f64],
    unknown: &[usize],
    found: &Determined,
) -> Vec<f64> {
    let mut found = found.clone();
    for _ in 0..POLISH {
        let step = found.step();
        let next: Vec<f64> = (0..x.len()).map(|j| x[j] - ranges[j] * step[j]).collect();
        if !limits.hold(&next) {
            break;
        }
        let rows = rows::rows(identification, &next, unknown);
        if rows.iter().any(|row| row.difference.is_nan()) {
            break;
        }
        let there = Determined::new(&rows, ranges, rows::estimates_deviations(identification));
        // The same number of combinations is determined, and the sum of squares grows by rounding
        // at most.
        if there.rank != found.rank || there.sum > found.sum * (1.0 + 1e-9) {
            break;
        }
        (x, found) = (next, there);
    }
    x
}
