//! What bodies carry as it is: vectors with coordinates of their own along a body's two directions and across these.

use linkage_symbolic::{Node, SymbolId, V3, Vector, numerically_equal, substitute};

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

/// The coordinates of a vector along both directions and their cross product; nothing if it is not carried, since it changes otherwise as they turn.
pub(crate) fn coordinates<'m>(vector: V3<'m>, axes: [V3<'m>; 2]) -> Option<V3<'m>> {
    let seen = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0].map(|x| vector[0].number(x));
    let seen = directions(axes)?.into_iter().zip(seen).collect();
    let own: V3 = Vector(substitute(&vector.0, &seen).try_into().ok()?);
    let [first, second] = axes;
    let shown = own[0] * first + own[1] * second + own[2] * first.cross(second);
    let mut pairs = shown.0.into_iter().zip(vector.0);
    pairs
        .all(|(shown, own)| numerically_equal(shown, own))
        .then_some(own)
}
