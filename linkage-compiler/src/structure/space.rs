//! Recognising groups in space: distances to a point that turns or slides, loops of three rows.

use crate::structure::classify;
use crate::structure::equations;
use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Node, SymbolId, V3, Vector, Vn, collect};

use super::eliminate::System;
use super::equations::{Coordinate, CoordinateKind, Equation};
use super::{Analysis, Form};

/// A row `|vector| = length`.
pub(super) struct Distance<'m> {
    pub(super) vector: Vec<Ex<'m>>,
    pub(super) length: Ex<'m>,
}

/// Two sides of an equation: what measures a distance, and what is known.
#[derive(Clone, Copy)]
pub(super) struct Sides<'m> {
    pub(super) measured: Ex<'m>,
    pub(super) given: Ex<'m>,
}

/// A row `|v| - l` or `v . v - l^2` (or its negative) with a known `l`.
pub(super) fn distance<'m>(
    analysis: &mut Analysis<'_, 'm>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<Distance<'m>> {
    measured(analysis, row, coordinates).or_else(|| written_squares(analysis, row, coordinates))
}

/// A length or its square on one side, known numbers on the other.
fn measured<'m>(
    analysis: &mut Analysis<'_, 'm>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<Distance<'m>> {
    let mut sides = Sides {
        measured: row,
        given: analysis.algebra.zero(),
    };
    loop {
        // Squares of what is known may belong to the vector: one term after the other.
        sides = without_term(analysis, sides, coordinates)?;
        let Sides { measured, given } = without_factors(analysis, sides, coordinates);
        let graph = analysis.algebra.graph;
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
pub(super) fn without_term<'m>(
    analysis: &mut Analysis<'_, 'm>,
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
    let known = |x| {
        !coordinates
            .iter()
            .any(|c| equations::contains(analysis, x, c))
    };
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
    analysis: &mut Analysis<'_, 'm>,
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
        let known = |x| {
            !coordinates
                .iter()
                .any(|c| equations::contains(analysis, x, c))
        };
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
    analysis: &mut Analysis<'_, 'm>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<Distance<'m>> {
    let unknown = |x| {
        coordinates
            .iter()
            .any(|c| equations::contains(analysis, x, c))
    };
    let terms = summands(row);
    let sign = terms.iter().find(|(_, x)| unknown(*x))?.0;
    let mut vector = Vec::new();
    let mut wanted = analysis.algebra.zero();
    for (own, term) in terms {
        match term.node() {
            Node::Binary(Binary::Mul, a, b) if a == b && own == sign => {
                vector.push(term.graph().ex(a));
            }
            _ if unknown(term) => return None,
            _ if own == sign => wanted -= term,
            _ => wanted += term,
        }
    }
    let length = wanted.sqrt();
    matches!(vector.len(), 2 | 3).then_some(Distance { vector, length })
}

/// A row that is a distance in space.
pub(super) fn space_distance<'m>(
    analysis: &mut Analysis<'_, 'm>,
    row: Ex<'m>,
    coordinates: &[Coordinate],
) -> Option<(V3<'m>, Ex<'m>)> {
    let Distance { vector, length } = distance(analysis, row, coordinates)?;
    let vector = vector.try_into().ok()?;
    Some((Vector(vector), length))
}

/// A link with two ball joints to a point that turns about an axis (RSSR) or slides along a line (RSSP).
pub(super) fn classify_distance<'m>(
    analysis: &mut Analysis<'_, 'm>,
    row: Ex<'m>,
    coordinate: &Coordinate,
) -> Option<Form<'m>> {
    let own = std::slice::from_ref(coordinate);
    let (vector, length) = space_distance(analysis, row, own)?;
    let mut rest = classify::polynomials(analysis, &vector.0, own)?;
    let zero = analysis.algebra.zero();
    match coordinate.kind {
        CoordinateKind::Angle(angle) => {
            let symbols = analysis.algebra.names.angles[angle].clone();
            let cosine = rest.take_space(&[symbols.cos], zero);
            let sine = rest.take_space(&[symbols.sin], zero);
            let known = rest.take_space(&[], zero);
            let is_circle = Vn::from(cosine).is_turned(sine.into());
            (rest.is_exhausted() && is_circle).then_some(Form::LinkToRotor {
                angle,
                cosine,
                sine,
                known,
                length,
            })
        }
        CoordinateKind::Length(slide) => {
            let guide = rest.take_space(&[slide], zero);
            let known = rest.take_space(&[], zero);
            rest.is_exhausted().then_some(Form::LinkToSlide {
                slide,
                guide,
                known,
                length,
            })
        }
    }
}

