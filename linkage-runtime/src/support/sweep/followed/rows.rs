//! Rows in memory as arguments of a kernel.

use crate::support::sweep::arguments::Arguments;
use linkage_core::Scalar;

/// Rows as they are.
pub(super) struct Rows<'a, T, const I: usize>(pub(super) &'a [[T; I]]);

impl<T: Scalar, const I: usize> Arguments<T, I> for Rows<'_, T, I> {
    fn check(&self) -> usize {
        self.0.len()
    }

    #[inline(always)]
    fn block<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        start: usize,
        rows: usize,
        block: &mut [[T; B]; I],
    ) {
        for lane in 0..rows.min(B) {
            let row = &self.0[(start + lane).min(self.0.len() - 1)];
            for (column, value) in block.iter_mut().zip(row) {
                column[lane] = *value;
            }
        }
    }
}
