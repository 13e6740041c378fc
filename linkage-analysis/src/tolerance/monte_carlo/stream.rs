//! Statistics of mechanisms that are not kept: the memory does not grow with their number.

mod bins;
mod bytes;
mod sums;
mod tally;

use alloc::vec::Vec;
use core::ops::Range;

use super::agreement::Agreement;
use super::draw::Draw;
use super::rank::ranks;
use super::statistics::{Estimate, Moments, Statistics, score_interval};
use crate::tolerance::{Effects, ToleranceError};
use bins::{Bin, Scale};
use tally::{End, Tally};

/// The results of a study of any length: `K` numbers of mechanisms with `N` dimensions each, as
/// sums, extremes and a histogram, in about 2 MB of memory for each number.
///
/// Parts of a study, and a study that was stopped, have some of its mechanisms. Their
/// [`merge`](Self::merge) is equal to the study as a whole, to the last bit, in whatever order and
/// number the parts come.
#[derive(Clone, Debug, PartialEq)]
pub struct Stream<const N: usize, const K: usize> {
    study: Study<N, K>,
    tally: Tally<K>,
}

/// What parts of a study have in common.
#[derive(Clone, Debug, PartialEq)]
struct Study<const N: usize, const K: usize> {
    count: u64,
    draw: Draw<N>,
    scales: [Scale; K],
}

/// The least or the largest value of a study, and the mechanism that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExtremeSample<const N: usize> {
    /// The value.
    pub value: f64,
    /// The number of the mechanism in the study, from 0: the first one if several have the value.
    pub number: u64,
    /// Its dimensions, in the units of the parameters.
    pub dimensions: [f64; N],
}

impl<const N: usize, const K: usize> Stream<N, K> {
    /// A study without mechanisms, whose first values are like these.
    pub(super) fn new(count: u64, draw: Draw<N>, pilot: [&[f64]; K]) -> Self {
        let scales = pilot.map(Scale::fitting);
        Self {
            tally: Tally::new(&scales),
            study: Study {
                count,
                draw,
                scales,
            },
        }
    }

    /// The same study without mechanisms.
    pub(super) fn empty(&self) -> Self {
        Self {
            study: self.study.clone(),
            tally: Tally::new(&self.study.scales),
        }
    }

    /// Adds a block behind all others.
    pub(super) fn push(&mut self, block: u64, columns: [&[f64]; K]) {
        self.tally.push(block, columns);
    }

    pub(super) fn draw(&self) -> &Draw<N> {
        &self.study.draw
    }

    /// The blocks of a range that are not there.
    pub(super) fn gaps(&self, blocks: Range<u64>) -> Vec<Range<u64>> {
        self.tally.sums.gaps(blocks)
    }

    /// Adds the mechanisms of another part of the same study.
    ///
    /// # Errors
    ///
    /// `OtherStudy` if seed, number, dimensions, tolerances or distributions differ, or the values
    /// that the first mechanisms have; `Repeated` if both have a mechanism. Nothing changes then.
    pub fn merge(&mut self, part: &Self) -> Result<(), ToleranceError> {
        if self.study != part.study {
            return Err(ToleranceError::OtherStudy);
        }
        self.tally
            .merge(&part.tally)
            .ok_or(ToleranceError::Repeated)
    }

    /// The number of mechanisms that have been evaluated.
    #[must_use]
    pub const fn done(&self) -> u64 {
        self.tally.done
    }

    /// The number of mechanisms of the whole study.
    #[must_use]
    pub const fn count(&self) -> u64 {
        self.study.count
    }

    /// The number of mechanisms without a value in any of the numbers: they could not be assembled.
    #[must_use]
    pub const fn missing(&self) -> u64 {
        self.tally.missing
    }

    /// Mean, deviation, skewness and limits of number `k`; NaN if no mechanism could be assembled.
    ///
    /// # Panics
    ///
    /// Panics, as all methods that take `k`, if it is not below `K`.
    #[must_use]
    pub fn statistics(&self, k: usize) -> Statistics {
        let sums = self.tally.sums.total(k);
        let moments = Moments {
            count: sums.count,
            centre: self.study.scales[k].centre,
            powers: sums.powers,
        };
        moments.statistics(self.tally.done - sums.count, self.limits(k))
    }

    /// The mechanisms with the least and with the largest value of number `k`; `None` if no
    /// mechanism could be assembled.
    #[must_use]
    pub fn extremes(&self, k: usize) -> Option<[ExtremeSample<N>; 2]> {
        let extreme = |end: End| ExtremeSample {
            value: end.value,
            number: end.number,
            dimensions: self.study.draw.mechanism(end.number),
        };
        let [least, largest] = self.tally.ends[k];
        Some([extreme(least?), extreme(largest?)])
    }

