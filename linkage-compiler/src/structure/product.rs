//! Recognising rows that are scalar products: a slide whose direction a body carries, a guide across it.

use crate::structure::space;
use linkage_symbolic::{Ex, V3};

use super::Analysis;
use super::equations::Coordinate;
use super::space::Sides;

/// The factors of a row `v . w - c` (or its negative) with a known `c`.
pub(super) fn product<'m>(
    analysis: &mut Analysis<'_, 'm>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<[V3<'m>; 2]> {
    let mut sides = Sides {
        measured: row,
        given: analysis.algebra.zero(),
    };
    loop {
        let graph = analysis.algebra.graph;
        if let Some(factors) = graph.factors_of_product(sides.measured.id()) {
            return Some(factors);
        }
        sides = space::without_term(analysis, sides, coordinates)?;
    }
}
