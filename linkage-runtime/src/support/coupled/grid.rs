//! Prepared states over several inputs, for every lane of a scalar.

use super::lanes::{by_lane, constants, put};
use alloc::vec::Vec;
use core::hint::black_box;
use linkage_core::Scalar;
use linkage_core::numeric::continuation::GridLookup;

/// The grid of a group: one for every lane, since each lane has dimensions of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct CoupledGrid<const I: usize, const S: usize, const N: usize> {
    first: GridLookup<I, S, N>,
    others: Vec<GridLookup<I, S, N>>,
}

impl<const I: usize, const S: usize, const N: usize> CoupledGrid<I, S, N> {
    /// The look-up of every lane, NaN where there is none.
    pub(super) fn new<T: Scalar>(lookup: impl Fn(usize) -> Option<GridLookup<I, S, N>>) -> Self {
        let lookup = |lane| lookup(lane).unwrap_or_else(GridLookup::nothing);
        Self {
            first: lookup(0),
            others: (1..T::LANES).map(lookup).collect(),
        }
    }

    /// The share of the ranges in which it serves: the least of all lanes.
    #[must_use]
    pub fn served(&self) -> f64 {
        let others = self.others.iter().map(GridLookup::served);
        others.fold(self.first.served(), f64::min)
    }

    /// The state near `x` and the floor, without derivatives. With `FUSED` only on machines with
    /// fused multiply-add.
    #[must_use]
    #[inline(always)]
    pub fn at<T: Scalar, const FUSED: bool>(&self, x: [T; I]) -> ([T; S], T) {
        // In memory at once, its numbers are computed as vectors: otherwise the optimiser takes
        // them apart and computes each alone.
        black_box(self.look_up::<T, FUSED>(x))
    }

    #[inline(always)]
    fn look_up<T: Scalar, const FUSED: bool>(&self, x: [T; I]) -> ([T; S], T) {
        if T::LANES == 1 {
            return constants(self.first.at_with::<FUSED>(x.map(|x| x.lane(0))));
        }
        by_lane::<T, S>(|lane| {
            let mut inputs = [0.0; I];
            for (input, x) in inputs.iter_mut().zip(x) {
                *input = x.lane(lane);
            }
            match lane {
                0 => self.first.at_with::<FUSED>(inputs),
                _ => self.others[lane - 1].at_with::<FUSED>(inputs),
            }
        })
    }

    /// Writes the results of [`at`](Self::at) for the first `vectors` times `V` rows of the inputs:
    /// the numbers of the state and then the floor, a column each.
    #[inline(always)]
    pub fn fill<T: Scalar, const FUSED: bool, const V: usize, const B: usize>(
        &self,
        x: [&[T; B]; I],
        vectors: usize,
        columns: &mut [[T; B]],
    ) {
        for first in (0..vectors).map(|vector| vector * V) {
            let nothing = ([T::from_f64(0.0); S], T::from_f64(0.0));
            let mut rows = [nothing; V];
            for (lane, row) in rows.iter_mut().enumerate() {
                // Across rows, look-ups would become gathers, which are slow: nothing is moved
                // across this.
                black_box(());
                let mut inputs = [T::from_f64(0.0); I];
                for (input, column) in inputs.iter_mut().zip(x) {
                    *input = column[first + lane];
                }
                *row = self.at::<T, FUSED>(inputs);
            }
            // A number that is read as soon as its vector is written waits for it.
            for (lane, row) in rows.into_iter().enumerate() {
                put(row, first + lane, columns);
            }
        }
    }
}
