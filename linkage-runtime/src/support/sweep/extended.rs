//! Arguments with the states of coupled groups after them.

use core::marker::PhantomData;

use super::arguments::Arguments;
use crate::support::evaluation::States;
use linkage_core::Scalar;

/// Rows of `Q` numbers, the last `I` of them arguments of a function, with the states of `F` after
/// them.
#[derive(Debug)]
pub(super) struct Extended<'a, A, S, F, const Q: usize, const I: usize, const N: usize> {
    rows: A,
    initial: &'a S,
    states: PhantomData<fn() -> F>,
}

impl<'a, A, S, F, const Q: usize, const I: usize, const N: usize> Extended<'a, A, S, F, Q, I, N> {
    /// The states are looked up in the `initial` ones.
    #[inline(always)]
    pub(super) fn new(rows: A, initial: &'a S) -> Self {
        Self {
            rows,
            initial,
            states: PhantomData,
        }
    }
}

impl<T, A, S, F, const Q: usize, const I: usize, const N: usize, const R: usize> Arguments<T, R>
    for Extended<'_, A, S, F, Q, I, N>
where
    T: Scalar,
    A: Arguments<T, Q>,
    F: States<T, S, I, N>,
{
    fn check(&self) -> usize {
        const { assert!(R - Q == N - I && Q >= I, "a row and its states") };
        self.rows.check()
    }

    #[inline(always)]
    fn block<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        start: usize,
        rows: usize,
        block: &mut [[T; B]; R],
    ) {
        let Some((known, states)) = block.split_first_chunk_mut() else {
            return;
        };
        self.rows.block::<FUSED, V, B>(start, rows, known);
        if let Some(arguments) = known.last_chunk::<I>() {
            F::fill::<FUSED, V, B>(self.initial, arguments, rows / V, states);
        }
    }
}
