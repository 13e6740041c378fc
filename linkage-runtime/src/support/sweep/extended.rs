//! Arguments with the states of coupled groups after them.

use super::arguments::Arguments;
use linkage_core::Scalar;

/// Sources of the states of coupled groups: `S` numbers from `J` inputs.
pub trait States<T, const J: usize, const S: usize> {
    /// The states of the first `vectors` times `V` rows of the inputs. With `FUSED` only on
    /// machines with fused multiply-add.
    fn fill<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        inputs: &[[T; B]; J],
        vectors: usize,
        states: &mut [[T; B]; S],
    );
}

/// Rows of `I` arguments, `J` of them inputs, with `S` states after them.
#[derive(Clone, Copy, Debug)]
pub struct Extended<A, F, const I: usize, const J: usize, const S: usize> {
    /// The rows.
    pub inner: A,
    /// The first of the inputs among the arguments.
    pub first: usize,
    /// The function from inputs to states.
    pub states: F,
}

impl<T, A, F, const I: usize, const J: usize, const S: usize, const N: usize> Arguments<T, N>
    for Extended<A, F, I, J, S>
where
    T: Scalar,
    A: Arguments<T, I>,
    F: States<T, J, S>,
{
    fn check(&self) -> usize {
        const { assert!(N == I + S, "a row and its states") };
        self.inner.check()
    }

    #[inline(always)]
    fn block<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        start: usize,
        rows: usize,
        block: &mut [[T; B]; N],
    ) {
        let Some((inner, states)) = block.split_first_chunk_mut() else {
            return;
        };
        self.inner.block::<FUSED, V, B>(start, rows, inner);
        if let (Some(inputs), Some(states)) =
            (inner[self.first..].first_chunk(), states.first_chunk_mut())
        {
            self.states.fill::<FUSED, V, B>(inputs, rows / V, states);
        }
    }
}
