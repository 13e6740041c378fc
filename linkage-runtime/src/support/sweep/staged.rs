//! The kernels of a function from its stages: over inputs, and over mechanisms with inputs.

use core::borrow::Borrow;
use core::marker::PhantomData;

use linkage_core::Scalar;

use super::arguments::Arguments;
use super::blocks::next_vectors;
use super::destination::Destination;
use super::kernel::Kernel;
use crate::support::assembling::{Compiled, CoreOf, RevolutionsOf};
use crate::support::assembly_data::Core;
use crate::support::stages::{
    Block, FinishedRows, Memory, RowNumbers, RowNumbersMut, RunStages, Stage, StageData, StageRow,
    Staged,
};

/// A function over mechanisms: the prepared numbers of each mechanism that the function uses.
///
/// A row has `P` dimensions: `Q` numbers with the arguments of the function after them, and `R`
/// with those of its program.
pub trait SetStages<M: Compiled, const P: usize, const Q: usize, const R: usize> {
    /// The prepared numbers of `B` rows.
    type Prepared<const B: usize>: Memory<M::Scalar>;

    /// The column of each prepared number of the mechanism by [`columns_of`] those that the
    /// function uses.
    const COLUMNS: &'static [usize];

    /// Prepares the mechanism of a row: the numbers that the function uses, or all.
    #[inline(always)]
    fn prepare<const FUSED: bool>(
        mechanism: &M,
        modes: &M::Modes,
        revolutions: &RevolutionsOf<M>,
        slots: &mut impl RowNumbersMut<M::Scalar>,
    ) {
        mechanism.prepare::<FUSED>(modes, revolutions, slots);
    }
}

/// No column.
const UNUSED: usize = usize::MAX;

/// The columns of `N` numbers, of which `used` have one, in this order.
#[must_use]
pub const fn columns_of<const N: usize>(used: &[usize]) -> [usize; N] {
    let mut columns = [UNUSED; N];
    let mut column = 0;
    while column < used.len() {
        columns[used[column]] = column;
        column += 1;
    }
    columns
}

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
        let cores = SetCores::<_, D, F, P, Q>(prepared, PhantomData);
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

/// Row `.1` of a block.
struct BlockLane<'a, M>(&'a M, usize);

impl<T, M: Memory<T>> RowNumbers<T> for BlockLane<'_, M> {
    #[inline(always)]
    fn number(&self, k: usize) -> T {
        self.0.number(k, self.1)
    }
}

/// Row `.2` of vector `.1` of a block.
struct VectorLane<'a, M, const V: usize>(&'a M, usize, usize);

impl<T, M: Memory<T>, const V: usize> RowNumbers<T> for VectorLane<'_, M, V> {
    #[inline(always)]
    fn number(&self, k: usize) -> T {
        self.0.number_in::<V>(k, self.1, self.2)
    }
}

/// The prepared numbers that the function `F` uses in a row: those of one assembly, or `memory`
/// with the columns of [`SetStages::COLUMNS`].
struct SetSlots<L, D, F, const P: usize, const Q: usize, const R: usize>(
    L,
    PhantomData<fn() -> (D, F)>,
);

impl<L, D, F, const P: usize, const Q: usize, const R: usize> RowNumbers<D::Scalar>
    for SetSlots<L, D, F, P, Q, R>
where
    L: RowNumbers<D::Scalar>,
    D: Compiled,
    F: SetStages<D, P, Q, R>,
{
    #[inline(always)]
    fn number(&self, k: usize) -> D::Scalar {
        self.0.number(F::COLUMNS[k])
    }
}

impl<M, D, F, const P: usize, const Q: usize, const R: usize> RowNumbersMut<D::Scalar>
    for SetSlots<BlockLaneMut<'_, M>, D, F, P, Q, R>
where
    M: Memory<D::Scalar>,
    D: Compiled,
    F: SetStages<D, P, Q, R>,
{
    #[inline(always)]
    fn put(&mut self, k: usize, value: D::Scalar) {
        let column = F::COLUMNS[k];
        if column != UNUSED {
            self.0.0.put(column, self.0.1, value);
        }
    }
}

