//! What is said of a group that no method solves: what is too much of which term, and that the limit is ours.

use crate::algebra::translate;
use crate::structure::classify;
use crate::structure::coupled_core;
use crate::structure::equations;
use crate::structure::report;
use linkage_symbolic::{MAX_DEGREE, Obstacle, SymbolId, obstacle};

use super::Analysis;
use super::coupled_core::MOST_CORE;
use super::equations::{Coordinate, CoordinateKind, Equation};
use crate::algebra::{Translate, Value};
use crate::diagnostic::OriginId;
use crate::message_format::loop_list;
use crate::model::Expr;

/// How every limit is called what it is.
pub(crate) const OURS: &str = "this is a limit of linkage, not a mistake of yours";

/// What a method can have to do with.
const MAY_STAND: &str = "an unknown angle may stand in `polar`, `dir`, `rotate`, `turn`, `sin`, `cos`, an unknown length may be \
                         multiplied by known quantities or by a direction";

/// A group without a closed form that is no coupled one.
pub(super) fn report_unsolved<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) {
    let loops = loop_list(equations.iter().flat_map(|e| &e.loops));
    let own = coordinates.iter().filter_map(|c| c.unknown);
    let eliminated = equations.iter().flat_map(|e| e.eliminated.iter().copied());
    let mut unknowns: Vec<usize> = own.chain(eliminated).collect();
    unknowns.sort_unstable();
    unknowns.dedup();
    let count: usize = unknowns
        .iter()
        .map(|&k| analysis.algebra.names.components_of(k))
        .sum();
    let names = report::names(analysis, unknowns);
    let rows: usize = equations.iter().map(|e| e.rows.len()).sum();
    let (subject, check) = match rows {
        0..=2 => (format!("no closed form for {names} in {loops}"), ""),
        _ => (
            format!("a group of {count} unknowns ({names}) in {loops} cannot be solved"),
            "; check that the loops need to be coupled",
        ),
    };
    let whole = analysis.algebra.mechanism.loops[equations[0].loops[0]].origin;
    let valued = valued(analysis, equations, coordinates);
    let body = a_body_by_angles(equations, coordinates);
    let (origin, message) = if let Some((origin, why)) =
        worst_obstacle(analysis, equations, coordinates)
    {
        let message = format!("{subject}: {why}{check}{body}");
        (origin.unwrap_or(whole), message)
    } else if !valued.is_empty() {
        (
            whole,
            format!("{subject}: {}", of_values(analysis, &valued, rows)),
        )
    } else {
        let core = core_of(analysis, equations, coordinates);
        let message = format!(
            "{subject}: {core} unknowns remain when links between two joints are left out, and {MOST_CORE} are the most that are \
                 solved together; {OURS}\n\
                 help: check that the loops need to be coupled; an input instead of an unknown may split them{body}"
        );
        (whole, message)
    };
    analysis.reporter.error(origin, message);
}

/// Why an equation is no polynomial that is solved, with what to do, and the term of a loop at fault, if there is one.
fn worst_obstacle<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<(Option<OriginId>, String)> {
    let symbols: Vec<SymbolId> = coordinates
        .iter()
        .flat_map(|c| equations::symbols(analysis, c))
        .collect();
    let worst = |obstacles: Vec<Obstacle>| obstacles.into_iter().max_by_key(weight);
    for equation in equations {
        // What cancels makes no degree.
        if classify::polynomials(analysis, &equation.rows, coordinates).is_some() {
            continue;
        }
        let rows = equation.rows.iter();
        let Some(found) = worst(rows.filter_map(|&row| obstacle(row, &symbols)).collect()) else {
            continue;
        };
        let written = &analysis.algebra.mechanism.loops[equation.written];
        let terms = [&written.left, &written.right].map(terms).concat();
        let term = terms.into_iter().find(|term| {
            let rows = match analysis.algebra.translate(term) {
                Value::Vector(vector) => vector.iter().collect(),
                scalar => vec![translate::number(analysis.algebra, &scalar)],
            };
            rows.into_iter()
                .any(|row| obstacle(row, &symbols) == Some(found))
        });
        let place = loop_list(&equation.loops);
        let what = match (&term, &equation.loops[..]) {
            (Some(_), _) => format!("this term of {place} has"),
            (None, [_]) => format!("{place} has"),
            (None, _) => format!("{place} have"),
        };
        let why = match found {
            Obstacle::Degree(degree) => format!(
                "{what} degree {degree} in directions and lengths, and {MAX_DEGREE} is the highest that is solved; {OURS}\n\
                     help: use lower multiples of unknown angles and products of fewer unknowns"
            ),
            Obstacle::Root => no_polynomial(&what, "root of"),
            Obstacle::Division => no_polynomial(&what, "division by"),
            Obstacle::Function => no_polynomial(&what, "function of"),
        };
        return Some((term.map(|term| term.origin), why));
    }
    None
}

