//! What bodies carry changes as they turn: a vector `v` with coordinates of its own on a body that turns by `t` changes by `t x v`.
//!
//! By the derivatives of the body's directions it would take those of the third one, a product of the others, too, and in second derivatives three
//! times as many.

use crate::algebra::turns;
use linkage_symbolic::{Node, NodeId, SymbolId, V3};

use super::Algebra;
use super::implicit::Implicit;

/// A component of a vector that a body carries.
#[derive(Clone, Debug)]
pub(super) struct Aboard<'m> {
    /// The body's two directions.
    axes: [V3<'m>; 2],
    vector: V3<'m>,
    component: usize,
    /// Its coordinates on the body.
    coordinates: V3<'m>,
}

/// Notes that the body with two directions carries a vector.
pub(super) fn note_aboard<'m>(
    algebra: &mut Algebra<'m>,
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
            let own = Aboard {
                axes,
                vector,
                component,
                coordinates,
            };
            algebra.solutions.aboard.insert(vector[component].id(), own);
        }
    }
}

/// The derivative of a component of what a body carries, where it is known how the body turns.
pub(super) fn slope_aboard(
    algebra: &mut Algebra<'_>,
    node: NodeId,
    variable: SymbolId,
) -> Option<NodeId> {
    if algebra.derivatives.held > 0 {
        return None;
    }
    let own = algebra.solutions.aboard.get(&node)?.clone();
    algebra.derivatives.offered.turns = true;
    if !algebra.solutions.shortcuts.turns {
        return None;
    }
    let mut coordinates = own.coordinates.0.into_iter();
    if !coordinates.all(|x| algebra.slope(x, variable).is_zero()) {
        return None;
    }
    let turn = turns::turn_about(algebra, &own.axes, variable)?;
    Some(turn.cross(own.vector)[own.component].id())
}
