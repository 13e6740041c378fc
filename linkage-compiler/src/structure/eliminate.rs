//! Bringing a coupled set of loops to known forms: unknowns that are explicit expressions of others go.

use crate::algebra::scalar;
use crate::structure::body_circle;
use crate::structure::circle;
use crate::structure::double;
use crate::structure::equations;
use crate::structure::rewrite;
use crate::structure::space;
use linkage_symbolic::{Ex, SymbolId, collect};

use crate::algebra::{Atom, Scalar};

use super::equations::{Coordinate, CoordinateKind, Equation};
use super::{Analysis, Explicit};

/// Equations and the coordinates that they are solved for.
pub(super) type System<'m> = (Vec<Equation<'m>>, Vec<Coordinate>);

/// An angle relation (`psi = theta + 30deg`) shows which vectors turn together.
fn eliminate_relation<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    let (place, angle) = find_relation(analysis, equations, coordinates)?;
    let value = solved_relation(analysis, &equations[place], angle)?;
    replace_angle(analysis, angle, &value);
    let (gone, kept): (Vec<Coordinate>, Vec<Coordinate>) = coordinates
        .iter()
        .cloned()
        .partition(|c| c.kind == CoordinateKind::Angle(angle));
    let mut equations = equations.to_vec();
    let eliminated = equations.remove(place);
    for equation in &mut equations {
        match replaced_in_relation(analysis, equation, angle, &value) {
            Some(relation) => {
                equation.rows = vec![scalar::value_of(analysis.algebra, &relation)];
                equation.relation = Some(relation);
                equation.absorb(&eliminated, &gone);
            }
            None => substitute_in(analysis, equation, &eliminated, &gone),
        }
    }
    Some((equations, kept))
}

/// A relation between angles that contains no other unknown, and the angle it is best solved for: one that other
/// loops use too, after whose removal the rest counts in whole multiples.
fn find_relation<'m>(
    analysis: &Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<(usize, usize)> {
    equations.iter().enumerate().find_map(|(place, equation)| {
        let relation = equation.relation.as_ref()?;
        if coordinates
            .iter()
            .any(|c| equations::contains(analysis, relation.rest, c))
        {
            return None;
        }
        let used_elsewhere = |c: &Coordinate| {
            let others = equations.iter().enumerate().filter(|(k, _)| *k != place);
            others
                .flat_map(|(_, e)| &e.rows)
                .any(|&row| equations::contains(analysis, row, c))
        };
        let angles: Vec<usize> = coordinates
            .iter()
            .filter_map(|c| match c.kind {
                CoordinateKind::Angle(index) => Some((c, index)),
                CoordinateKind::Length(_) => None,
            })
            .filter(|(_, index)| relation.coefficient(Atom::Angle(*index)) != 0.0)
            .filter(|(c, _)| used_elsewhere(c))
            .map(|(_, index)| index)
            .collect();
        let whole = |index: &&usize| {
            let own = relation.coefficient(Atom::Angle(**index));
            let mut others = relation
                .terms
                .iter()
                .filter(|(a, _)| matches!(a, Atom::Angle(_)));
            others.all(|(_, k)| (k / own).fract() == 0.0)
        };
        let angle = *angles.iter().rev().find(whole).or(angles.last())?;
        Some((place, angle))
    })
}

/// A relation between angles stays a linear form when one of its angles is replaced.
fn replaced_in_relation<'m>(
    _analysis: &mut Analysis<'_, 'm>,
    equation: &Equation<'m>,
    angle: usize,
    value: &Scalar<'m>,
) -> Option<Scalar<'m>> {
    let mut relation = equation.relation.clone()?;
    let factor = relation.coefficient(Atom::Angle(angle));
    if factor == 0.0 {
        return None;
    }
    relation
        .terms
        .retain(|(atom, _)| *atom != Atom::Angle(angle));
    Some(relation.combined(&value.scaled(factor), 1.0))
}

/// An angle relation solved for one angle.
pub(super) fn solved_relation<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equation: &Equation<'m>,
    angle: usize,
) -> Option<Scalar<'m>> {
    let relation = equation.relation.clone()?;
    let own = relation.coefficient(Atom::Angle(angle));
    let own_symbols = analysis.algebra.names.angles[angle].symbols();
    let present = equations::symbols_of(analysis, &[relation.rest]);
    if own == 0.0 || own_symbols.iter().any(|s| present.contains(s)) {
        return None;
    }
    let mut value = relation;
    value.terms.retain(|(atom, _)| *atom != Atom::Angle(angle));
    Some(value.scaled(-1.0 / own))
}

/// Makes an angle an explicit expression of others.
pub(super) fn replace_angle<'m>(analysis: &mut Analysis<'_, 'm>, angle: usize, value: &Scalar<'m>) {
    let [cos, sin] = scalar::direction(analysis.algebra, value).0;
    let number = scalar::value_of(analysis.algebra, value);
    let symbols = analysis.algebra.names.angles[angle].symbols();
    for (symbol, value) in symbols.into_iter().zip([cos, sin, number]) {
        make_explicit(analysis, symbol, value);
    }
}

