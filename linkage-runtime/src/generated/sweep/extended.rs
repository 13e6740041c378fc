//! Arguments that are computed from others, row by row.

use super::Arguments;
use crate::Scalar;
use core::hint::black_box;

/// Rows of `I` arguments that become longer: `extend` makes the row that the kernel sees.
#[derive(Clone, Copy, Debug)]
pub struct Extended<A, F, const I: usize> {
    /// The rows.
    pub inner: A,
    /// From a row to the row of the kernel.
    pub extend: F,
}

impl<T, A, F, const I: usize, const N: usize> Arguments<T, N> for Extended<A, F, I>
where
    T: Scalar,
    A: Arguments<T, I>,
    F: Fn([T; I]) -> [T; N],
{
    fn check(&self) -> usize {
        self.inner.check()
    }

    #[inline(always)]
    fn block<const B: usize>(&self, start: usize, block: &mut [[T; B]; N]) {
        let mut inner = [[T::from_f64(0.0); B]; I];
        self.inner.block(start, &mut inner);
        // Row by row, in vectors along a row: across rows, look-ups in tables would become slow gathers. The boxes keep
        // the optimiser from it.
        let mut rows = [[T::from_f64(0.0); N]; B];
        for (lane, extended) in rows.iter_mut().enumerate() {
            let mut row = [T::from_f64(0.0); I];
            for (argument, column) in row.iter_mut().zip(&inner) {
                *argument = column[lane];
            }
            *extended = (self.extend)(black_box(row));
        }
        let rows = black_box(&rows);
        for (index, column) in block.iter_mut().enumerate() {
            for (argument, row) in column.iter_mut().zip(rows) {
                *argument = row[index];
            }
        }
    }
}
