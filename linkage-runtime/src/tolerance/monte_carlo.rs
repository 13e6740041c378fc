//! Random mechanisms within their tolerances.

mod agreement;
mod distribution;
mod rank;
mod samples;

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::array;
use std::time::{Duration, Instant};

use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;
use rayon::prelude::*;

pub use agreement::Agreement;
pub use distribution::Distribution;
pub use samples::{Estimate, Samples, Statistics};

use super::{ToleranceError, Tolerances};
use crate::Dimensions;

/// Mechanisms that are drawn and evaluated together.
const BLOCK: usize = 1024;
/// How long a round of blocks should take; after each the progress is reported.
const ROUND: Duration = Duration::from_millis(100);

/// A study by random sampling: mechanisms whose dimensions are drawn independently within their
/// tolerances, each evaluated in full.
///
/// Equal seeds give equal samples on any number of threads: each block of 1024 mechanisms has a stream
/// of random numbers of its own, and each mechanism uses one number for each parameter, also for those
/// that are exact.
///
/// ```
/// use linkage_runtime::tolerance::{MonteCarlo, Tolerances};
/// use linkage_runtime::{Dimensions, Parameter};
///
/// // What `mechanism!` generates.
/// struct Rod { length: f64 }
/// impl Dimensions<1> for Rod {
///     const PARAMETERS: &'static [Parameter] =
///         &[Parameter { name: "length", unit: "mm", nominal: 40.0, tolerance: 0.03 }];
///     fn from_values(&[length]: &[f64; 1]) -> Self { Self { length } }
///     fn values(&self) -> [f64; 1] { [self.length] }
/// }
///
/// let tolerances = Tolerances::complete(Rod::PARAMETERS)?;
/// let samples = MonteCarlo::new(20_000).seed(7).run(
///     &Rod { length: 40.0 },
///     &tolerances,
///     |rods, [twice]| {
///         for (rod, twice) in rods.iter().zip(twice) {
///             *twice = 2.0 * rod.length;
///         }
///     },
/// )?;
/// let twice = samples.statistics(0);
/// assert!((twice.mean.value - 80.0).abs() < 1e-3 && (twice.deviation.value - 0.02).abs() < 1e-3);
/// # Ok::<(), linkage_runtime::tolerance::ToleranceError>(())
/// ```
pub struct MonteCarlo<'a> {
    count: usize,
    seed: u64,
    distribution: Distribution,
    exceptions: Vec<(usize, Distribution)>,
    progress: Option<Box<dyn FnMut(Progress) + 'a>>,
}

/// How far a study has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Mechanisms that have been evaluated.
    pub done: usize,
    /// All mechanisms.
    pub count: usize,
}

