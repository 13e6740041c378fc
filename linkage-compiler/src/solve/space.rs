//! What closed forms in space share.

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Node, V3, Vector, numerically_equal_within};

use crate::algebra::{Rod, Term};

use super::Solver;

/// The terms `K.V - l l` of `(V.V - l^2)/2`, where `V` is the link's vector: what is known before the group enters by its
/// derivative times these factors.
pub(super) fn distance_terms<'m>(link: V3<'m>, known: V3<'m>, length: Ex<'m>) -> Vec<Term<'m>> {
    let minus = -length;
    let term = |(coefficient, factor): (Ex<'m>, Ex<'m>)| Term {
        coefficient: vec![coefficient],
        factor,
    };
    let components = known.components().zip(link.components());
    components.chain([(length, minus)]).map(term).collect()
}

/// Records the rod of the group that was recorded last.
pub(super) fn rod<'m>(solver: &mut Solver<'_, 'm>, rod: Rod<'m>) {
    let group = solver.algebra.solutions.groups.last_mut();
    group.expect("the group that is solved").rod = Some(rod);
}

/// The length of a vector, which is `rounded`, without a root where it is some number that the vector was made of: a rocker's length times a direction.
/// Beside the difference of two long links a root's rounding is too much.
pub(super) fn arm_length<'m>(arm: V3<'m>, rounded: Ex<'m>) -> Ex<'m> {
    /// What the squares of a direction's components are rounded by together; lengths that differ by less differ by rounding.
    const ROUNDING: f64 = 16.0 * f64::EPSILON;

    let square = arm.square();
    let graph = square.graph();
    let below = graph.reachable(&arm.ids()).into_iter();
    let mut known = below.map(|id| graph.ex(id)).filter(|x| x.is_fixed());
    let own = known.find(|x| numerically_equal_within(square, x.square(), ROUNDING));
    own.map_or(rounded, Ex::abs)
}

/// `e . v`. What is prepared of it, and what each further term is multiplied by, is put together beforehand: with a crank in `v` and a
/// fixed `e`, two multiply-adds remain.
pub(super) fn projection<'m>(e: V3<'m>, v: V3<'m>) -> Ex<'m> {
    if !e.is_fixed() {
        return e.dot(v);
    }
    let parts = v.0.map(early_and_late);
    let early = Vector(parts.map(|(early, _)| early));
    let late = parts.map(|(_, late)| late);
    let start = e.dot(early);
    let pairs = e.components().zip(late);
    pairs.fold(start, |sum, (e, late)| sum + e * late)
}

/// A sum in two parts: what is known before a call, and the rest.
fn early_and_late(sum: Ex) -> (Ex, Ex) {
    let zero = sum.number(0.0);
    if sum.is_fixed() {
        return (sum, zero);
    }
    let ex = |id| sum.graph().ex(id);
    let (op, a, b) = match sum.node() {
        Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => (op, ex(a), ex(b)),
        Node::Unary(Unary::Neg, a) => (Binary::Sub, zero, ex(a)),
        _ => return (zero, sum),
    };
    let (a, b) = (early_and_late(a), early_and_late(b));
    (a.0.binary(op, b.0), a.1.binary(op, b.1))
}