/// Row `.1` of a block, to write to.
struct BlockLaneMut<'a, M>(&'a mut M, usize);

/// The data of the assembly of each row of a block, from those of the assembly that is swept.
trait Cores<T, C, const B: usize, const R: usize> {
    /// Prepares all rows of a block.
    fn prepare<const FUSED: bool>(&mut self, core: &C, x: &Block<T, B, R>);

    /// The data for row `lane` of a vector of `V` rows, and its prepared numbers: those of the data
    /// are not of that row.
    fn core_of<const V: usize>(
        &self,
        core: &C,
        x: &Block<T, B, R>,
        vector: usize,
        lane: usize,
    ) -> (impl Borrow<C>, impl RowNumbers<T>);
}

/// All rows are positions of one assembly.
struct OneCore;

/// The prepared numbers of an assembly.
struct OneSlots<'a, C>(&'a C);

impl<T: Copy, C: StageData<T>> RowNumbers<T> for OneSlots<'_, C> {
    #[inline(always)]
    fn number(&self, k: usize) -> T {
        self.0.prepared()[k]
    }
}

impl<T, C, const B: usize, const R: usize> Cores<T, C, B, R> for OneCore
where
    T: Copy,
    C: StageData<T>,
{
    #[inline(always)]
    fn prepare<const FUSED: bool>(&mut self, _: &C, _: &Block<T, B, R>) {}

    #[inline(always)]
    fn core_of<const V: usize>(
        &self,
        core: &C,
        _: &Block<T, B, R>,
        _: usize,
        _: usize,
    ) -> (impl Borrow<C>, impl RowNumbers<T>) {
        (core, OneSlots(core))
    }
}

/// Each row is another mechanism, with its prepared numbers.
struct SetCores<M, D, F, const P: usize, const Q: usize>(M, PhantomData<fn() -> (D, F)>);

impl<T, D, M, F, const P: usize, const Q: usize, const B: usize, const R: usize>
    Cores<T, CoreOf<D>, B, R> for SetCores<M, D, F, P, Q>
where
    T: Scalar,
    D: Compiled<Scalar = T>,
    M: Memory<T>,
    F: SetStages<D, P, Q, R>,
{
    // All rows of the block, also those that are not asked for: only a loop of a fixed length
    // becomes vectors of full width.
    #[inline(always)]
    fn prepare<const FUSED: bool>(&mut self, core: &CoreOf<D>, x: &Block<T, B, R>) {
        let mut lane = 0;
        while lane < B {
            let row = BlockLane(x, lane);
            let mechanism = core.dimensions.with_dimensions(|k| row.number(k));
            let lane_of = BlockLaneMut(&mut self.0, lane);
            let mut slots = SetSlots::<_, D, F, P, Q, R>(lane_of, PhantomData);
            F::prepare::<FUSED>(&mechanism, &core.modes, &core.revolutions, &mut slots);
            lane = lane.wrapping_add(1);
        }
    }

    #[inline(always)]
    fn core_of<const V: usize>(
        &self,
        core: &CoreOf<D>,
        x: &Block<T, B, R>,
        vector: usize,
        lane: usize,
    ) -> (impl Borrow<CoreOf<D>>, impl RowNumbers<T>) {
        let row = VectorLane::<_, V>(x, vector, lane);
        let core = Core {
            dimensions: core.dimensions.with_dimensions(|k| row.number(k)),
            modes: core.modes.clone(),
            revolutions: core.revolutions.clone(),
            prepared: core.prepared.clone(),
        };
        let slots = VectorLane::<_, V>(&self.0, vector, lane);
        (core, SetSlots::<_, D, F, P, Q, R>(slots, PhantomData))
    }
}

/// The stages over a block of `B` rows, `V` of them side by side. The arguments begin at number
/// `FIRST` of a row.
struct BlockStages<
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
    core: &'a C,
    cores: &'a S,
    x: &'a Block<T, B, R>,
    memory: &'a mut M,
    finished: &'a mut Block<T, V, W>,
    columns: &'a mut Destination<'c, T, W>,
    /// The number of vectors in the block.
    vectors: usize,
    /// The row of the columns at which the block begins.
    row: usize,
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
