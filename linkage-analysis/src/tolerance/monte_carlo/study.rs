//! A study that goes on step by step.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::array;
use core::ops::{ControlFlow, Range};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use super::block::{BLOCK, mechanisms_in};
use super::block_evaluator::Evaluator;
use super::draw::{Columns, Draw};
use super::rounds::{Progress, rounds};
use super::stream::Stream;

use crate::tolerance::ToleranceError;

/// Blocks whose values give centre and width of the bins: the first ones, for all parts of a study.
const PILOT: u64 = 4;

/// A study by random sampling that goes on step by step, so that its results can be looked at,
/// written and compared with a limit of time while it runs. [`MonteCarlo::start`] makes one.
///
/// ```
/// use linkage_analysis::tolerance::{MonteCarlo, Tolerances};
/// use linkage_runtime::{Dimensions, Parameter};
/// use std::time::Duration;
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
/// let lengths = |rods: &[Rod], [lengths]: [&mut [f64]; 1]| {
///     for (rod, length) in rods.iter().zip(lengths) {
///         *length = rod.length;
///     }
/// };
/// let mut study = MonteCarlo::new(300_000).start(&Rod { length: 40.0 }, &tolerances, lengths)?;
/// // Once a second, until all are done or the upper percentile is known well enough.
/// while !study.is_done() {
///     study.advance(Duration::from_secs(1));
///     let upper = study.results().percentile(0, 0.998_65, 0.95);
///     if upper.high - upper.low < 1e-5 {
///         break;
///     }
/// }
/// let upper = study.results().percentile(0, 0.998_65, 0.95);
/// assert!((upper.value - 40.03).abs() < 1e-3);
/// # Ok::<(), linkage_analysis::tolerance::ToleranceError>(())
/// ```
///
/// [`MonteCarlo::start`]: super::MonteCarlo::start
pub struct Study<'a, const N: usize, const K: usize> {
    results: Stream<N, K>,
    blocks: Range<u64>,
    evaluate: Box<Evaluate<'a, N, K>>,
    progress: Option<Box<dyn FnMut(Progress) + 'a>>,
}

/// Adds blocks of mechanisms behind those of a stream.
type Evaluate<'a, const N: usize, const K: usize> =
    dyn Fn(Range<u64>, &mut Stream<N, K>) + Sync + 'a;

impl<'a, const N: usize, const K: usize> Study<'a, N, K> {
    pub(super) fn new(
        count: u64,
        draw: Draw<N>,
        blocks: Range<u64>,
        progress: Option<Box<dyn FnMut(Progress) + 'a>>,
        evaluator: impl Evaluator<N, K> + 'a,
    ) -> Self {
        let mut pilot: [Vec<f64>; K] = array::from_fn(|_| Vec::new());
        let first = 0..PILOT.min(count.div_ceil(BLOCK as u64));
        evaluated(&draw, count, first, &evaluator, |_, columns| {
            for (pilot, column) in pilot.iter_mut().zip(columns) {
                pilot.extend_from_slice(column);
            }
        });
        let results = Stream::new(count, draw, pilot.each_ref().map(Vec::as_slice));
        let evaluate = move |blocks: Range<u64>, stream: &mut Stream<N, K>| {
            let draw = stream.draw().clone();
            evaluated(&draw, count, blocks, &evaluator, |block, columns| {
                stream.push(block, columns);
            });
        };
        Self {
            results,
            blocks,
            evaluate: Box::new(evaluate),
            progress,
        }
    }

    /// Evaluates more mechanisms on all threads of rayon's current pool, for about this time; it
    /// begins with the first that are missing.
    pub fn advance(&mut self, time: Duration) {
        let end = Instant::now().checked_add(time);
        let results = &mut self.results;
        for gap in results.gaps(self.blocks.clone()) {
            let before = progress_of(results, &self.blocks);
            // Each thread goes on with a part of an earlier round: bins take megabytes.
            let waiting = Mutex::new(Vec::new());
            let take = || waiting.lock().expect("no thread has failed").pop();
            let work = |blocks: Range<u64>| {
                let mut part = take().unwrap_or_else(|| results.empty());
                (self.evaluate)(blocks, &mut part);
                part
            };
            let mut is_over = false;
            rounds(gap, work, |parts| {
                let mut waiting = waiting.lock().expect("no thread has failed");
                waiting.extend(parts);
                if let Some(report) = &mut self.progress {
                    let added: u64 = waiting.iter().map(Stream::done).sum();
                    report(Progress {
                        done: before.done + added as usize,
                        ..before
                    });
                }
                is_over = end.is_some_and(|end| Instant::now() >= end);
                match is_over {
                    true => ControlFlow::Break(()),
                    false => ControlFlow::Continue(()),
                }
            });
            for part in waiting.into_inner().expect("no thread has failed") {
                results.merge(&part).expect("a part that was missing");
            }
            if is_over {
                return;
            }
        }
    }

    /// Adds results of the same study, from a file or from another process: their mechanisms are
    /// not evaluated again.
    ///
    /// # Errors
    ///
    /// As [`Stream::merge`].
    pub fn merge(&mut self, results: &Stream<N, K>) -> Result<(), ToleranceError> {
        self.results.merge(results)
    }

    /// True if all mechanisms of the study, or of its part, have been evaluated.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.results.gaps(self.blocks.clone()).is_empty()
    }

    /// The results up to now.
    #[must_use]
    pub const fn results(&self) -> &Stream<N, K> {
        &self.results
    }

    /// Evaluates all mechanisms that are missing, and returns the results.
    #[must_use]
    pub fn finish(mut self) -> Stream<N, K> {
        self.advance(Duration::MAX);
        self.results
    }
}

/// The progress of the study with these blocks.
fn progress_of<const N: usize, const K: usize>(
    results: &Stream<N, K>,
    blocks: &Range<u64>,
) -> Progress {
    let mechanisms = |blocks: &Range<u64>| mechanisms_in(blocks, results.count());
    let (all, gaps) = (mechanisms(blocks), results.gaps(blocks.clone()));
    Progress {
        done: (all - gaps.iter().map(mechanisms).sum::<u64>()) as usize,
        count: all as usize,
    }
}

/// Draws and evaluates blocks, one after the other.
pub(super) fn evaluated<const N: usize, const K: usize>(
    draw: &Draw<N>,
    count: u64,
    blocks: Range<u64>,
    evaluator: &impl Evaluator<N, K>,
    mut absorb: impl FnMut(u64, [&[f64]; K]),
) {
    let mut memory = Default::default();
    let mut dimensions = Columns::new();
    let mut columns: [Vec<f64>; K] = array::from_fn(|_| vec![f64::NAN; BLOCK]);
    for block in blocks {
        let length = (count - block * BLOCK as u64).min(BLOCK as u64) as usize;
        draw.block(block, &mut dimensions);
        for column in &mut columns {
            column[..length].fill(f64::NAN);
        }
        evaluator.fill(
            &mut memory,
            &dimensions,
            columns.each_mut().map(|column| &mut column[..length]),
        );
        absorb(block, columns.each_ref().map(|column| &column[..length]));
    }
}
