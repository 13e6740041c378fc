//! Recognising an unknown point, or a direction, by its distances from known points and planes.

use linkage_symbolic::{Ex, Graph, SymbolId, V3, Vector, numerically_equal};

use crate::algebra::Nominal;
use crate::algebra::names::Names;
use crate::structure::elements::{Plane, Sphere};
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::form::Form;
use crate::structure::{distance, space};

/// Two or three numbers given by distances in space and planes: a point, or a direction.
pub(crate) fn classify_point<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<Form<'m>> {
    let symbols: Vec<SymbolId> = coordinates
        .iter()
        .map(|c| match c.kind {
            CoordinateKind::Length(symbol) => Some(symbol),
            CoordinateKind::Angle(_) => None,
        })
        .collect::<Option<_>>()?;
    let scalar = equations.iter().all(|e| e.rows.len() == 1);
    if !scalar || equations.len() != symbols.len() || !matches!(symbols.len(), 2 | 3) {
        return None;
    }
    let mut places: Option<Vec<usize>> = None;
    let mut spheres = Vec::new();
    let mut linear = Vec::new();
    for equation in equations {
        let row = equation.rows[0];
        let Some((vector, radius)) = distance::space_distance(names, row, coordinates) else {
            linear.push(space::linear_row(names.graph, row, &symbols)?);
            continue;
        };
        let (columns, factor, known) = moved_point(names.graph, vector, &symbols)?;
        if places.get_or_insert_with(|| columns.clone()) != &columns {
            return None;
        }
        spheres.push(Sphere {
            known,
            factor,
            radius,
        });
    }
    if let ([_, _, _], [a, b, c]) = (&linear[..], &symbols[..]) {
        return Some(three_slides([*a, *b, *c], &linear));
    }
    let places = places?;
    smallest_first(nominal, &mut spheres);
    let zero = names.zero();
    let planes = linear.into_iter().map(|(factors, offset)| {
        let mut normal = Vector([zero; 3]);
        for (&index, factor) in places.iter().zip(factors) {
            normal.0[index] = factor;
        }
        Plane { normal, offset }
    });
    Some(Form::Point {
        coordinates: symbols.into_iter().zip(places.clone()).collect(),
        spheres,
        planes: planes.collect(),
    })
}

/// The accuracy of the solution is that of the first sphere: at the defaults and the reference
/// position, it is the smallest.
fn smallest_first(nominal: &Nominal, spheres: &mut [Sphere]) {
    let size = |sphere: &Sphere| {
        let values = nominal.evaluate(&[sphere.radius, sphere.factor]);
        (values[0] / values[1]).abs()
    };
    spheres.sort_by(|a, b| size(a).total_cmp(&size(b)));
}

/// `k + f p`, where each symbol is a component of `p`: the components, `f` and `k`.
pub(crate) fn moved_point<'m>(
    graph: &'m Graph,
    vector: V3<'m>,
    symbols: &[SymbolId],
) -> Option<(Vec<usize>, Ex<'m>, V3<'m>)> {
    let mut places = vec![None; symbols.len()];
    let mut factor = None;
    let mut known = Vector([graph.number(0.0); 3]);
    for (component, row) in vector.components().enumerate() {
        let (factors, rest) = space::linear_row(graph, row, symbols)?;
        known.0[component] = rest;
        for (slot, entry) in places.iter_mut().zip(factors) {
            if entry.is_zero() {
                continue;
            }
            let first = *factor.get_or_insert(entry);
            if slot.replace(component).is_some() || !numerically_equal(first, entry) {
                return None;
            }
        }
    }
    let places: Vec<usize> = places.into_iter().collect::<Option<_>>()?;
    let distinct = (1..places.len()).all(|k| !places[..k].contains(&places[k]));
    Some((places, factor?, known)).filter(|_| distinct)
}

/// Three linear rows in three lengths.
fn three_slides<'m>(slides: [SymbolId; 3], rows: &[(Vec<Ex<'m>>, Ex<'m>)]) -> Form<'m> {
    Form::ThreeSlides {
        slides,
        guides: [0, 1, 2].map(|slide| Vector([0, 1, 2].map(|row| rows[row].0[slide]))),
        known: Vector([0, 1, 2].map(|row| rows[row].1)),
    }
}
