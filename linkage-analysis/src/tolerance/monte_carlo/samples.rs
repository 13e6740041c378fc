//! Statistics of samples.

use alloc::vec::Vec;
use core::{array, fmt};

use rayon::slice::ParallelSliceMut;

use super::rank::ranks;
use crate::tolerance::Distribution;
use crate::tolerance::distribution::normal;
use linkage_core::format::rounded;

/// The results of a study: `K` numbers for each mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples<const N: usize, const K: usize> {
    columns: [Vec<f64>; K],
    /// The numbers of each column that are not NaN, in order.
    sorted: [Vec<f64>; K],
    distributions: [Distribution; N],
}

/// An estimate from samples with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

/// A number over all mechanisms that could be assembled. Intervals are of 95 % confidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// The number of mechanisms that could be assembled.
    pub count: usize,
    /// The number of mechanisms that could not be assembled, whose value is NaN.
    pub missing: usize,
    /// The mean.
    pub mean: Estimate,
    /// The standard deviation.
    pub deviation: Estimate,
    /// The least value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
}

impl<const N: usize, const K: usize> Samples<N, K> {
    pub(super) fn new(columns: [Vec<f64>; K], distributions: [Distribution; N]) -> Self {
        let sorted = columns.each_ref().map(|column| {
            let mut numbers: Vec<f64> = column.iter().copied().filter(|x| !x.is_nan()).collect();
            numbers.par_sort_unstable_by(f64::total_cmp);
            numbers
        });
        Self {
            columns,
            sorted,
            distributions,
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

    /// The distribution of each parameter.
    #[must_use]
    pub const fn distributions(&self) -> &[Distribution; N] {
        &self.distributions
    }

    /// The number of mechanisms without a value in any of the numbers: they could not be assembled.
    #[must_use]
    pub fn missing(&self) -> usize {
        let count = self.columns.first().map_or(0, Vec::len);
        let lacks = |row: &usize| self.columns.iter().any(|column| column[*row].is_nan());
        (0..count).filter(lacks).count()
    }

    /// Mean, deviation and limits of number `k`; NaN if no mechanism could be assembled.
    #[must_use]
    pub fn statistics(&self, k: usize) -> Statistics {
        let sorted = &self.sorted[k];
        let count = sorted.len();
        let n = count as f64;
        // About a value in the middle, so that nothing cancels.
        let middle = sorted.get(count / 2).copied().unwrap_or(f64::NAN);
        let shift = sorted.iter().map(|x| x - middle).sum::<f64>() / n;
        let power = |p: i32| -> f64 { sorted.iter().map(|x| (x - middle - shift).powi(p)).sum() };
        let (squares, fourth) = (power(2), power(4));
        let deviation = (squares / (n - 1.0)).sqrt();
        // The variance of a variance depends on how heavy the tails are.
        let peak = if squares == 0.0 {
            1.0
        } else {
            n * fourth / (squares * squares)
        };
        let spread = deviation * (0.25 * (peak - 1.0).max(0.0) / n).sqrt();
        let z = normal(0.975);
        let around = |value: f64, error: f64| Estimate {
            value,
            low: value - z * error,
            high: value + z * error,
        };
        Statistics {
            count,
            missing: self.columns[k].len() - count,
            mean: around(middle + shift, deviation / n.sqrt()),
            deviation: around(deviation, spread),
            min: sorted.first().copied().unwrap_or(f64::NAN),
            max: sorted.last().copied().unwrap_or(f64::NAN),
        }
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
            return Estimate {
                value: f64::NAN,
                low: f64::NAN,
                high: f64::NAN,
            };
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
        let n = self.columns[k].len() as f64;
        let part = within as f64 / n;
        let z = normal(0.5 + 0.5 * confidence);
        let centre = (part + 0.5 * z * z / n) / (1.0 + z * z / n);
        let half =
            z / (1.0 + z * z / n) * (part * (1.0 - part) / n + 0.25 * z * z / (n * n)).sqrt();
        Estimate {
            value: part,
            low: (centre - half).max(0.0),
            high: (centre + half).min(1.0),
        }
    }

    /// The standard deviation that each parameter's distribution has for a tolerance of 1.
    pub(super) fn deviations(&self) -> [f64; N] {
        array::from_fn(|i| self.distributions[i].deviation())
    }
}

/// A text such as `17.5 (17.4 to 17.6)`.
impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [value, low, high] = [self.value, self.low, self.high].map(rounded);
        write!(f, "{value} ({low} to {high})")
    }
}

impl fmt::Display for Statistics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "mean                {}", self.mean)?;
        writeln!(f, "standard deviation  {}", self.deviation)?;
        writeln!(f, "from                {}", rounded(self.min))?;
        writeln!(f, "to                  {}", rounded(self.max))?;
        writeln!(f, "mechanisms          {}", self.count)?;
        writeln!(f, "not assembled       {}", self.missing)
    }
}
