//! Arguments with others behind them that are computed from some of them, row by row.

use super::Arguments;
use crate::Scalar;
use core::hint::black_box;

/// Rows of `I` arguments that become longer: `extend` makes `S` further arguments from `J` of the row.
#[derive(Clone, Copy, Debug)]
pub struct Extended<A, F, const I: usize, const J: usize, const S: usize> {
    /// The rows.
    pub inner: A,
    /// The first of the arguments that the others are made from.
    pub first: usize,
    /// From these arguments to the further ones.
    pub extend: F,
}

impl<T, A, F, const I: usize, const J: usize, const S: usize, const N: usize> Arguments<T, N>
    for Extended<A, F, I, J, S>
where
    T: Scalar,
    A: Arguments<T, I>,
    F: Fn([T; J]) -> [T; S],
{
    fn check(&self) -> usize {
        const { assert!(N == I + S, "a row and what is added to it") };
        self.inner.check()
    }

    #[inline(always)]
    fn block<const B: usize>(&self, start: usize, block: &mut [[T; B]; N]) {
        let Some((inner, states)) = block.split_first_chunk_mut() else {
            return;
        };
        self.inner.block(start, inner);
        // Row by row, in vectors along a row: across rows, look-ups in tables would become slow gathers. The boxes keep
        // the optimiser from it.
        let mut rows = [[T::from_f64(0.0); S]; B];
        for (lane, row) in rows.iter_mut().enumerate() {
            let mut of = [T::from_f64(0.0); J];
            for (argument, column) in of.iter_mut().zip(&inner[self.first..]) {
                *argument = column[lane];
            }
            *row = (self.extend)(black_box(of));
        }
        let rows = black_box(&rows);
        for (index, column) in states.iter_mut().enumerate() {
            for (argument, row) in column.iter_mut().zip(rows) {
                *argument = row[index];
            }
        }
    }
}