impl<'a> MonteCarlo<'a> {
    /// A study of so many mechanisms, normally distributed, with seed 0.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self {
            count,
            seed: 0,
            distribution: Distribution::Normal,
            exceptions: Vec::new(),
            progress: None,
        }
    }

    /// Another seed gives other, independent samples.
    #[must_use]
    pub fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    /// The distribution of all parameters that have none of their own.
    #[must_use]
    pub fn distribution(mut self, distribution: Distribution) -> Self {
        self.distribution = distribution;
        self
    }

    /// The distribution of the parameter with this index.
    #[must_use]
    pub fn distribution_of(mut self, index: usize, distribution: Distribution) -> Self {
        self.exceptions.push((index, distribution));
        self
    }

    /// Calls `report` about ten times a second and at the end, on the thread that called `run`.
    #[must_use]
    pub fn progress(mut self, report: impl FnMut(Progress) + 'a) -> Self {
        self.progress = Some(Box::new(report));
        self
    }

    /// Draws and evaluates the mechanisms, on all threads of rayon's current pool.
    ///
    /// `evaluate` gets some mechanisms and a slice of equal length for each of `K` numbers, which it
    /// fills with one value for each mechanism; what cannot be assembled is NaN. Use a `_sweep_sets`
    /// method in it, which computes in lanes.
    ///
    /// # Errors
    ///
    /// `Nothing` without mechanisms, `NoSuchParameter` for a distribution of a parameter that is not
    /// there.
    pub fn run<M, const N: usize, const K: usize>(
        mut self,
        nominal: &M,
        tolerances: &Tolerances<N>,
        evaluate: impl Fn(&[M], [&mut [f64]; K]) + Sync,
    ) -> Result<Samples<N, K>, ToleranceError>
    where
        M: Dimensions<N> + Send,
    {
        if self.count == 0 {
            return Err(ToleranceError::Nothing {
                what: "no mechanisms",
            });
        }
        let draw = Draw {
            seed: self.seed,
            nominal: nominal.values(),
            tolerances: tolerances.values(),
            distributions: self.distributions()?,
        };
        let count = self.count;
        let block = |index: usize| -> [Vec<f64>; K] {
            let length = BLOCK.min(count - index * BLOCK);
            let mechanisms: Vec<M> = draw.block(index, length);
            let mut columns = array::from_fn(|_| vec![f64::NAN; length]);
            evaluate(&mechanisms, columns.each_mut().map(Vec::as_mut_slice));
            columns
        };
        let mut columns: [Vec<f64>; K] = array::from_fn(|_| Vec::with_capacity(count));
        let (mut next, blocks) = (0, count.div_ceil(BLOCK));
        let mut round = rayon::current_num_threads().max(1);
        while next < blocks {
            let (started, end) = (Instant::now(), blocks.min(next + round));
            let results: Vec<_> = (next..end).into_par_iter().map(block).collect();
            for (column, part) in results.into_iter().flat_map(|r| (0..K).zip(r)) {
                columns[column].extend_from_slice(&part);
            }
            next = end;
            // Only the length of a round depends on time, and no sample on the length of a round.
            let taken = started.elapsed();
            round = if taken < ROUND / 2 { 2 * round } else { round };
            round = if taken > ROUND * 2 {
                (round / 2).max(1)
            } else {
                round
            };
            if let Some(report) = &mut self.progress {
                report(Progress {
                    done: count.min(next * BLOCK),
                    count,
                });
            }
        }
        Ok(Samples::new(columns, draw.distributions))
    }

    fn distributions<const N: usize>(&self) -> Result<[Distribution; N], ToleranceError> {
        let mut distributions = [self.distribution; N];
        for &(index, distribution) in &self.exceptions {
            let place = distributions.get_mut(index);
            *place.ok_or(ToleranceError::NoSuchParameter { index, count: N })? = distribution;
        }
        Ok(distributions)
    }
}

/// Everything that a sample depends on.
struct Draw<const N: usize> {
    seed: u64,
    nominal: [f64; N],
    tolerances: [f64; N],
    distributions: [Distribution; N],
}

impl<const N: usize> Draw<N> {
    /// The mechanisms of a block.
    fn block<M: Dimensions<N>>(&self, index: usize, length: usize) -> Vec<M> {
        let mut random = stream(self.seed, index as u64);
        let mut mechanism = || {
            let mut values = self.nominal;
            for (i, value) in values.iter_mut().enumerate() {
                *value += self.tolerances[i] * self.distributions[i].draw(&mut random);
            }
            M::from_values(&values)
        };
        (0..length).map(|_| mechanism()).collect()
    }
}

/// The random numbers of one block.
fn stream(seed: u64, block: u64) -> Xoshiro256PlusPlus {
    let mut state = mixed(mixed(seed) ^ block);
    let mut bytes = [0; 32];
    for word in bytes.chunks_exact_mut(8) {
        state = mixed(state);
        word.copy_from_slice(&state.to_le_bytes());
    }
    Xoshiro256PlusPlus::from_seed(bytes)
}

/// A step of SplitMix64, which spreads neighbouring numbers over all bits.
fn mixed(state: u64) -> u64 {
    let mut z = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
