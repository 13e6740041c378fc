//! Rows that are distances: a vector and the length that it should have.

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Node, V3, Vector};

use crate::algebra::names::Names;
use crate::structure::equations;
use crate::structure::equations::Coordinate;

/// A row `|vector| = length`.
pub(crate) struct Distance<'m> {
    pub(crate) vector: Vec<Ex<'m>>,
    pub(crate) length: Ex<'m>,
}

/// Two sides of an equation: one that measures a distance, and a known one.
#[derive(Clone, Copy)]
pub(crate) struct Sides<'m> {
    pub(crate) measured: Ex<'m>,
    pub(crate) given: Ex<'m>,
}

/// A row `|v| - l` or `v . v - l^2` (or its negative) with a known `l`.
pub(crate) fn distance<'m>(
    names: &Names<'m>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<Distance<'m>> {
    measured(names, row, coordinates).or_else(|| written_squares(names, row, coordinates))
}

/// A length or its square on one side, known numbers on the other.
fn measured<'m>(
    names: &Names<'m>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<Distance<'m>> {
    let mut sides = Sides {
        measured: row,
        given: names.zero(),
    };
    loop {
        // Squares of known values may belong to the vector: one term after the other.
        sides = without_term(names, sides, coordinates)?;
        let Sides { measured, given } = without_factors(names, sides, coordinates);
        let graph = names.graph;
        let lift = |vector: Vec<_>| vector.into_iter().map(|id| graph.ex(id)).collect();
        if let Some(vector) = graph.vector_of_length(measured.id()) {
            // No distance is negative.
            let length = given.select(given, given.number(f64::NAN));
            let vector = lift(vector);
            return Some(Distance { vector, length });
        }
        if let Some(vector) = graph.vector_of_square(measured.id()) {
            let length = given.sqrt();
            let vector = lift(vector);
            return Some(Distance { vector, length });
        }
    }
}

/// Both sides less a known term of the first.
pub(crate) fn without_term<'m>(
    names: &Names<'m>,
    Sides { measured, given }: Sides<'m>,
    coordinates: &[Coordinate],
) -> Option<Sides<'m>> {
    let ex = |id| measured.graph().ex(id);
    let sides = |measured, given| Some(Sides { measured, given });
    if let Node::Unary(Unary::Neg, a) = measured.node() {
        return sides(ex(a), -given);
    }
    let Node::Binary(op, a, b) = measured.node() else {
        return None;
    };
    let [a, b] = [a, b].map(ex);
    let known = |x| !coordinates.iter().any(|c| equations::contains(names, x, c));
    match (op, known(a), known(b)) {
        (Binary::Add, _, true) => sides(a, given - b),
        (Binary::Add, true, _) => sides(b, given - a),
        (Binary::Sub, _, true) => sides(a, given + b),
        (Binary::Sub, true, _) => sides(b, a - given),
        _ => None,
    }
}

/// Both sides divided by the known factors of the first.
fn without_factors<'m>(
    names: &Names<'m>,
    Sides {
        mut measured,
        mut given,
    }: Sides<'m>,
    coordinates: &[Coordinate],
) -> Sides<'m> {
    loop {
        let Node::Binary(op, a, b) = measured.node() else {
            return Sides { measured, given };
        };
        let [a, b] = [a, b].map(|id| measured.graph().ex(id));
        let known = |x| !coordinates.iter().any(|c| equations::contains(names, x, c));
        match op {
            Binary::Div if known(b) => {
                measured = a;
                given = given * b;
            }
            Binary::Mul if a != b && (known(a) || known(b)) => {
                let (factor, rest) = if known(a) { (a, b) } else { (b, a) };
                measured = rest;
                given = given / factor;
            }
            _ => return Sides { measured, given },
        }
    }
}

/// `x x + y y - ...` or `x x + y y + z z - ...` with a known rest.
fn written_squares<'m>(
    names: &Names<'m>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<Distance<'m>> {
    let unknown = |x| coordinates.iter().any(|c| equations::contains(names, x, c));
    let terms = summands(row);
    let sign = terms.iter().find(|(_, x)| unknown(*x))?.0;
    let mut vector = Vec::new();
    let mut wanted = names.zero();
    for (added, term) in terms {
        match term.node() {
            Node::Binary(Binary::Mul, a, b) if a == b && added == sign => {
                vector.push(term.graph().ex(a));
            }
            _ if unknown(term) => return None,
            _ if added == sign => wanted -= term,
            _ => wanted += term,
        }
    }
    let length = wanted.sqrt();
    matches!(vector.len(), 2 | 3).then_some(Distance { vector, length })
}

/// A row that is a distance in space.
pub(crate) fn space_distance<'m>(
    names: &Names<'m>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<(V3<'m>, Ex<'m>)> {
    let Distance { vector, length } = distance(names, row, coordinates)?;
    let vector = vector.try_into().ok()?;
    Some((Vector(vector), length))
}

/// The terms of a sum; false for those that are subtracted.
fn summands(sum: Ex) -> Vec<(bool, Ex)> {
    let ex = |id| sum.graph().ex(id);
    let mut found = Vec::new();
    let mut open = vec![(true, sum)];
    while let Some((sign, x)) = open.pop() {
        match x.node() {
            Node::Unary(Unary::Neg, a) => open.push((!sign, ex(a))),
            Node::Binary(Binary::Add, a, b) => open.extend([(sign, ex(b)), (sign, ex(a))]),
            Node::Binary(Binary::Sub, a, b) => open.extend([(!sign, ex(b)), (sign, ex(a))]),
            _ => found.push((sign, x)),
        }
    }
    found
}
