//! Bringing a coupled set of loops to known forms: distances become links, components become vectors, a sum of angles
//! becomes an angle.

use crate::algebra::scalar;
use crate::structure::classify;
use crate::structure::eliminate;
use crate::structure::equations;
use crate::structure::space;
use linkage_symbolic::{Ex, SymbolId, Vector, collect};

use crate::algebra::{Atom, StandsFor};

use super::Analysis;
use super::eliminate::System;
use super::equations::{Coordinate, CoordinateKind, Equation};
use super::space::Distance;

/// Two scalar loops, the components of one vector loop.
pub(super) fn join_rows<'m>(
    analysis: &mut Analysis<'_, 'm>,
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
        .find(|equation| classify::classify(analysis, equation, coordinates).is_some())
        .map(|equation| (vec![equation], coordinates.to_vec()))
}

/// `distance(a, b) = l` is a link of length `l` between `a` and `b`, at an angle of its own.
pub(super) fn distance_to_link<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    for (place, equation) in equations
        .iter()
        .enumerate()
        .filter(|(_, e)| e.rows.len() == 1)
    {
        let Some(Distance { vector, length }) =
            space::distance(analysis, equation.rows[0], coordinates)
        else {
            continue;
        };
        if vector.len() != 2 {
            continue;
        }
        let mut equations = equations.to_vec();
        let mut coordinates = coordinates.to_vec();
        let angle = analysis.algebra.names.add_angle("link", None);
        let unit = analysis.algebra.names.angles[angle].unit;
        let rows = (0..2).map(|k| vector[k] - length * unit[k]);
        equations[place].rows = rows.collect();
        equations[place].relation = None;
        coordinates.push(Coordinate {
            kind: CoordinateKind::Angle(angle),
            unknown: None,
        });
        return Some((equations, coordinates));
    }
    None
}

/// An angle whose vectors do not simply turn, with a slide: the equation across the guide contains the angle alone.
pub(super) fn split_along_guide<'m>(
    analysis: &mut Analysis<'_, 'm>,
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
    let zero = analysis.algebra.zero();
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
        .any(|g| equations::contains(analysis, g, angle))
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
pub(super) fn relative_angle<'m>(
    analysis: &mut Analysis<'_, 'm>,
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
            let sum = analysis.algebra.names.add_angle("sum", None);
            analysis.algebra.names.angles[sum].stands_for = sum_of(analysis, base, relative, sign);
            let mut value = scalar::atom(analysis.algebra, Atom::Angle(sum));
            value.terms.insert(0, (Atom::Angle(base), -sign));
            value.terms.sort_by_key(|(atom, _)| *atom);
            let saved = (
                analysis.substitutions.clone(),
                analysis.structure.explicit.len(),
            );
            eliminate::replace_angle(analysis, relative, &value);
            let mut changed = equations::substituted(analysis, equation);
            changed
                .eliminated
                .extend([a, b].iter().filter_map(|c| c.unknown));
            let summed = Coordinate {
                kind: CoordinateKind::Angle(sum),
                unknown: None,
            };
            let coordinates = vec![kept.clone(), summed];
            if classify::classify(analysis, &changed, &coordinates).is_some() {
                return Some((vec![changed], coordinates));
            }
            analysis.substitutions = saved.0;
            analysis.structure.explicit.truncate(saved.1);
        }
    }
    None
}

/// The sum of an angle and the one it is measured from stands for the former.
fn sum_of(
    analysis: &Analysis<'_, '_>,
    base: usize,
    relative: usize,
    sign: f64,
) -> Option<StandsFor> {
    let [base, relative] = [base, relative].map(|k| &analysis.algebra.names.angles[k]);
    let mut summands = relative.summands();
    let base = base.summands().into_iter();
    summands.extend(base.map(|(unknown, own)| (unknown, sign * own)));
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
