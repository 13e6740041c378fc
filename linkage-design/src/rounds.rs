//! Blocks of starts on all threads, in rounds after each of which progress is reported and the
//! search may end.

use core::ops::Range;
use std::time::{Duration, Instant};
use std::vec::Vec;

#[cfg(feature = "rayon")]
use rayon::prelude::*;

use super::parallel::threads;
use super::settings::{Progress, Report};

/// The duration of a round of blocks, after which the progress is reported.
const ROUND: Duration = Duration::from_millis(100);

/// Runs blocks of starts, with feature `rayon` on all threads. Returns the results of the blocks in
/// their order, and true if some were not begun because the search was to end: `ended` is asked
/// before each round, with the number of blocks that are done.
///
/// The result of a block depends on its starts alone, so that the number of threads and the length
/// of rounds do not matter. `least` is the value of the best of a block.
pub(crate) fn in_rounds<B: Send>(
    all: &[Range<usize>],
    ended: &dyn Fn(usize) -> bool,
    progress: &mut Option<Report<'_>>,
    run: impl Fn(Range<usize>) -> B + Send + Sync,
    least: impl Fn(&B) -> f64,
) -> (Vec<B>, bool) {
    let starts = |blocks: &[Range<usize>]| blocks.iter().map(ExactSizeIterator::len).sum();
    let (count, total) = (all.len(), starts(all));
    let (mut blocks, mut lowest) = (Vec::new(), f64::INFINITY);
    // A round of fewer blocks than threads would leave some of them idle.
    let least_round = threads();
    let mut round = least_round;
    while blocks.len() < count {
        if ended(blocks.len()) {
            return (blocks, true);
        }
        let started = Instant::now();
        let next = &all[blocks.len()..count.min(blocks.len() + round)];
        #[cfg(feature = "rayon")]
        let new: Vec<B> = next.par_iter().cloned().map(&run).collect();
        #[cfg(not(feature = "rayon"))]
        let new: Vec<B> = next.iter().cloned().map(&run).collect();
        lowest = new.iter().map(&least).fold(lowest, f64::min);
        blocks.extend(new);
        // Only the length of a round depends on time, and no start on the length of a round.
        let taken = started.elapsed();
        round = if taken < ROUND / 2 { 2 * round } else { round };
        round = if taken > ROUND * 2 {
            (round / 2).max(least_round)
        } else {
            round
        };
        if let Some(report) = progress {
            report(Progress {
                done: starts(&all[..blocks.len()]),
                count: total,
                least: lowest,
            });
        }
    }
    (blocks, false)
}
