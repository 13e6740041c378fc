//! Bringing a coupled set of loops to known forms: unknowns that are explicit expressions of others
//! go.

use linkage_symbolic::{Ex, Graph, SymbolId, collect};

use crate::algebra::names::Names;
use crate::algebra::{Atom, Nominal, Scalar, scalar};
use crate::structure::equations::{Coordinate, CoordinateKind, Equation, System};
use crate::structure::reductions::{Reductions, Substitutions};
use crate::structure::{body_circle, circle, double, equations, explicit, rewrite};

/// An angle relation (`psi = theta + 30deg`) shows which vectors turn together.
fn eliminate_relation<'m>(
    names: &mut Names<'m>,
    reductions: &mut Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    let (equation_index, angle) = find_relation(names, equations, coordinates)?;
    let value = explicit::solved_relation(names, &equations[equation_index], angle)?;
    explicit::replace_angle(names, reductions, angle, &value);
    let (gone, kept): (Vec<Coordinate>, Vec<Coordinate>) = coordinates
        .iter()
        .cloned()
        .partition(|c| c.kind == CoordinateKind::Angle(angle));
    let mut equations = equations.to_vec();
    let eliminated = equations.remove(equation_index);
    for equation in &mut equations {
        match replaced_in_relation(equation, angle, &value) {
            Some(relation) => {
                equation.rows = vec![scalar::value_of(names, &relation)];
                equation.relation = Some(relation);
                equation.absorb(&eliminated, &gone);
            }
            None => explicit::substitute_in(
                names.graph,
                &reductions.substitutions,
                equation,
                &eliminated,
                &gone,
            ),
        }
    }
    Some((equations, kept))
}

/// A relation between angles that contains no other unknown, and the angle it is best solved for:
/// one that other loops use too, after whose removal the rest counts in whole multiples.
fn find_relation<'m>(
    names: &Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<(usize, usize)> {
    equations
        .iter()
        .enumerate()
        .find_map(|(equation_index, equation)| {
            let relation = equation.relation.as_ref()?;
            if coordinates
                .iter()
                .any(|c| equations::contains(names, relation.rest, c))
            {
                return None;
            }
            let used_elsewhere = |c: &Coordinate| {
                let others = equations
                    .iter()
                    .enumerate()
                    .filter(|(k, _)| *k != equation_index);
                others
                    .flat_map(|(_, e)| &e.rows)
                    .any(|&row| equations::contains(names, row, c))
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
                let factor = relation.coefficient(Atom::Angle(**index));
                let mut others = relation
                    .terms
                    .iter()
                    .filter(|(a, _)| matches!(a, Atom::Angle(_)));
                others.all(|(_, k)| (k / factor).fract() == 0.0)
            };
            let angle = *angles.iter().rev().find(whole).or(angles.last())?;
            Some((equation_index, angle))
        })
}

/// A relation between angles stays a linear form when one of its angles is replaced.
fn replaced_in_relation<'m>(
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

/// One step towards known forms; `None` if there is none.
pub(crate) fn reduce<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    reductions: &mut Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    eliminate_relation(names, reductions, equations, coordinates)
        .or_else(|| eliminate_point(names.graph, reductions, equations, coordinates))
        .or_else(|| {
            body_circle::body_to_circles(names, nominal, reductions, equations, coordinates)
        })
        .or_else(|| eliminate_slide(names.graph, reductions, equations, coordinates))
        .or_else(|| rewrite::join_rows(names, equations, coordinates))
        .or_else(|| double::distance_of_double_angle(names, reductions, equations, coordinates))
        .or_else(|| rewrite::distance_to_link(names, nominal, equations, coordinates))
        .or_else(|| rewrite::split_along_guide(names, equations, coordinates))
        .or_else(|| rewrite::split_across_guides(names, equations, coordinates))
        .or_else(|| double::double_angle(names, reductions, equations, coordinates))
        .or_else(|| rewrite::relative_angle(names, reductions, equations, coordinates))
        .or_else(|| circle::point_to_circle(names, nominal, reductions, equations, coordinates))
}

/// `p + ... = 0` in one of several vector loops gives the unknown point `p`.
fn eliminate_point<'m>(
    graph: &'m Graph,
    reductions: &mut Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    if equations.len() < 2 {
        return None;
    }
    for (equation_index, equation) in equations
        .iter()
        .enumerate()
        .filter(|(_, e)| e.rows.len() > 1)
    {
        for point in coordinates.windows(equation.rows.len()) {
            let Some(symbols) = equations::point_symbols(point) else {
                continue;
            };
            let Some(values) = solve_point(graph, equation, &symbols) else {
                continue;
            };
            for (symbol, value) in symbols.into_iter().zip(values) {
                explicit::make_explicit(reductions, symbol, value);
            }
            return Some(without(
                graph,
                &reductions.substitutions,
                equations,
                coordinates,
                equation_index,
                point,
            ));
        }
    }
    None
}

/// All components of a point that enters an equation as `k (x, y)` with a `k` that is known before
/// the input.
fn solve_point<'m>(
    graph: &'m Graph,
    equation: &Equation<'m>,
    point: &[SymbolId],
) -> Option<Vec<Ex<'m>>> {
    let zero = graph.number(0.0);
    let mut values = Vec::new();
    for (row, &x) in equation.rows.iter().enumerate() {
        let mut terms = collect(x, point, &[])?;
        let mut monomial = vec![0; point.len()];
        monomial[row] = 1;
        let factor = terms.remove(&monomial)?;
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
    graph: &'m Graph,
    reductions: &mut Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    if equations.len() < 2 {
        return None;
    }
    for (equation_index, equation) in equations
        .iter()
        .enumerate()
        .filter(|(_, e)| e.rows.len() == 1)
    {
        for (k, coordinate) in coordinates.iter().enumerate() {
            let CoordinateKind::Length(symbol) = coordinate.kind else {
                continue;
            };
            if reductions.kept_axes.contains(&symbol) {
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
            let rest = rest.unwrap_or(graph.number(0.0));
            explicit::make_explicit(reductions, symbol, -(rest / factor));
            return Some(without(
                graph,
                &reductions.substitutions,
                equations,
                coordinates,
                equation_index,
                &coordinates[k..=k],
            ));
        }
    }
    None
}

/// Returns the rest when one equation has given some coordinates.
fn without<'m>(
    graph: &'m Graph,
    substitutions: &Substitutions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
    equation_index: usize,
    gone: &[Coordinate],
) -> System<'m> {
    let mut equations = equations.to_vec();
    let eliminated = equations.remove(equation_index);
    for equation in &mut equations {
        explicit::substitute_in(graph, substitutions, equation, &eliminated, gone);
    }
    let kept = coordinates
        .iter()
        .filter(|c| !gone.contains(c))
        .cloned()
        .collect();
    (equations, kept)
}
