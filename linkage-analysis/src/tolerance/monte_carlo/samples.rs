//! All values of a study, and their statistics.

use alloc::vec::Vec;

use rayon::slice::ParallelSliceMut;

use super::agreement::Agreement;
use super::rank::ranks;
use super::statistics::{Estimate, Moments, Statistics, score_interval};
use crate::tolerance::Effects;

/// The results of a study: `K` numbers for each mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples<const N: usize, const K: usize> {
    columns: [Vec<f64>; K],
    /// The numbers of each column that are not NaN, in order.
    sorted: [Vec<f64>; K],
    /// The standard deviation that each parameter has for a tolerance of 1.
    deviations: [f64; N],
}

impl<const N: usize, const K: usize> Samples<N, K> {
    pub(super) fn new(columns: [Vec<f64>; K], deviations: [f64; N]) -> Self {
        let sorted = columns.each_ref().map(|column| {
            let mut numbers: Vec<f64> = column.iter().copied().filter(|x| !x.is_nan()).collect();
            numbers.par_sort_unstable_by(f64::total_cmp);
            numbers
        });
        Self {
            columns,
            sorted,
            deviations,
        }
    }

    /// The values of number `k`, one for each mechanism in the order in which they were drawn.
    ///
    /// # Panics
    ///
    /// Panics, as all methods that take `k`, if it is not below `K`.
    #[must_use]
    pub fn values(&self, k: usize) -> &[f64] {
        &self.columns[k]
    }

    /// The number of mechanisms without a value in any of the numbers: they could not be assembled.
    #[must_use]
    pub fn missing(&self) -> usize {
        let count = self.columns.first().map_or(0, Vec::len);
        let lacks = |row: &usize| self.columns.iter().any(|column| column[*row].is_nan());
        (0..count).filter(lacks).count()
    }

    /// Mean, deviation, skewness and limits of number `k`; NaN if no mechanism could be assembled.
    #[must_use]
    pub fn statistics(&self, k: usize) -> Statistics {
        let sorted = &self.sorted[k];
        let centre = sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN);
        let power = |p: i32| sorted.iter().map(|x| (x - centre).powi(p)).sum();
        let moments = Moments {
            count: sorted.len() as u64,
            centre,
            powers: [1, 2, 3, 4].map(power),
        };
        let ends = [sorted.first(), sorted.last()].map(|end| end.copied().unwrap_or(f64::NAN));
        moments.statistics((self.columns[k].len() - sorted.len()) as u64, ends)
    }

    /// The value below which this part of the mechanisms is, 0.95 for the 95th percentile, with
    /// an interval of this confidence.
    ///
    /// The ends of the interval are order statistics, chosen by the binomial distribution, and
    /// valid for any distribution of the values. An end is infinite where there are too few samples
    /// for it. NaN if no mechanism could be assembled or an argument is not between 0 and 1.
    #[must_use]
    pub fn percentile(&self, k: usize, part: f64, confidence: f64) -> Estimate {
        let sorted = &self.sorted[k];
        let inside = |x: f64| x > 0.0 && x < 1.0;
        if sorted.is_empty() || !(inside(part) && inside(confidence)) {
            return Estimate::NAN;
        }
        let rank = part * (sorted.len() - 1) as f64;
        let (below, above) = (rank.floor() as usize, rank.ceil() as usize);
        let rest = rank - rank.floor();
        let [low, high] = ranks(sorted.len(), part, confidence);
        // Ranks count from 1; 0 and one more than there are samples mean no limit.
        let limit = |rank: usize, beyond: f64| {
            let index = rank.checked_sub(1);
            index
                .and_then(|index| sorted.get(index))
                .copied()
                .unwrap_or(beyond)
        };
        Estimate {
            value: sorted[below] + rest * (sorted[above] - sorted[below]),
            low: limit(low, f64::NEG_INFINITY),
            high: limit(high, f64::INFINITY),
        }
    }

    /// The part of all mechanisms, also of those that could not be assembled, whose number `k` is
    /// between two limits, with the score interval of this confidence.
    #[must_use]
    pub fn part_within(&self, k: usize, low: f64, high: f64, confidence: f64) -> Estimate {
        let sorted = &self.sorted[k];
        let below = sorted.partition_point(|&x| x < low);
        let within = sorted.partition_point(|&x| x <= high).saturating_sub(below);
        score_interval(within as f64, self.columns[k].len() as f64, confidence)
    }

    /// The samples and the linear analysis, number by number. `effects` are those of the same
    /// quantities by the same tolerances, `nominal` the values of the nominal mechanism.
    #[must_use]
    pub fn agreement(&self, effects: &Effects<N, K>, nominal: [f64; K]) -> [Agreement; K] {
        Agreement::all(effects, &self.deviations, nominal, |k| self.statistics(k))
    }
}
