//! Numbers of cells along the inputs, and their limits.

use super::super::cell::Frame;
use super::super::scale::Scale;
use alloc::vec::Vec;

/// Cells of a grid, at most.
pub(super) const CELLS: usize = 1 << 12;

/// The share of places on the borders of more cells at which the solution may be left out although
/// it exists: near its boundary it always is at some. A grid that leaves out more even away from
/// boundaries does not serve the declared ranges.
pub(super) const MISSED: f64 = 0.005;

/// The ranges in so many cells each.
pub(super) fn scales(ranges: &[(Frame, bool)], counts: &[u32]) -> Vec<Scale> {
    let pairs = ranges.iter().zip(counts);
    pairs
        .map(|((frame, closed), &count)| Scale::new(*frame, count, *closed))
        .collect()
}

/// The input along which the state bends most in a cell; of equal ones, the one that is divided
/// least. `None` if no range has a length.
pub(super) fn longest(bends: &[f64], counts: &[u32]) -> Option<usize> {
    let bend = |axis: usize| bends.get(axis).copied().unwrap_or_default();
    let ranges = (0..counts.len()).filter(|&axis| counts[axis] > 1);
    ranges.max_by(|&a, &b| {
        let most = bend(a).total_cmp(&bend(b));
        most.then(counts[b].cmp(&counts[a]))
    })
}
