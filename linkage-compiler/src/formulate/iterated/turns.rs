//! What the equations of a large core change by as its bodies turn.
//!
//! Where a body carries `arm`, a part of a vector, that changes by `turn x arm`. So `V . W` changes by `arm of V x what is not carried of W`, and
//! the same the other way round, for each turn; a link's `V . V/2` by `arm x V`. The nine components of directions would say the same with several
//! times the operations. What a row was written as proposes, and the values of its derivatives decide.

use linkage_symbolic::{Ex, Node, SymbolId, V3, Vector, agree, substitute};

use crate::algebra::{Bodies, Body, OnBody};
use crate::formulate::Solver;
use crate::structure::Block;

use super::equations::Equations;

/// A vector by what a body carries of it.
struct Parts<'m> {
    carried: V3<'m>,
    rest: V3<'m>,
}

impl<'m> Solver<'_, 'm> {
    /// The rows of the matrix that are no equations of bodies, by the freedoms.
    pub(super) fn freedoms(
        &self,
        equations: &Equations<'_, 'm>,
        bodies: &Bodies<'m>,
    ) -> Vec<Vec<Ex<'m>>> {
        let places = equations.places();
        let blocks = places.flat_map(|place| vec![place.block; equations.count(place)]);
        let blocks: Vec<&Block> = blocks.collect();
        let rows = bodies.rows.iter().map(|&row| {
            let entries = &equations.matrix[row];
            let others = bodies.columns.iter().map(|&k| entries[k]);
            let turns = bodies.all.iter().flat_map(|body| {
                let any = body.by_turns(entries);
                let proposed = proposals(equations, body, blocks[row]).into_iter();
                let mut same = proposed.filter(|own| same(*own, any));
                same.next().unwrap_or(any).0
            });
            others.chain(turns).collect()
        });
        rows.collect()
    }
}

/// What a row may change by as a body turns, from how it was written.
fn proposals<'m>(equations: &Equations<'_, 'm>, body: &Body<'m>, block: &Block<'m>) -> Vec<V3<'m>> {
    let scale = equations.row_scale(block);
    if let Some([v, w]) = block.product {
        let (Some(first), Some(second)) = (parts(body, v), parts(body, w)) else {
            return Vec::new();
        };
        let turns = first.carried.cross(second.rest) + second.carried.cross(first.rest);
        return vec![scale * turns, -(scale * turns)];
    }
    let Some(link) = &block.distance else {
        return Vec::new();
    };
    let own = of_square(body, link.vector);
    let turns = match &link.less {
        Some(less) => own
            .zip(of_square(body, less.vector))
            .map(|(own, less)| own - less),
        None => own,
    };
    let turns = turns.map(|turns| (scale / link.length) * turns);
    turns.into_iter().collect()
}

/// What half of the square of a vector changes by as a body turns, if the body carries a part of it as it is.
pub(super) fn of_square<'m>(body: &Body<'m>, vector: V3<'m>) -> Option<V3<'m>> {
    Some(parts(body, vector)?.carried.cross(vector))
}

/// Whether two ways to say what a row changes by say the same: then the shorter one is taken.
pub(super) fn same<'m>(proposed: V3<'m>, any: V3<'m>) -> bool {
    proposed
        .0
        .iter()
        .zip(any.0)
        .all(|(&own, any)| agree(own, any))
}

/// A vector of which one of the bodies carries a part.
pub(super) fn on_body<'m>(vector: V3<'m>, bodies: &[Body<'m>]) -> Option<OnBody<'m>> {
    let graph = vector[0].graph();
    let parts = bodies.iter().map(|body| parts(body, vector));
    let mut carried = parts.enumerate().filter_map(|(body, parts)| {
        let Parts { carried, rest } = parts?;
        (!carried.is_zero()).then_some((body, carried, rest))
    });
    let (body, arm, rest) = carried.next()?;
    let directions = symbols(&bodies[body]);
    let mut dimensions = graph.symbols_of(&arm.0.map(|x| x.id()));
    dimensions.retain(|symbol| !directions.contains(symbol));
    Some(OnBody {
        vector,
        body,
        arm,
        rest,
        dimensions,
    })
}

/// The components of a body's directions.
fn symbols(body: &Body) -> Vec<SymbolId> {
    let axes = body.axes.iter().flat_map(|axis| axis.0);
    let symbols = axes.filter_map(|x| match x.node() {
        Node::Symbol(symbol) => Some(symbol),
        _ => None,
    });
    symbols.collect()
}

fn parts<'m>(body: &Body<'m>, vector: V3<'m>) -> Option<Parts<'m>> {
    let graph = vector[0].graph();
    let without = |vector: V3<'m>, symbols: &[SymbolId]| {
        let zero = vector[0].number(0.0);
        let nothing = symbols.iter().map(|&symbol| (symbol, zero)).collect();
        let all = substitute(&vector.0, &nothing).try_into();
        all.ok().map(Vector)
    };
    let directions = symbols(body);
    let rest: V3 = without(vector, &directions)?;
    let difference = vector - rest;
    // What the difference does not depend on is not seen to cancel out, but may be anything.
    let mut carried = difference;
    for symbol in graph.symbols_of(&rest.0.map(|x| x.id())) {
        let other = without(carried, &[symbol])?;
        if same(other, carried) {
            carried = other;
        }
    }
    let count = |own: V3<'m>| {
        graph
            .reachable(
                &[vector.0, own.0]
                    .concat()
                    .iter()
                    .map(|x| x.id())
                    .collect::<Vec<_>>(),
            )
            .len()
    };
    let is_shorter = count(carried) <= count(difference);
    Some(Parts {
        carried: if is_shorter { carried } else { difference },
        rest,
    })
}
