//! Errors in units of the roundoff of `f64` times the size of the mechanism.

use crate::methods::Parts;
use linkage_peers::ROUNDOFF;
use linkage_peers::reference::Exact;
use std::ops::Range;

/// The longest length of K1, in mm.
pub(crate) const SIZE: f64 = 140.0;

/// Numbers of the answer that are judged together.
pub(crate) struct Part {
    pub(crate) name: &'static str,
    pub(crate) range: Range<usize>,
    /// Lengths, and rates by an angle: `SIZE`. Rates by a length: 1.
    pub(crate) size: f64,
}

/// Errors of one method over all positions.
pub(crate) struct Errors {
    /// The largest error of each part.
    pub(crate) largest: Vec<f64>,
    /// Median and maximum of each position's largest error.
    pub(crate) median: f64,
    pub(crate) maximum: f64,
}

impl Errors {
    pub(crate) fn of<const W: usize>(
        results: &[[Parts; W]],
        exact: &[Vec<Exact>],
        parts: &[Part],
    ) -> Self {
        let mut largest = vec![0.0; parts.len()];
        let mut by_position = Vec::with_capacity(results.len());
        for (result, exact) in results.iter().zip(exact) {
            let mut worst = 0.0;
            for (part, largest) in parts.iter().zip(&mut largest) {
                let pairs = exact[part.range.clone()]
                    .iter()
                    .zip(&result[part.range.clone()]);
                let error = pairs.fold(0.0, |error, (exact, &[high, low])| {
                    larger(error, exact.distance(high, low))
                });
                let error = error / (ROUNDOFF * part.size);
                *largest = larger(*largest, error);
                worst = larger(worst, error);
            }
            by_position.push(worst);
        }
        by_position.sort_by(f64::total_cmp);
        Self {
            largest,
            median: by_position[by_position.len() / 2],
            maximum: by_position[by_position.len() - 1],
        }
    }
}

impl Errors {
    /// From the errors in each of several sets of positions.
    pub(crate) fn of_sets(sets: &[&[f64]]) -> Self {
        let largest = |set: &[f64]| set.iter().fold(0.0, |most, &error| larger(most, error));
        let mut all = sets.concat();
        all.sort_by(f64::total_cmp);
        Self {
            largest: sets.iter().map(|set| largest(set)).collect(),
            median: all[all.len() / 2],
            maximum: largest(&all),
        }
    }
}

/// The larger number; NaN if one of them is.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}
