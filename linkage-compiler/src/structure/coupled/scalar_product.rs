//! Recognising rows that are scalar products: a slide whose direction a body carries, a guide
//! across it.

use linkage_symbolic::{Ex, V3};

use crate::algebra::names::Names;
use crate::structure::distance;
use crate::structure::distance::Sides;
use crate::structure::equations::Coordinate;

/// The factors of a row `v . w - c` (or its negative) with a known `c`.
pub(crate) fn scalar_product<'m>(
    names: &Names<'m>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<[V3<'m>; 2]> {
    let mut sides = Sides {
        measured: row,
        given: names.zero(),
    };
    loop {
        let graph = names.graph;
        if let Some(factors) = graph.factors_of_product(sides.measured.id()) {
            return Some(factors);
        }
        sides = distance::without_term(names, sides, coordinates)?;
    }
}
