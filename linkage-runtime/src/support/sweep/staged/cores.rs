//! The data of the assembly of each row of a block: those of one assembly, or of a mechanism for each row.

use core::borrow::Borrow;
use core::marker::PhantomData;

use linkage_core::Scalar;

use super::set_stages::{SetStages, UNUSED};
use crate::support::assembling::{Compiled, CoreOf};
use crate::support::assembly_data::Core;
use crate::support::stages::{Block, Memory, RowNumbers, RowNumbersMut, StageData};

/// The data of the assembly of each row of a block, from those of the assembly that is swept.
pub(super) trait Cores<T, C, const B: usize, const R: usize> {
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
pub(super) struct OneCore;

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
pub(super) struct SetCores<M, D, F, const P: usize, const Q: usize>(M, PhantomData<fn() -> (D, F)>);

impl<M, D, F, const P: usize, const Q: usize> SetCores<M, D, F, P, Q> {
    /// With room for the prepared numbers of the rows of a block.
    pub(super) fn new(memory: M) -> Self {
        Self(memory, PhantomData)
    }
}

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