pub(super) fn make_explicit<'m>(analysis: &mut Analysis<'_, 'm>, symbol: SymbolId, value: Ex<'m>) {
    analysis.substitutions.insert(symbol, value);
    analysis.structure.explicit.push(Explicit { symbol, value });
}

/// Substitutes in an equation; if that changes it, it also answers for the eliminated loop and unknowns.
pub(super) fn substitute_in<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equation: &mut Equation<'m>,
    eliminated: &Equation<'m>,
    gone: &[Coordinate],
) {
    let changed = equations::substituted(analysis, equation);
    if changed.rows != equation.rows {
        *equation = changed;
        equation.absorb(eliminated, gone);
    }
}

/// One step towards known forms; `None` if there is none.
pub(super) fn reduce<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    eliminate_relation(analysis, equations, coordinates)
        .or_else(|| eliminate_point(analysis, equations, coordinates))
        .or_else(|| body_circle::body_to_circles(analysis, equations, coordinates))
        .or_else(|| eliminate_slide(analysis, equations, coordinates))
        .or_else(|| rewrite::join_rows(analysis, equations, coordinates))
        .or_else(|| double::distance_of_double_angle(analysis, equations, coordinates))
        .or_else(|| rewrite::distance_to_link(analysis, equations, coordinates))
        .or_else(|| rewrite::split_along_guide(analysis, equations, coordinates))
        .or_else(|| space::split_across_guides(analysis, equations, coordinates))
        .or_else(|| double::double_angle(analysis, equations, coordinates))
        .or_else(|| rewrite::relative_angle(analysis, equations, coordinates))
        .or_else(|| circle::point_to_circle(analysis, equations, coordinates))
}

/// `p + ... = 0` in one of several vector loops gives the unknown point `p`.
fn eliminate_point<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    if equations.len() < 2 {
        return None;
    }
    for (place, equation) in equations
        .iter()
        .enumerate()
        .filter(|(_, e)| e.rows.len() > 1)
    {
        for point in coordinates.windows(equation.rows.len()) {
            let Some(symbols) = point_symbols(point) else {
                continue;
            };
            let Some(values) = solve_point(analysis, equation, &symbols) else {
                continue;
            };
            for (symbol, value) in symbols.into_iter().zip(values) {
                make_explicit(analysis, symbol, value);
            }
            return Some(without(analysis, equations, coordinates, place, point));
        }
    }
    None
}

/// All components of a point that enters an equation as `k (x, y)` with a `k` that is known before the input.
fn solve_point<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equation: &Equation<'m>,
    point: &[SymbolId],
) -> Option<Vec<Ex<'m>>> {
    let zero = analysis.algebra.zero();
    let mut values = Vec::new();
    for (row, &x) in equation.rows.iter().enumerate() {
        let mut terms = collect(x, point, &[])?;
        let mut own = vec![0; point.len()];
        own[row] = 1;
        let factor = terms.remove(&own)?;
        let rest = terms.remove(&vec![0; point.len()]).unwrap_or(zero);
        if !terms.is_empty() || !factor.is_fixed() {
            return None;
        }
        values.push(-(rest / factor));
    }
    Some(values)
}

/// A scalar loop that is linear in a slide, with a constant factor, gives that slide.
fn eliminate_slide<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    if equations.len() < 2 {
        return None;
    }
    for (place, equation) in equations
        .iter()
        .enumerate()
        .filter(|(_, e)| e.rows.len() == 1)
    {
        for (k, coordinate) in coordinates.iter().enumerate() {
            let CoordinateKind::Length(symbol) = coordinate.kind else {
                continue;
            };
            if analysis.whole.contains(&symbol) {
                continue;
            }
            let Some(mut terms) = collect(equation.rows[0], &[symbol], &[]) else {
                continue;
            };
            let (factor, rest) = (terms.remove(&vec![1]), terms.remove(&vec![0]));
            let (Some(factor), true) = (factor, terms.is_empty()) else {
                continue;
            };
            if factor.constant_value().is_none() {
                continue;
            }
            let rest = rest.unwrap_or(analysis.algebra.zero());
            make_explicit(analysis, symbol, -(rest / factor));
            return Some(without(
                analysis,
                equations,
                coordinates,
                place,
                &coordinates[k..=k],
            ));
        }
    }
    None
}

/// What remains when one equation has given some coordinates.
fn without<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
    place: usize,
    gone: &[Coordinate],
) -> System<'m> {
    let mut equations = equations.to_vec();
    let eliminated = equations.remove(place);
    for equation in &mut equations {
        substitute_in(analysis, equation, &eliminated, gone);
    }
    let kept = coordinates
        .iter()
        .filter(|c| !gone.contains(c))
        .cloned()
        .collect();
    (equations, kept)
}

/// The symbols of coordinates that are components of one unknown.
pub(super) fn point_symbols(coordinates: &[Coordinate]) -> Option<Vec<SymbolId>> {
    let first = coordinates.first()?.unknown;
    coordinates
        .iter()
        .map(|c| match c.kind {
            CoordinateKind::Length(symbol) if c.unknown == first => Some(symbol),
            _ => None,
        })
        .collect()
}
