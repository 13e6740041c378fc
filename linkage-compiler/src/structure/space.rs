//! Recognising groups in space: distances to a point that turns or slides, loops of three rows.

use linkage_symbolic::{Ex, Graph, SymbolId, V3, Vector, Vn, collect};

use crate::algebra::names::Names;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::form::Form;
use crate::structure::{distance, polynomials};

/// A link with two ball joints to a point that turns about an axis (RSSR) or slides along a line
/// (RSSP).
pub(crate) fn classify_distance<'m>(
    names: &Names<'m>,
    row: Ex<'m>,
    coordinate: &Coordinate,
) -> Option<Form<'m>> {
    let coordinates = std::slice::from_ref(coordinate);
    let (vector, length) = distance::space_distance(names, row, coordinates)?;
    let mut rest = polynomials::polynomials(names, &vector.0, coordinates)?;
    let zero = names.zero();
    match coordinate.kind {
        CoordinateKind::Angle(angle) => {
            let symbols = names.angles[angle].clone();
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
pub(crate) fn linear_row<'m>(
    graph: &'m Graph,
    row: Ex<'m>,
    symbols: &[SymbolId],
) -> Option<(Vec<Ex<'m>>, Ex<'m>)> {
    let zero = graph.number(0.0);
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
pub(crate) fn classify_three_slides<'m>(
    graph: &'m Graph,
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
    let (guides, known) = guides(graph, Vector([x, y, z]), &slides)?;
    Some(Form::ThreeSlides {
        slides,
        guides: guides.try_into().ok()?,
        known,
    })
}

/// Three rows that are linear in slides: the guide of each, and the rest.
pub(crate) fn guides<'m>(
    graph: &'m Graph,
    rows: V3<'m>,
    slides: &[SymbolId],
) -> Option<(Vec<V3<'m>>, V3<'m>)> {
    let mut known = Vector([graph.number(0.0); 3]);
    let mut guides = vec![known; slides.len()];
    for (row, x) in rows.components().enumerate() {
        let (factors, rest) = linear_row(graph, x, slides)?;
        known.0[row] = rest;
        for (guide, factor) in guides.iter_mut().zip(factors) {
            guide.0[row] = factor;
        }
    }
    Some((guides, known))
}
