//! Random mechanisms within their tolerances.

mod agreement;
mod draw;
mod rank;
mod samples;

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::array;
use std::time::{Duration, Instant};

use rayon::prelude::*;

pub use agreement::Agreement;
pub use samples::{Estimate, Samples, Statistics};

use draw::Draw;

use super::{Distribution, ToleranceError, Tolerances, Uncertainties};
use linkage_runtime::Dimensions;

/// Mechanisms that are drawn and evaluated together.
const BLOCK: usize = 1024;
/// Length of a round of blocks; the progress is reported after each.
const ROUND: Duration = Duration::from_millis(100);

/// A study by random sampling: mechanisms whose dimensions are drawn within their tolerances,
/// independently or [correlated](Self::run_correlated), each evaluated in full.
///
/// Equal seeds give equal samples on any number of threads: each block of 1024 mechanisms has a
/// stream of random numbers of its own, and each mechanism uses one number for each parameter, also
/// for those that are exact.
///
/// ```
/// use linkage_analysis::tolerance::{MonteCarlo, Tolerances};
/// use linkage_runtime::{Dimensions, Parameter};
///
/// // The code that `mechanism!` generates.
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
/// # Ok::<(), linkage_analysis::tolerance::ToleranceError>(())
/// ```
pub struct MonteCarlo<'a> {
    count: usize,
    seed: u64,
    distribution: Distribution,
    exceptions: Vec<(usize, Distribution)>,
    progress: Option<Box<dyn FnMut(Progress) + 'a>>,
}

/// The progress of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Mechanisms that have been evaluated.
    pub done: usize,
    /// All mechanisms.
    pub count: usize,
}

impl<'a> MonteCarlo<'a> {
    /// A study of this number of mechanisms, normally distributed, with seed 0.
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
    /// `evaluate` gets some mechanisms and a slice of equal length for each of `K` numbers, which
    /// it fills with one value for each mechanism; NaN for one that cannot be assembled. Use a
    /// `_sweep_sets` method in it, which computes in lanes.
    ///
    /// # Errors
    ///
    /// `Nothing` without mechanisms, `NoSuchParameter` for a distribution of a parameter that is
    /// not there.
    pub fn run<M, const N: usize, const K: usize>(
        self,
        nominal: &M,
        tolerances: &Tolerances<N>,
        evaluate: impl Fn(&[M], [&mut [f64]; K]) + Sync,
    ) -> Result<Samples<N, K>, ToleranceError>
    where
        M: Dimensions<N> + Send,
    {
        let draw = Draw {
            seed: self.seed,
            nominal: nominal.values(),
            middles: *tolerances.middles(),
            tolerances: tolerances.values(),
            distributions: self.distributions()?,
            root: None,
        };
        self.sample(&draw, evaluate)
    }

    /// Works as [`run`](Self::run), with the distributions and correlations of `uncertainties`
    /// instead of those of the study.
    ///
    /// # Errors
    ///
    /// `Nothing` without mechanisms, `NotNormal` if a dimension of another distribution than the
    /// normal one is correlated: its joint distribution is not known then.
    pub fn run_correlated<M, const N: usize, const K: usize>(
        self,
        nominal: &M,
        uncertainties: &Uncertainties<N>,
        evaluate: impl Fn(&[M], [&mut [f64]; K]) + Sync,
    ) -> Result<Samples<N, K>, ToleranceError>
    where
        M: Dimensions<N> + Send,
    {
        uncertainties.all_correlated_are_normal()?;
        let tolerances = uncertainties.tolerances();
        let draw = Draw {
            seed: self.seed,
            nominal: nominal.values(),
            middles: *tolerances.middles(),
            tolerances: tolerances.values(),
            distributions: *uncertainties.distributions(),
            root: Some(*uncertainties.root()),
        };
        self.sample(&draw, evaluate)
    }

    fn sample<M, const N: usize, const K: usize>(
        mut self,
        draw: &Draw<N>,
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
            let entry = distributions.get_mut(index);
            *entry.ok_or(ToleranceError::NoSuchParameter { index, count: N })? = distribution;
        }
        Ok(distributions)
    }
}
