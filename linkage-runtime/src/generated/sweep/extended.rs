//! Arguments with the states of coupled groups behind them.

use super::Arguments;
use crate::Scalar;
use core::hint::black_box;

/// Where the states of coupled groups come from: `S` numbers from `J` inputs. It takes two steps: the first finds `P` numbers that say
/// where in the tables, and is vector code over many rows; the second looks up, in vectors along a row.
pub trait States<T, const J: usize, const P: usize, const S: usize> {
    /// Where the states of one row stand.
    fn locate(&self, inputs: [T; J]) -> [f64; P];

    /// The states there.
    fn at<const FUSED: bool>(&self, inputs: [T; J], places: [f64; P]) -> [T; S];

    /// Both steps, for scalars with several lanes.
    fn whole(&self, inputs: [T; J]) -> [T; S];
}

/// Rows of `I` arguments, `J` of them inputs, with `S` states behind them.
#[derive(Clone, Copy, Debug)]
pub struct Extended<A, F, const I: usize, const J: usize, const P: usize, const S: usize> {
    /// The rows.
    pub inner: A,
    /// The first of the inputs among the arguments.
    pub first: usize,
    /// From inputs to states.
    pub states: F,
}

impl<T, A, F, const I: usize, const J: usize, const P: usize, const S: usize, const N: usize>
    Arguments<T, N> for Extended<A, F, I, J, P, S>
where
    T: Scalar,
    A: Arguments<T, I>,
    F: States<T, J, P, S>,
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
        let inputs = &inner[self.first..];
        let mut places = [[0.0; B]; P];
        if T::VECTORISES {
            let mut first = 0;
            while first < rows {
                for lane in first..first + V {
                    let found = self.states.locate(row(inputs, lane));
                    for (column, place) in places.iter_mut().zip(found) {
                        column[lane] = place;
                    }
                }
                first += V;
            }
        }
        // Row by row: across rows, look-ups in tables would become slow gathers. The boxes keep the optimiser from it.
        let mut looked_up = [[T::from_f64(0.0); S]; B];
        for (lane, states) in looked_up.iter_mut().take(rows).enumerate() {
            let inputs = row(inputs, lane);
            *states = if T::VECTORISES {
                let places = black_box(row(&places, lane));
                self.states.at::<FUSED>(inputs, places)
            } else {
                self.states.whole(inputs)
            };
        }
        let looked_up = black_box(&looked_up);
        for (index, column) in states.iter_mut().enumerate() {
            for (argument, row) in column.iter_mut().zip(looked_up) {
                *argument = row[index];
            }
        }
    }
}

/// One row of columns.
#[inline(always)]
fn row<T: Scalar, const B: usize, const N: usize>(columns: &[[T; B]], lane: usize) -> [T; N] {
    let mut row = [T::from_f64(0.0); N];
    for (number, column) in row.iter_mut().zip(columns) {
        *number = column[lane];
    }
    row
}
