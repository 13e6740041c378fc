//! Times of one run.

use linkage_peers::timing::only_tested;
use std::time::{Duration, Instant};

/// Returns the best time of a function in s, from runs of half a second.
pub(crate) fn best(mut run: impl FnMut()) -> f64 {
    let limit = Duration::from_millis(if only_tested() { 0 } else { 500 });
    let begin = Instant::now();
    let mut best = f64::INFINITY;
    loop {
        let start = Instant::now();
        run();
        best = best.min(start.elapsed().as_secs_f64());
        if begin.elapsed() >= limit {
            return best;
        }
    }
}
