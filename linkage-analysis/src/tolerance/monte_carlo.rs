//! Random mechanisms within their tolerances.

mod agreement;
mod block;
mod block_evaluator;
mod deviates;
mod draw;
mod origin;
mod random;
mod rank;
mod rounds;
mod samples;
mod statistics;
mod stream;
mod study;
mod wide;

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::array;
use core::ops::{ControlFlow, Range};

pub use agreement::Agreement;
pub use rounds::Progress;
pub use samples::Samples;
pub use statistics::{Estimate, Statistics};
pub use stream::{ExtremeSample, Stream};
pub use study::Study;

use block::{BLOCK, mechanisms_in};
use block_evaluator::{ByColumns, ByMechanisms};
use draw::Draw;
use origin::{Measured, Source};
use rounds::rounds;

use study::evaluated;

use super::{Distribution, ToleranceError, Tolerances, Uncertainties};
use linkage_runtime::Dimensions;

/// A study by random sampling: mechanisms whose dimensions are drawn within their tolerances,
/// independently or [correlated](Self::run_correlated), each evaluated in full.
///
/// | to | call |
/// |---|---|
/// | keep every value, for exact percentiles: 16 bytes for each mechanism and number | [`run`](Self::run) |
/// | evaluate any number of mechanisms in constant memory | [`stream`](Self::stream) |
/// | look at the results meanwhile, stop, and go on | [`start`](Self::start) |
/// | divide a study among processes | [`part`](Self::part), [`Stream::merge`] |
///
/// Equal seeds give equal mechanisms, to the last bit, on any number of threads, in any parts and
/// on any machine: each random number is a function of the seed, the parameter and the number of
/// the mechanism.
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
    measured: Vec<(usize, Vec<f64>)>,
    part: [u64; 2],
    progress: Option<Box<dyn FnMut(Progress) + 'a>>,
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
            measured: Vec::new(),
            part: [0, 1],
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

    /// Deviations from the nominal value that were measured of the parameter with this index, in its
    /// unit: values are drawn from between them, evenly from one to the next. They replace
    /// tolerance and distribution; [`Samples::agreement`] needs the tolerance.
    #[must_use]
    pub fn measured(mut self, index: usize, deviations: &[f64]) -> Self {
        self.measured.push((index, deviations.to_vec()));
        self
    }

    /// Part `part` of `of`, counted from 0: some of the mechanisms, nearly as many as each other
    /// part has.
    #[must_use]
    pub fn part(mut self, part: u64, of: u64) -> Self {
        self.part = [part, of];
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
    /// not there, `Measurement` for measured deviations that are not finite, `NoSuchPart`.
    pub fn run<M, const N: usize, const K: usize>(
        self,
        nominal: &M,
        tolerances: &Tolerances<N>,
        evaluate: impl Fn(&[M], [&mut [f64]; K]) + Sync,
    ) -> Result<Samples<N, K>, ToleranceError>
    where
        M: Dimensions<N>,
    {
        let draw = self.independent(nominal.values(), tolerances)?;
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
        M: Dimensions<N>,
    {
        let draw = self.correlated(nominal, uncertainties)?;
        self.sample(&draw, evaluate)
    }

    /// Draws and evaluates the mechanisms as [`run`](Self::run) does, and keeps no value: sums,
    /// extremes and histograms take a few megabytes for any number of mechanisms.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run).
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
    /// // Each part in a process of its own.
    /// let part = |part: u64| {
    ///     let study = MonteCarlo::new(100_000).seed(7).part(part, 3);
    ///     study.stream(&Rod { length: 40.0 }, &tolerances, |rods, [squares]| {
    ///         for (rod, square) in rods.iter().zip(squares) {
    ///             *square = rod.length * rod.length;
    ///         }
    ///     })
    /// };
    /// let mut results = part(2)?;
    /// results.merge(&part(0)?)?;
    /// results.merge(&part(1)?)?;
    /// assert_eq!(results.done(), 100_000);
    /// assert!((results.statistics(0).mean.value - 1600.0).abs() < 0.02);
    /// let [shortest, longest] = results.extremes(0).expect("there are values");
    /// assert_eq!(longest.value, longest.dimensions[0].powi(2));
    /// # Ok::<(), linkage_analysis::tolerance::ToleranceError>(())
    /// ```
    pub fn stream<M, const N: usize, const K: usize>(
        self,
        nominal: &M,
        tolerances: &Tolerances<N>,
        evaluate: impl Fn(&[M], [&mut [f64]; K]) + Sync + 'a,
    ) -> Result<Stream<N, K>, ToleranceError>
    where
        M: Dimensions<N> + 'a,
    {
        Ok(self.start(nominal, tolerances, evaluate)?.finish())
    }

    /// A study to be continued step by step, as [`stream`](Self::stream) does it at once. It begins
    /// with the first 4096 mechanisms, whose values set the bins of the histogram.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run).
    pub fn start<M, const N: usize, const K: usize>(
        self,
        nominal: &M,
        tolerances: &Tolerances<N>,
        evaluate: impl Fn(&[M], [&mut [f64]; K]) + Sync + 'a,
    ) -> Result<Study<'a, N, K>, ToleranceError>
    where
        M: Dimensions<N> + 'a,
    {
        let draw = self.independent(nominal.values(), tolerances)?;
        self.begin(draw, evaluate)
    }

    /// Works as [`start`](Self::start), with the distributions and correlations of `uncertainties`
    /// instead of those of the study.
    ///
    /// # Errors
    ///
    /// As [`run_correlated`](Self::run_correlated).
    pub fn start_correlated<M, const N: usize, const K: usize>(
        self,
        nominal: &M,
        uncertainties: &Uncertainties<N>,
        evaluate: impl Fn(&[M], [&mut [f64]; K]) + Sync + 'a,
    ) -> Result<Study<'a, N, K>, ToleranceError>
    where
        M: Dimensions<N> + 'a,
    {
        let draw = self.correlated(nominal, uncertainties)?;
        self.begin(draw, evaluate)
    }

    /// Works as [`start`](Self::start) for mechanisms without a type, as those that are compiled at
    /// run time: `evaluate` gets a slice for each dimension, with a number for each mechanism.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run).
    pub fn start_columns<const N: usize, const K: usize>(
        self,
        nominal: &[f64; N],
        tolerances: &Tolerances<N>,
        evaluate: impl Fn([&[f64]; N], [&mut [f64]; K]) + Sync + 'a,
    ) -> Result<Study<'a, N, K>, ToleranceError> {
        let draw = self.independent(*nominal, tolerances)?;
        let blocks = self.blocks()?;
        let (count, progress) = (self.count as u64, self.progress);
        let evaluator = ByColumns(evaluate);
        Ok(Study::new(count, draw, blocks, progress, evaluator))
    }

    fn begin<M, const N: usize, const K: usize>(
        self,
        draw: Draw<N>,
        evaluate: impl Fn(&[M], [&mut [f64]; K]) + Sync + 'a,
    ) -> Result<Study<'a, N, K>, ToleranceError>
    where
        M: Dimensions<N> + 'a,
    {
        let blocks = self.blocks()?;
        let (count, progress) = (self.count as u64, self.progress);
        let evaluator = ByMechanisms::new(evaluate);
        Ok(Study::new(count, draw, blocks, progress, evaluator))
    }

    /// Evaluates the mechanisms and keeps all values.
    fn sample<M, const N: usize, const K: usize>(
        mut self,
        draw: &Draw<N>,
        evaluate: impl Fn(&[M], [&mut [f64]; K]) + Sync,
    ) -> Result<Samples<N, K>, ToleranceError>
    where
        M: Dimensions<N>,
    {
        let count = self.count as u64;
        let evaluator = ByMechanisms::new(evaluate);
        let work = |blocks: Range<u64>| {
            let mut values: [Vec<f64>; K] = array::from_fn(|_| Vec::new());
            evaluated(draw, count, blocks, &evaluator, |_, columns| {
                for (values, column) in values.iter_mut().zip(columns) {
                    values.extend_from_slice(column);
                }
            });
            values
        };
        let mut columns: [Vec<f64>; K] = array::from_fn(|_| Vec::new());
        let blocks = self.blocks()?;
        let all = mechanisms_in(&blocks, count) as usize;
        rounds(blocks, work, |parts| {
            for (k, part) in parts.into_iter().flat_map(|part| (0..K).zip(part)) {
                columns[k].extend_from_slice(&part);
            }
            if let Some(report) = &mut self.progress {
                report(Progress {
                    done: columns.first().map_or(0, Vec::len),
                    count: all,
                });
            }
            ControlFlow::Continue(())
        });
        Ok(Samples::new(columns, draw.deviations()))
    }

    /// Dimensions that are drawn independently.
    fn independent<const N: usize>(
        &self,
        nominal: [f64; N],
        tolerances: &Tolerances<N>,
    ) -> Result<Draw<N>, ToleranceError> {
        let mut sources = array::from_fn(|_| Source::Distribution(self.distribution));
        let exceptions = self.exceptions.iter();
        for &(index, distribution) in exceptions {
            *entry(&mut sources, index)? = Source::Distribution(distribution);
        }
        for (index, deviations) in &self.measured {
            *entry(&mut sources, *index)? = Source::Measured(Measured::new(*index, deviations)?);
        }
        Ok(Draw {
            seed: self.seed,
            nominal,
            middles: *tolerances.middles(),
            tolerances: tolerances.values(),
            sources,
            root: None,
        })
    }

    /// Dimensions by their distributions and correlations.
    fn correlated<M: Dimensions<N>, const N: usize>(
        &self,
        nominal: &M,
        uncertainties: &Uncertainties<N>,
    ) -> Result<Draw<N>, ToleranceError> {
        uncertainties.all_correlated_are_normal()?;
        let tolerances = uncertainties.tolerances();
        Ok(Draw {
            seed: self.seed,
            nominal: nominal.values(),
            middles: *tolerances.middles(),
            tolerances: tolerances.values(),
            sources: uncertainties.distributions().map(Source::Distribution),
            root: Some(*uncertainties.root()),
        })
    }

    /// The blocks of the part.
    fn blocks(&self) -> Result<Range<u64>, ToleranceError> {
        let [part, of] = self.part;
        if part >= of {
            return Err(ToleranceError::NoSuchPart { part, of });
        }
        if self.count == 0 {
            return Err(ToleranceError::Nothing {
                what: "no mechanisms",
            });
        }
        let blocks = self.count.div_ceil(BLOCK) as u128;
        let [begin, end] =
            [part, part + 1].map(|k| (blocks * u128::from(k) / u128::from(of)) as u64);
        Ok(begin..end)
    }
}

fn entry<const N: usize>(
    sources: &mut [Source; N],
    index: usize,
) -> Result<&mut Source, ToleranceError> {
    let entry = sources.get_mut(index);
    entry.ok_or(ToleranceError::NoSuchParameter { index, count: N })
}
