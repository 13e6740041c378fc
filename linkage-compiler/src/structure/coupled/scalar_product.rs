//! Recognising rows that are scalar products: a slide whose direction a body carries, a guide
//! across it.

use linkage_symbolic::{Ex, V3};

use crate::algebra::context::Algebra;
use crate::structure::distance;
use crate::structure::distance::Sides;
use crate::structure::equations::Coordinate;

/// The factors of a row `v . w - c` (or its negative) with a known `c`.
pub(crate) fn scalar_product<'m>(
    algebra: &Algebra<'m>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<[V3<'m>; 2]> {
    let mut sides = Sides {
        measured: row,
        given: algebra.zero(),
    };
    loop {
        let graph = algebra.graph;
        if let Some(factors) = graph.factors_of_product(sides.measured.id()) {
            return Some(factors);
        }
        sides = distance::without_term(algebra, sides, coordinates)?;
    }
}
