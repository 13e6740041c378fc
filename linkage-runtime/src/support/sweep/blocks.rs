//! Blocks of rows, as the loops of a kernel use them.

use linkage_core::Scalar;

/// The number of rows of the columns.
#[inline(always)]
pub(super) fn rows<T, const W: usize>(columns: &[&mut [T]; W]) -> usize {
    columns.first().map_or(0, |column| column.len())
}

/// The number of vectors of `V` rows in the next block, if `left` of `count` rows remain: at least
/// one, and at most `B` rows. The last block may repeat rows that are done already.
#[inline(always)]
pub(super) fn next_vectors<const V: usize, const B: usize>(left: usize, count: usize) -> usize {
    let (vectors, most) = (left.div_ceil(V), B / V);
    // A block of one vector takes as long as one of two: every operation waits for the one before.
    // So the last two blocks share.
    let shared = if vectors > most && vectors < 2 * most {
        vectors.div_ceil(2)
    } else {
        vectors
    };
    shared.min(count / V).clamp(1, most)
}

/// Fewer rows than a vector has: `evaluate` fills `V`, the first go into the columns.
pub(super) fn few<T: Scalar, const V: usize, const W: usize>(
    columns: [&mut [T]; W],
    evaluate: impl FnOnce([&mut [T]; W]),
) {
    let mut block = [[T::from_f64(0.0); V]; W];
    evaluate(block.each_mut().map(|column| &mut column[..]));
    for (column, values) in columns.into_iter().zip(&block) {
        column.copy_from_slice(&values[..column.len()]);
    }
}
