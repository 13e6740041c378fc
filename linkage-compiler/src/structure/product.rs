//! Recognising rows that are scalar products: a slide whose direction a body carries, a guide across it.

use linkage_symbolic::{Ex, V3};

use super::Analysis;
use super::equations::Coordinate;
use super::space::Sides;

impl<'m> Analysis<'_, 'm> {
    /// The factors of a row `v . w - c` (or its negative) with a known `c`.
    pub(super) fn product(
        &mut self,
        row: Ex<'m>,
        coordinates: &[Coordinate],
    ) -> Option<[V3<'m>; 2]> {
        let mut sides = Sides {
            measured: row,
            given: self.algebra.zero(),
        };
        loop {
            let graph = self.algebra.graph;
            if let Some(factors) = graph.factors_of_product(sides.measured.id()) {
                return Some(factors);
            }
            sides = self.without_term(sides, coordinates)?;
        }
    }
}