/// What is wrong with angles that stand for themselves.
fn of_values(analysis: &Analysis<'_, '_>, valued: &[usize], rows: usize) -> String {
    let names = report::names(analysis, valued.to_vec());
    if rows <= 2 {
        return format!(
            "the angle {names} itself stands in it, and not its direction alone; {OURS}\nhelp: {MAY_STAND}"
        );
    }
    let each = match valued {
        [_] => format!("{names} stands"),
        _ => format!("each of {names} stands"),
    };
    format!(
        "{each} for an angle, and the angle itself, not its direction, stands in a loop\n\
             help: {MAY_STAND}; a slide is a length times a direction, not a number times a vector of lengths"
    )
}

/// The unknown angles of which polynomial loops contain the value.
fn valued<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Vec<usize> {
    let polynomials: Vec<_> = equations
        .iter()
        .filter_map(|e| classify::polynomials(analysis, &e.rows, coordinates))
        .collect();
    let angles = coordinates.iter().enumerate().filter(|(k, coordinate)| {
        let value = coupled_core::first_symbol(analysis, coordinates, *k) + 2;
        matches!(coordinate.kind, CoordinateKind::Angle(_))
            && polynomials.iter().any(|p| p.mention(value))
    });
    angles.filter_map(|(_, c)| c.unknown).collect()
}

/// How many unknowns of polynomial loops are in the core.
fn core_of<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> usize {
    let polynomials: Vec<_> = equations
        .iter()
        .filter_map(|e| classify::polynomials(analysis, &e.rows, coordinates))
        .collect();
    coupled_core::private_and_core(analysis, &polynomials, coordinates)
        .1
        .len()
}

/// The form that serves a body in space whose place was written by angles, for the end of a help.
fn a_body_by_angles(equations: &[Equation], coordinates: &[Coordinate]) -> &'static str {
    let in_space = |e: &Equation| e.rows.len() == 3 || e.distance.is_some();
    let is_angle = |c: &&Coordinate| matches!(c.kind, CoordinateKind::Angle(_));
    match equations.iter().any(in_space) && coordinates.iter().filter(is_angle).count() > 1 {
        true => {
            "; the place of a body in space is `unknown body = frame(origin, x, z);` without angles, and its points are \
             `point_in(body, (x, y, z))`"
        }
        false => "",
    }
}

fn no_polynomial(what: &str, how: &str) -> String {
    format!(
        "{what} a {how} unknowns in it, where only polynomials in directions and lengths are solved; {OURS}\nhelp: {MAY_STAND}"
    )
}

/// A function is worse than a degree, and a higher degree than a lower one.
fn weight(obstacle: &Obstacle) -> u32 {
    match obstacle {
        Obstacle::Degree(degree) => *degree,
        Obstacle::Root | Obstacle::Division | Obstacle::Function => u32::MAX,
    }
}

/// The terms of a sum.
fn terms(side: &Expr) -> Vec<&Expr> {
    let summands = side.summands();
    match summands.is_empty() {
        true => vec![side],
        false => summands
            .into_iter()
            .flat_map(|(_, own)| terms(own))
            .collect(),
    }
}
