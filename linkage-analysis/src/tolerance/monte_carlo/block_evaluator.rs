//! Evaluation of drawn mechanisms: as objects, or as columns of their dimensions.

use alloc::vec::Vec;
use core::marker::PhantomData;

use super::draw::Columns;
use linkage_runtime::Dimensions;

/// Computes `K` numbers of mechanisms with `N` dimensions.
pub(super) trait Evaluator<const N: usize, const K: usize>: Sync {
    /// Memory that is used from block to block.
    type Memory: Default;

    /// Fills the numbers of the first mechanisms of a block, as many as the slices have room for.
    fn fill(&self, memory: &mut Self::Memory, block: &Columns<N>, numbers: [&mut [f64]; K]);
}

/// Evaluates objects.
pub(super) struct ByMechanisms<F, M> {
    evaluate: F,
    of: PhantomData<fn() -> M>,
}

impl<F, M> ByMechanisms<F, M> {
    pub(super) fn new<const K: usize>(evaluate: F) -> Self
    where
        F: Fn(&[M], [&mut [f64]; K]),
    {
        Self {
            evaluate,
            of: PhantomData,
        }
    }
}

impl<F, M, const N: usize, const K: usize> Evaluator<N, K> for ByMechanisms<F, M>
where
    F: Fn(&[M], [&mut [f64]; K]) + Sync,
    M: Dimensions<N>,
{
    type Memory = Vec<M>;

    fn fill(&self, mechanisms: &mut Vec<M>, block: &Columns<N>, numbers: [&mut [f64]; K]) {
        let length = numbers.first().map_or(0, |numbers| numbers.len());
        block.mechanisms(length, mechanisms);
        (self.evaluate)(mechanisms, numbers);
    }
}

/// Evaluates columns of dimensions.
pub(super) struct ByColumns<F>(pub(super) F);

impl<F, const N: usize, const K: usize> Evaluator<N, K> for ByColumns<F>
where
    F: Fn([&[f64]; N], [&mut [f64]; K]) + Sync,
{
    type Memory = ();

    fn fill(&self, (): &mut (), block: &Columns<N>, numbers: [&mut [f64]; K]) {
        let length = numbers.first().map_or(0, |numbers| numbers.len());
        (self.0)(block.slices(length), numbers);
    }
}
