//! The kernels of a function from its stages: over inputs, and over mechanisms with inputs.

mod block_stages;
mod cores;
mod set_stages;

use core::marker::PhantomData;

use linkage_core::Scalar;

use super::arguments::Arguments;
use super::blocks::next_vectors;
use super::destination::Destination;
use super::kernel::Kernel;
use crate::support::assembling::{Compiled, CoreOf};
use crate::support::stages::{Block, Memory, StageData, Staged};
use block_stages::BlockStages;
use cores::{Cores, OneCore, SetCores};

pub use set_stages::{SetStages, columns_of};

/// The kernel over inputs of the function `F`.
#[derive(Debug)]
pub struct OverInputs<'a, C, F>(&'a C, PhantomData<fn() -> F>);

impl<'a, C, F> OverInputs<'a, C, F> {
    /// For an assembly with the data `core`.
    pub fn new(core: &'a C) -> Self {
        Self(core, PhantomData)
    }
}

impl<T, C, F, const N: usize, const W: usize> Kernel<T, N, W> for OverInputs<'_, C, F>
where
    T: Scalar,
    C: StageData<T> + Copy,
    F: Staged<T, C, N, W>,
{
    const WIDE: bool = F::WIDE;

    #[inline(always)]
    fn evaluate<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        arguments: &impl Arguments<T, N>,
        first: usize,
        columns: [&mut [T]; W],
    ) {
        over_blocks::<F, _, _, _, FUSED, V, B, N, N, W, 0>(
            self.0, OneCore, arguments, first, columns,
        );
    }
}

/// The kernel over mechanisms of the function `F`: rows of `P` dimensions and `N` arguments.
pub(super) struct OverSets<'a, D: Compiled, F, const P: usize, const N: usize, const Q: usize>(
    &'a CoreOf<D>,
    PhantomData<fn() -> F>,
);

impl<'a, D: Compiled, F, const P: usize, const N: usize, const Q: usize>
    OverSets<'a, D, F, P, N, Q>
{
    /// For mechanisms assembled as the one with the data `core`.
    pub(super) fn new(core: &'a CoreOf<D>) -> Self {
        Self(core, PhantomData)
    }
}

impl<T, D, F, const P: usize, const N: usize, const Q: usize, const R: usize, const W: usize>
    Kernel<T, R, W> for OverSets<'_, D, F, P, N, Q>
where
    T: Scalar,
    D: Compiled<Scalar = T>,
    CoreOf<D>: Copy,
    F: Staged<T, CoreOf<D>, N, W> + SetStages<D, P, Q, R>,
{
    const WIDE: bool = F::WIDE;

    #[inline(always)]
    fn evaluate<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        arguments: &impl Arguments<T, R>,
        first: usize,
        columns: [&mut [T]; W],
    ) {
        const { assert!(R == P + N, "dimensions and arguments") };
        let prepared = F::Prepared::<B>::filled(T::from_f64(0.0));
        let cores = SetCores::<_, D, F, P, Q>::new(prepared);
        over_blocks::<F, _, _, _, FUSED, V, B, N, R, W, P>(
            self.0, cores, arguments, first, columns,
        );
    }
}

/// Runs the stages of the function `F` over blocks of `B` rows, as many as the columns are long
/// from row `first` on. Its `N` arguments begin at number `FIRST` of the `R` numbers of a row.
#[inline(always)]
fn over_blocks<
    F,
    T,
    C,
    S,
    const FUSED: bool,
    const V: usize,
    const B: usize,
    const N: usize,
    const R: usize,
    const W: usize,
    const FIRST: usize,
>(
    core: &C,
    mut cores: S,
    arguments: &impl Arguments<T, R>,
    first: usize,
    columns: [&mut [T]; W],
) where
    T: Scalar,
    C: Copy,
    F: Staged<T, C, N, W>,
    S: Cores<T, C, B, R>,
{
    // Apart from the prepared numbers: with both in one value, the optimiser takes a write to these
    // for a change of the data, and reads them again.
    let core = *core;
    let zero = T::from_f64(0.0);
    let mut x = Block::<T, B, R>::filled(zero);
    let mut memory = F::Memory::<B>::filled(zero);
    let mut finished = Block::<T, V, W>::filled(zero);
    let mut columns = Destination::new(columns);
    let count = columns.rows();
    let mut done = 0;
    while done < count {
        let vectors = next_vectors::<V, B>(count - done, count);
        let row = done.min(count - vectors * V);
        arguments.block::<FUSED, V, B>(first + row, vectors * V, &mut x.0);
        cores.prepare::<FUSED>(&core, &x);
        F::run(&mut BlockStages::<_, _, _, _, FUSED, V, B, R, W, FIRST> {
            core: &core,
            cores: &cores,
            x: &x,
            memory: &mut memory,
            finished: &mut finished,
            columns: &mut columns,
            vectors,
            row,
        });
        done = row + vectors * V;
    }
}
