//! Bringing a coupled set of loops to known forms: distances become links, components become
//! vectors, a sum of angles becomes an angle.

use linkage_symbolic::{Ex, SymbolId, Vector, collect};

use crate::algebra::names::Names;
use crate::algebra::{Atom, Nominal, StandsFor, nominal, scalar};
use crate::structure::distance::Distance;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation, System};
use crate::structure::reductions::Reductions;
use crate::structure::{classify, distance, equations, explicit, space};

/// Two scalar loops, the components of one vector loop.
pub(crate) fn join_rows<'m>(
    names: &Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    let [a, b] = equations else { return None };
    if a.rows.len() != 1 || b.rows.len() != 1 {
        return None;
    }
    let orders = [(a, b), (b, a)];
    let joined = orders.map(|(first, second)| Equation {
        rows: vec![first.rows[0], second.rows[0]],
        relation: None,
        distance: None,
        written: first.written,
        loops: sorted(&first.loops, &second.loops),
        eliminated: sorted(&first.eliminated, &second.eliminated),
    });
    joined
        .into_iter()
        .find(|equation| classify::classify(names, equation, coordinates).is_some())
        .map(|equation| (vec![equation], coordinates.to_vec()))
}

/// `distance(a, b) = l` is a link of length `l` between `a` and `b`, at an angle of its own.
pub(crate) fn distance_to_link<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    for (index, equation) in equations
        .iter()
        .enumerate()
        .filter(|(_, e)| e.rows.len() == 1)
    {
        let Some(Distance { vector, length }) =
            distance::distance(names, equation.rows[0], coordinates)
        else {
            continue;
        };
        if vector.len() != 2 {
            continue;
        }
        let mut equations = equations.to_vec();
        let mut coordinates = coordinates.to_vec();
        let angle = names.add_angle("link", None);
        names.angles[angle].drawn = angle_at_estimates(names, nominal, &vector);
        let unit = names.angles[angle].unit;
        let rows = (0..2).map(|k| vector[k] - length * unit[k]);
        equations[index].rows = rows.collect();
        equations[index].relation = None;
        coordinates.push(Coordinate {
            kind: CoordinateKind::Angle(angle),
            unknown: None,
        });
        return Some((equations, coordinates));
    }
    None
}

/// The angle of a vector where the unknowns are estimated; 0 if that is nowhere.
fn angle_at_estimates(names: &Names<'_>, nominal: &Nominal, vector: &[Ex]) -> f64 {
    let values = nominal::at_estimates(names, nominal, vector);
    let angle = values[1].atan2(values[0]);
    if angle.is_finite() { angle } else { 0.0 }
}

/// An angle whose vectors do not simply turn, with a slide: the equation across the guide contains
/// the angle alone.
pub(crate) fn split_along_guide<'m>(
    names: &Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    let ([equation], [a, b]) = (equations, coordinates) else {
        return None;
    };
    let (angle, slide) = match (a.kind, b.kind) {
        (CoordinateKind::Angle(_), CoordinateKind::Length(slide)) => (a, slide),
        (CoordinateKind::Length(slide), CoordinateKind::Angle(_)) => (b, slide),
        _ => return None,
    };
    let [x, y] = equation.rows[..] else {
        return None;
    };
    let zero = names.zero();
    let mut guide = Vector([zero; 2]);
    for (row, direction) in [x, y].into_iter().zip(&mut guide.0) {
        let terms = collect(row, &[slide], &[])?;
        if terms.keys().any(|exponents| exponents[0] > 1) {
            return None;
        }
        *direction = terms.get(&vec![1]).copied().unwrap_or(zero);
    }
    if guide
        .components()
        .any(|g| equations::contains(names, g, angle))
    {
        return None;
    }
    let rows = Vector([x, y]);
    let across = guide.cross(rows);
    let along = guide.dot(rows);
    let clean = linear_part(across, slide)?;
    let row = |x| Equation {
        rows: vec![x],
        relation: None,
        ..equation.clone()
    };
    Some((vec![row(clean), row(along)], coordinates.to_vec()))
}

/// Angles measured from link to link: their sum is the angle of the second link.
pub(crate) fn relative_angle<'m>(
    names: &mut Names<'m>,
    reductions: &mut Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    let ([equation], [a, b]) = (equations, coordinates) else {
        return None;
    };
    let (CoordinateKind::Angle(first), CoordinateKind::Angle(second)) = (a.kind, b.kind) else {
        return None;
    };
    for (base, relative, kept) in [(first, second, a), (second, first, b)] {
        for sign in [1.0, -1.0] {
            let sum = names.add_angle("sum", None);
            names.angles[sum].stands_for = sum_of(names, base, relative, sign);
            let mut value = scalar::atom(names.graph, Atom::Angle(sum));
            value.terms.insert(0, (Atom::Angle(base), -sign));
            value.terms.sort_by_key(|(atom, _)| *atom);
            let replacements = explicit::replacements_of_angle(names, relative, &value);
            let mut substitutions = reductions.substitutions.clone();
            substitutions.extend(replacements);
            let mut changed = equations::substituted(names.graph, &substitutions, equation);
            changed
                .eliminated
                .extend([a, b].iter().filter_map(|c| c.unknown));
            let summed = Coordinate {
                kind: CoordinateKind::Angle(sum),
                unknown: None,
            };
            let coordinates = vec![kept.clone(), summed];
            if classify::classify(names, &changed, &coordinates).is_some() {
                for (symbol, value) in replacements {
                    explicit::make_explicit(reductions, symbol, value);
                }
                return Some((vec![changed], coordinates));
            }
        }
    }
    None
}

/// The sum of an angle and the one it is measured from stands for the former.
fn sum_of(names: &Names<'_>, base: usize, relative: usize, sign: f64) -> Option<StandsFor> {
    let [base, relative] = [base, relative].map(|k| &names.angles[k]);
    let mut summands = relative.summands();
    let base = base.summands().into_iter();
    summands.extend(base.map(|(unknown, factor)| (unknown, sign * factor)));
    let unknown = relative.meant()?;
    Some(StandsFor { unknown, summands })
}

fn sorted(a: &[usize], b: &[usize]) -> Vec<usize> {
    let mut all: Vec<usize> = a.iter().chain(b).copied().collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// `row` without the terms in `slide`, which cancel.
fn linear_part(row: Ex, slide: SymbolId) -> Option<Ex> {
    let terms = collect(row, &[slide], &[])?;
    let cancelled = terms.keys().all(|exponents| exponents[0] == 0);
    terms.get(&vec![0]).copied().filter(|_| cancelled)
}

/// Two slides and an angle in a loop of three rows: the equation across both guides contains the
/// angle alone, those across one of them the other slide.
pub(crate) fn split_across_guides<'m>(
    names: &Names<'m>,
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
    let (guides, rest) = space::guides(names.graph, Vector([x, y, z]), &slides)?;
    let &[first, second] = &guides[..] else {
        return None;
    };
    let mut across = first.cross(second);
    let turns = |x| coordinates.iter().any(|c| equations::contains(names, x, c));
    if !across.components().any(turns) {
        across = across.unit();
    }
    let mut rows = vec![across.dot(rest)];
    for (slide, guide, other) in [(0, first, second), (1, second, first)] {
        let direction = other.cross(across);
        let factor = direction.dot(guide);
        let graph = names.graph;
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
    classify::classify(names, &rows[0], std::slice::from_ref(angle))?;
    Some((rows, coordinates.to_vec()))
}
