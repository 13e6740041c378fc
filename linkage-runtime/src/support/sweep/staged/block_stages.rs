//! The stages over a block of rows.

use core::borrow::Borrow;

use super::cores::Cores;
use crate::support::stages::{Block, FinishedRows, Memory, RowNumbers, RunStages, Stage, StageRow};
use crate::support::sweep::destination::Destination;

/// The stages over a block of `B` rows, `V` of them side by side. The arguments begin at number
/// `FIRST` of a row.
pub(super) struct BlockStages<
    'a,
    'c,
    T,
    C,
    S,
    M,
    const FUSED: bool,
    const V: usize,
    const B: usize,
    const R: usize,
    const W: usize,
    const FIRST: usize,
> {
    pub(super) core: &'a C,
    pub(super) cores: &'a S,
    pub(super) x: &'a Block<T, B, R>,
    pub(super) memory: &'a mut M,
    pub(super) finished: &'a mut Block<T, V, W>,
    pub(super) columns: &'a mut Destination<'c, T, W>,
    /// The number of vectors in the block.
    pub(super) vectors: usize,
    /// The row of the columns at which the block begins.
    pub(super) row: usize,
}

impl<
    T,
    C,
    F,
    S,
    M,
    const FUSED: bool,
    const V: usize,
    const B: usize,
    const R: usize,
    const W: usize,
    const FIRST: usize,
> RunStages<T, C, F> for BlockStages<'_, '_, T, C, S, M, FUSED, V, B, R, W, FIRST>
where
    T: Copy,
    S: Cores<T, C, B, R>,
    M: Memory<T>,
{
    // The loop counts vectors and not rows, so that the optimiser knows that they fit. Wrapping
    // arithmetic, here and in rows: with a branch for overflow there would be no vectors.
    #[inline(always)]
    fn stage<const K: usize>(&mut self)
    where
        F: Stage<T, C, K>,
    {
        let vectors = self.vectors;
        let mut vector = 0;
        while vector < vectors {
            let mut lane = 0;
            while lane < V {
                let (core, slots) = self.cores.core_of::<V>(self.core, self.x, vector, lane);
                let mut row = BlockRow::<_, _, _, B, V, R, W, FIRST> {
                    x: self.x,
                    slots,
                    memory: self.memory,
                    finished: self.finished,
                    vector,
                    lane,
                };
                F::row::<FUSED, true>(core.borrow(), &mut row);
                lane = lane.wrapping_add(1);
            }
            F::write(&mut FinishedVector {
                finished: self.finished,
                columns: self.columns,
                row: self.row + vector * V,
            });
            vector = vector.wrapping_add(1);
        }
    }
}

/// Row `lane` of a vector of a block.
struct BlockRow<
    'a,
    T,
    S,
    M,
    const B: usize,
    const V: usize,
    const R: usize,
    const W: usize,
    const FIRST: usize,
> {
    x: &'a Block<T, B, R>,
    slots: S,
    memory: &'a mut M,
    finished: &'a mut Block<T, V, W>,
    vector: usize,
    lane: usize,
}

impl<T, S, M, const B: usize, const V: usize, const R: usize, const W: usize, const FIRST: usize>
    RowNumbers<T> for BlockRow<'_, T, S, M, B, V, R, W, FIRST>
where
    T: Copy,
{
    #[inline(always)]
    fn number(&self, k: usize) -> T {
        self.x
            .number_in::<V>(FIRST.wrapping_add(k), self.vector, self.lane)
    }
}

impl<T, S, M, const B: usize, const V: usize, const R: usize, const W: usize, const FIRST: usize>
    StageRow<T> for BlockRow<'_, T, S, M, B, V, R, W, FIRST>
where
    T: Copy,
    S: RowNumbers<T>,
    M: Memory<T>,
{
    #[inline(always)]
    fn prepared(&self, k: usize) -> T {
        self.slots.number(k)
    }

    #[inline(always)]
    fn kept(&self, k: usize) -> T {
        self.memory.number_in::<V>(k, self.vector, self.lane)
    }

    #[inline(always)]
    fn keep(&mut self, k: usize, value: T) {
        self.memory.put_in::<V>(k, self.vector, self.lane, value);
    }

    #[inline(always)]
    fn finish(&mut self, k: usize, value: T) {
        self.finished.put(k, self.lane, value);
    }
}

/// The finished results of `V` rows, and the columns from `row` on that they belong into.
struct FinishedVector<'a, 'c, T, const V: usize, const W: usize> {
    finished: &'a Block<T, V, W>,
    columns: &'a mut Destination<'c, T, W>,
    row: usize,
}

impl<T: Copy, const V: usize, const W: usize> FinishedRows for FinishedVector<'_, '_, T, V, W> {
    #[inline(always)]
    fn write(&mut self, k: usize) {
        self.columns.put(k, self.row, &self.finished.0[k]);
    }
}
