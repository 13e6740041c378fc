//! Blocks of mechanisms, computed in rounds on all threads.

use alloc::vec::Vec;
use core::ops::{ControlFlow, Range};
use std::time::{Duration, Instant};

use rayon::prelude::*;

/// Length of a round; the progress is reported after each.
const ROUND: Duration = Duration::from_millis(100);

/// The progress of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Mechanisms that have been evaluated.
    pub done: usize,
    /// All mechanisms of the study, or of its part.
    pub count: usize,
}

/// Computes the blocks by `work`, each thread some neighbours at once. After each round `absorb`
/// gets the results in their order, and may break off.
pub(super) fn rounds<R: Send>(
    blocks: Range<u64>,
    work: impl Fn(Range<u64>) -> R + Sync,
    mut absorb: impl FnMut(Vec<R>) -> ControlFlow<()>,
) {
    let threads = rayon::current_num_threads().max(1) as u64;
    let (mut next, mut each) = (blocks.start, 1);
    while next < blocks.end {
        let (started, end) = (Instant::now(), blocks.end.min(next + threads * each));
        let parts = (0..threads).map(|thread| {
            let [begin, end] = [thread, thread + 1].map(|k| end.min(next + k * each));
            begin..end
        });
        let parts: Vec<_> = parts.filter(|part| !part.is_empty()).collect();
        let results = parts.into_par_iter().map(&work).collect();
        next = end;
        if absorb(results).is_break() {
            return;
        }
        // Only the length of a round depends on time, and no sample on the length of a round.
        let taken = started.elapsed();
        if taken < ROUND / 2 {
            each *= 2;
        } else if taken > ROUND * 2 {
            each = (each / 2).max(1);
        }
    }
}
