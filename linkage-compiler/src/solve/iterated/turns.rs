//! What the equations of a large core change by as its bodies turn.
//!
//! Where a body carries `arm`, a part of a vector, that changes by `turn x arm`. So `V . W` changes by `arm of V x what is not carried of W`, and
//! the same the other way round, for each turn; a link's `V . V/2` by `arm x V`. The nine components of directions would say the same with several
//! times the operations. What a row was written as proposes, and the values of its derivatives decide.

use linkage_symbolic::{Ex, SymbolId, V3, Vector, numerically_equal, substitute};

use crate::algebra::{Bodies, Body, Carried, coordinates, directions};
use crate::solve::Solver;
use crate::structure::Block;

use super::equations::Equations;

/// A vector by what a body carries of it.
struct Parts<'m> {
    carried: V3<'m>,
    rest: V3<'m>,
}

/// The rows of the matrix that are no equations of bodies, by the freedoms.
pub(super) fn freedoms<'m>(
    _solver: &Solver<'_, 'm>,
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
        .all(|(&own, any)| numerically_equal(own, any))
}

/// What one of the bodies carries of a vector as it is.
pub(super) fn carried<'m>(vector: V3<'m>, bodies: &[Body<'m>]) -> Option<Carried<'m>> {
    let graph = vector[0].graph();
    let mut all = bodies.iter().enumerate().filter_map(|(index, body)| {
        let Parts { carried, rest } = parts(body, vector)?;
        // Of directions alone, but not as they are: a shadow, or a product with a fixed direction, turns otherwise.
        let own = coordinates(carried, body.axes)?;
        (!carried.is_zero()).then(|| Carried {
            body: index,
            arm: carried,
            rest,
            dimensions: graph.symbols_of(&own.0.map(Ex::id)),
        })
    });
    all.next()
}

fn parts<'m>(body: &Body<'m>, vector: V3<'m>) -> Option<Parts<'m>> {
    let rest = without(vector, &directions(body.axes)?)?;
    let difference = vector - rest;
    let carried = without_what_cancels(difference, rest)?;
    let is_shorter = nodes(vector, carried) <= nodes(vector, difference);
    Some(Parts {
        carried: if is_shorter { carried } else { difference },
        rest,
    })
}

/// A vector where some symbols are 0.
fn without<'m>(vector: V3<'m>, symbols: &[SymbolId]) -> Option<V3<'m>> {
    let zero = vector[0].number(0.0);
    let nothing = symbols.iter().map(|&symbol| (symbol, zero)).collect();
    let all = substitute(&vector.0, &nothing).try_into();
    all.ok().map(Vector)
}

/// The same difference, in which symbols of `rest` may still be written although they cancel: each is set to 0 if that changes no value.
fn without_what_cancels<'m>(mut difference: V3<'m>, rest: V3<'m>) -> Option<V3<'m>> {
    let graph = rest[0].graph();
    for symbol in graph.symbols_of(&rest.0.map(Ex::id)) {
        let other = without(difference, &[symbol])?;
        if same(other, difference) {
            difference = other;
        }
    }
    Some(difference)
}

/// How many nodes two vectors are made of.
fn nodes(a: V3, b: V3) -> usize {
    let roots = [a.0, b.0].concat().into_iter().map(Ex::id);
    a[0].graph().reachable(&roots.collect::<Vec<_>>()).len()
}