    /// The value below which this part of the mechanisms is, 0.95 for the 95th percentile, with an
    /// interval of this confidence.
    ///
    /// It is the percentile of all values with an error of at most [`resolution`](Self::resolution)
    /// or, if it is further than eight deviations from the median, of a part in 8000 of that
    /// distance. The interval is as that of `Samples::percentile`, and contains this error. NaN if
    /// no mechanism could be assembled or an argument is not between 0 and 1.
    #[must_use]
    pub fn percentile(&self, k: usize, part: f64, confidence: f64) -> Estimate {
        let count = self.tally.sums.total(k).count;
        let inside = |x: f64| x > 0.0 && x < 1.0;
        if count == 0 || !(inside(part) && inside(confidence)) {
            return Estimate::NAN;
        }
        // Of the order statistic with a rank from 0: its bin, and where it is if they are even.
        let find = |rank: f64| {
            let mut below = 0.0;
            self.filled(k).find_map(|bin| {
                let before = below;
                below += bin.count as f64;
                let share = (rank + 0.5 - before) / bin.count as f64;
                (rank < below).then(|| (bin, within(bin, share.clamp(0.0, 1.0))))
            })
        };
        let [low, high] = ranks(count as usize, part, confidence).map(|rank| rank as u64);
        // Ranks count from 1; 0 and one more than there are samples mean no limit.
        let limit = |rank: u64, beyond: f64, end: fn(Bin) -> f64| {
            let index = rank.checked_sub(1).filter(|&index| index < count);
            let bin = index.and_then(|index| find(index as f64));
            bin.map_or(beyond, |(bin, _)| end(bin))
        };
        Estimate {
            value: find(part * (count - 1) as f64).map_or(f64::NAN, |(_, value)| value),
            low: limit(low, f64::NEG_INFINITY, |bin| bin.low),
            high: limit(high, f64::INFINITY, |bin| bin.high),
        }
    }

    /// The width of the bins in which values are counted: about a part in 16,000 of the standard
    /// deviation of the first mechanisms.
    #[must_use]
    pub fn resolution(&self, k: usize) -> f64 {
        self.study.scales[k].width
    }

    /// The part of all mechanisms, also of those that could not be assembled, whose number `k` is
    /// between two limits, with the score interval of this confidence. Limits are exact to
    /// [`resolution`](Self::resolution).
    #[must_use]
    pub fn part_within(&self, k: usize, low: f64, high: f64, confidence: f64) -> Estimate {
        let within: f64 = self.filled(k).map(|bin| shared(bin, low, high)).sum();
        score_interval(within, self.tally.done as f64, confidence)
    }

    /// A histogram of number `k`: how many values are in each of some bins of equal width between
    /// two limits, exact to [`resolution`](Self::resolution) at the ends of each bin.
    #[must_use]
    pub fn histogram(&self, k: usize, [low, high]: [f64; 2], bins: usize) -> Vec<f64> {
        let mut counts = alloc::vec![0.0; bins];
        let width = (high - low) / bins as f64;
        for bin in self
            .filled(k)
            .filter(|bin| bin.low <= high && bin.high >= low)
        {
            let index = |x: f64| ((x - low) / width).clamp(0.0, bins as f64 - 1.0) as usize;
            for (j, count) in (index(bin.low)..).zip(&mut counts[index(bin.low)..=index(bin.high)])
            {
                let [from, to] = [j, j + 1].map(|j| low + width * j as f64);
                *count += shared(bin, from, to);
            }
        }
        counts
    }

    /// The mechanisms and the linear analysis, number by number. `effects` are those of the same
    /// quantities by the same tolerances, `nominal` the values of the nominal mechanism.
    #[must_use]
    pub fn agreement(&self, effects: &Effects<N, K>, nominal: [f64; K]) -> [Agreement; K] {
        let deviations = self.study.draw.deviations();
        Agreement::all(effects, &deviations, nominal, |k| self.statistics(k))
    }

    /// The least and the largest value, NaN if there is none.
    fn limits(&self, k: usize) -> [f64; 2] {
        self.tally.ends[k].map(|end| end.map_or(f64::NAN, |end| end.value))
    }

    /// Filled bins in the order of the numbers, within the limits of the values.
    fn filled(&self, k: usize) -> impl Iterator<Item = Bin> {
        let [min, max] = self.limits(k);
        self.tally.bins[k].filled().map(move |bin| Bin {
            low: bin.low.max(min).min(max),
            high: bin.high.min(max).max(min),
            ..bin
        })
    }
}

/// A part of the way through a bin, also if it ends at infinity.
fn within(bin: Bin, share: f64) -> f64 {
    if bin.high.is_infinite() || bin.low.is_infinite() {
        return if bin.low.is_infinite() {
            bin.high
        } else {
            bin.low
        };
    }
    bin.low + share * (bin.high - bin.low)
}

/// How many of a bin's values are between two limits, if they are even.
fn shared(bin: Bin, low: f64, high: f64) -> f64 {
    let count = bin.count as f64;
    let [from, to] = [bin.low.max(low), bin.high.min(high)];
    if bin.low == bin.high || !(bin.high - bin.low).is_finite() {
        return if from <= to { count } else { 0.0 };
    }
    count * ((to - from) / (bin.high - bin.low)).clamp(0.0, 1.0)
}
