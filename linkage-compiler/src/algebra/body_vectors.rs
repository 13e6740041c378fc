//! Vectors that a body carries: with coordinates of its own on a body that turns by `t`, a vector
//! `v` changes by `t x v`.
//!
//! By the derivatives of the body's directions it would take those of the third one, a product of
//! the others, too, and in second derivatives three times as many.

use linkage_symbolic::{Node, SymbolId, V3, Vector, numerically_equal, substitute};

use crate::algebra::names::{BodyVector, Names};
use crate::model::unknown_frames;

/// Notes that the body with two directions carries a vector.
pub(crate) fn note_body_vector<'m>(
    names: &mut Names<'m>,
    vector: V3<'m>,
    coordinates: V3<'m>,
    axes: [V3<'m>; 2],
) {
    for component in 0..3 {
        // Symbols are differentiated by their rules.
        let is_operation = !matches!(
            vector[component].node(),
            Node::Symbol(_) | Node::Constant(_)
        );
        if is_operation {
            let body_vector = BodyVector {
                axes,
                vector,
                component,
                coordinates,
            };
            names
                .body_vectors
                .insert(vector[component].id(), body_vector);
        }
    }
}

/// The components of a body's two directions, if they are symbols.
pub(crate) fn directions(axes: [V3<'_>; 2]) -> Option<[SymbolId; 6]> {
    let components = axes.iter().flat_map(|axis| axis.0);
    let symbols = components.map(|x| match x.node() {
        Node::Symbol(symbol) => Some(symbol),
        _ => None,
    });
    let symbols: Vec<SymbolId> = symbols.collect::<Option<_>>()?;
    symbols.try_into().ok()
}

/// The coordinates of a vector along both directions and their cross product; nothing if it is not
/// carried, since it changes otherwise as they turn.
pub(crate) fn coordinates<'m>(vector: V3<'m>, axes: [V3<'m>; 2]) -> Option<V3<'m>> {
    let seen = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0].map(|x| vector[0].number(x));
    let seen = directions(axes)?.into_iter().zip(seen).collect();
    let local: V3 = Vector(substitute(&vector.0, &seen).try_into().ok()?);
    let [first, second] = axes;
    let shown = local[0] * first + local[1] * second + local[2] * first.cross(second);
    let mut pairs = shown.0.into_iter().zip(vector.0);
    pairs
        .all(|(shown, component)| numerically_equal(shown, component))
        .then_some(local)
}

/// Notes that an unknown frame carries a vector, if it does.
pub(crate) fn note_if_on_body<'m>(names: &mut Names<'m>, v: V3<'m>) {
    if let Some((local, axes)) = coordinates_on_body(names, v) {
        note_body_vector(names, v, local, axes);
    }
}

/// The coordinates of a vector that one of the unknown frames carries as it is, if they are
/// dimensions, along two of its axes and across these.
pub(crate) fn coordinates_on_body<'m>(
    names: &Names<'m>,
    v: V3<'m>,
) -> Option<(V3<'m>, [V3<'m>; 2])> {
    let bodies = unknown_frames::bodies_of_space(names.mechanism).into_iter();
    let mut found = bodies.filter_map(|(_, parts)| {
        let axes = [parts[1], parts[2]].map(|axis| names.numbers_of(axis).try_into());
        let [Ok(first), Ok(second)] = axes else {
            return None;
        };
        let axes = [first, second].map(Vector);
        let local = coordinates(v, axes)?;
        local.is_fixed().then_some((local, axes))
    });
    found.next()
}
