//! Values that the loops' closed forms have already: arms of bodies and determinants.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, NodeId, Vn};

/// Arms, for each body and the point that the arm leads to.
pub(super) type Arms<'m> = Map<(usize, Vec<NodeId>), Vn<'m>>;

/// The determinants of blocks of equations.
pub(super) type Determinants<'m> = Map<Vec<usize>, Ex<'m>>;

/// Values that the closed forms compute.
#[derive(Clone, Debug, Default)]
pub(super) struct LoopValues<'m> {
    pub(super) arms: Arms<'m>,
    pub(super) determinants: Determinants<'m>,
}

impl<'m> LoopValues<'m> {
    pub(super) fn arm(&self, body: usize, point: Vn<'m>) -> Option<Vn<'m>> {
        self.arms.get(&(body, point.ids().to_vec())).copied()
    }

    pub(super) fn determinant(&self, block: &[usize]) -> Option<Ex<'m>> {
        self.determinants.get(block).copied()
    }
}
