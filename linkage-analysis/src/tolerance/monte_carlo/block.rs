//! Blocks of mechanisms.

use core::ops::Range;

/// Mechanisms that are drawn and evaluated together.
pub(super) const BLOCK: usize = 1024;
/// Those in half a block.
pub(super) const HALF: usize = BLOCK / 2;

/// The number of mechanisms in some blocks of a study of so many.
pub(super) fn mechanisms_in(blocks: &Range<u64>, count: u64) -> u64 {
    let [begin, end] = [blocks.start, blocks.end].map(|block| count.min(block * BLOCK as u64));
    end - begin
}