/// A row that is linear in some symbols: their factors and the rest.
pub(super) fn linear_row<'m>(
    analysis: &mut Analysis<'_, 'm>,
    row: Ex<'m>,
    symbols: &[SymbolId],
) -> Option<(Vec<Ex<'m>>, Ex<'m>)> {
    let zero = analysis.algebra.zero();
    let mut terms = collect(row, symbols, &[])?;
    let factors = (0..symbols.len())
        .map(|k| {
            let mut monomial = vec![0; symbols.len()];
            monomial[k] = 1;
            terms.remove(&monomial).unwrap_or(zero)
        })
        .collect();
    let rest = terms.remove(&vec![0; symbols.len()]).unwrap_or(zero);
    terms.is_empty().then_some((factors, rest))
}

/// A vector loop with three slides.
pub(super) fn classify_three_slides<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equation: &Equation<'m>,
    coordinates: &[Coordinate],
) -> Option<Form<'m>> {
    let [x, y, z] = equation.rows[..] else {
        return None;
    };
    let mut slides = Vec::new();
    for coordinate in coordinates {
        match coordinate.kind {
            CoordinateKind::Length(symbol) => slides.push(symbol),
            CoordinateKind::Angle(_) => return None,
        }
    }
    let slides: [SymbolId; 3] = slides.try_into().ok()?;
    let (guides, known) = guides(analysis, Vector([x, y, z]), &slides)?;
    Some(Form::ThreeSlides {
        slides,
        guides: guides.try_into().ok()?,
        known,
    })
}

/// Three rows that are linear in slides: the guide of each, and the rest.
fn guides<'m>(
    analysis: &mut Analysis<'_, 'm>,
    rows: V3<'m>,
    slides: &[SymbolId],
) -> Option<(Vec<V3<'m>>, V3<'m>)> {
    let mut known = Vector([analysis.algebra.zero(); 3]);
    let mut guides = vec![known; slides.len()];
    for (row, x) in rows.components().enumerate() {
        let (factors, rest) = linear_row(analysis, x, slides)?;
        known.0[row] = rest;
        for (guide, factor) in guides.iter_mut().zip(factors) {
            guide.0[row] = factor;
        }
    }
    Some((guides, known))
}

/// Two slides and an angle in a loop of three rows: the equation across both guides contains the angle alone, those across
/// one of them the other slide.
pub(super) fn split_across_guides<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    let ([equation], [_, _, _]) = (equations, coordinates) else {
        return None;
    };
    let [x, y, z] = equation.rows[..] else {
        return None;
    };
    let slides: Vec<SymbolId> = coordinates
        .iter()
        .filter_map(|c| match c.kind {
            CoordinateKind::Length(symbol) => Some(symbol),
            CoordinateKind::Angle(_) => None,
        })
        .collect();
    let (guides, rest) = guides(analysis, Vector([x, y, z]), &slides)?;
    let &[first, second] = &guides[..] else {
        return None;
    };
    let mut across = first.cross(second);
    let turns = |x| {
        coordinates
            .iter()
            .any(|c| equations::contains(analysis, x, c))
    };
    if !across.components().any(turns) {
        across = across.unit();
    }
    let mut rows = vec![across.dot(rest)];
    for (slide, guide, other) in [(0, first, second), (1, second, first)] {
        let direction = other.cross(across);
        let factor = direction.dot(guide);
        let graph = analysis.algebra.graph;
        let slide = graph.ex(graph.symbol_node(slides[slide]));
        rows.push(factor * slide + direction.dot(rest));
    }
    let angle = coordinates
        .iter()
        .find(|c| matches!(c.kind, CoordinateKind::Angle(_)))?;
    let row = |x| Equation {
        rows: vec![x],
        relation: None,
        ..equation.clone()
    };
    let rows: Vec<Equation> = rows.into_iter().map(row).collect();
    classify::classify(analysis, &rows[0], std::slice::from_ref(angle))?;
    Some((rows, coordinates.to_vec()))
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
