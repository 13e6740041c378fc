//! Messages about a group that no method solves: the term of too high a degree, and that the limit
//! is that of the compiler.

use linkage_symbolic::{MAX_DEGREE, Obstacle, SymbolId, obstacle};

use crate::algebra::names::Names;
use crate::algebra::translate::Translate;
use crate::algebra::{Value, scalar};
use crate::diagnostic::OriginId;
use crate::message_format::loop_names;
use crate::model::{Expr, Mechanism};
use crate::structure::coupled::classify_coupled;
use crate::structure::coupled::classify_coupled::MOST_CORE;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::fault::{OURS, StructureFault};
use crate::structure::link_faults::coupled_wheels;
use crate::structure::{equations, naming, polynomials};

/// The terms that a method can solve.
const MAY_STAND: &str = "an unknown angle may stand in `polar`, `dir`, `rotate`, `turn`, `sin`, `cos`, an unknown length may be \
                         multiplied by known quantities or by a direction";

/// Returns the fault of a group without a closed form that is no coupled one.
pub(crate) fn unsolved_group<'m>(
    names: &mut Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> StructureFault {
    let loops = loop_names(names.mechanism, equations.iter().flat_map(|e| &e.loops));
    let found = coordinates.iter().filter_map(|c| c.unknown);
    let eliminated = equations.iter().flat_map(|e| e.eliminated.iter().copied());
    let mut unknowns: Vec<usize> = found.chain(eliminated).collect();
    unknowns.sort_unstable();
    unknowns.dedup();
    let count: usize = unknowns.iter().map(|&k| names.components_of(k)).sum();
    let unknown_names = naming::unknown_list(names.mechanism, unknowns.clone());
    let rows: usize = equations.iter().map(|e| e.rows.len()).sum();
    let (subject, check) = match rows {
        0..=2 => (format!("no closed form for {unknown_names} in {loops}"), ""),
        _ => (
            format!("a group of {count} unknowns ({unknown_names}) in {loops} cannot be solved"),
            "; check that the loops need to be coupled",
        ),
    };
    let whole = names.mechanism.loops[equations[0].loops[0]].origin;
    let valued = angles_with_values(names, equations, coordinates);
    let body = a_body_by_angles(equations, coordinates);
    let (origin, text) = if let Some(text) =
        coupled_wheels(names.mechanism, equations, &unknowns).filter(|_| rows > 2)
    {
        (whole, text)
    } else if let Some((origin, why)) = worst_obstacle(names, equations, coordinates) {
        let text = format!("{subject}: {why}{check}{body}");
        (origin.unwrap_or(whole), text)
    } else if !valued.is_empty() {
        (
            whole,
            format!(
                "{subject}: {}",
                obstacle_of_values(names.mechanism, &valued, rows)
            ),
        )
    } else {
        let core = core_of(names, equations, coordinates);
        let text = format!(
            "{subject}: {core} unknowns remain when links between two joints are left out, and {MOST_CORE} are the most that are \
                 solved together; {OURS}\n\
                 help: check that the loops need to be coupled; an input instead of an unknown may split them{body}"
        );
        (whole, text)
    };
    StructureFault { origin, text }
}

/// Returns the reason why an equation is no polynomial that is solved, with the remedy, and the
/// term of a loop at fault, if there is one.
fn worst_obstacle<'m>(
    names: &mut Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<(Option<OriginId>, String)> {
    let symbols: Vec<SymbolId> = coordinates
        .iter()
        .flat_map(|c| equations::symbols(names, c))
        .collect();
    let worst = |obstacles: Vec<Obstacle>| obstacles.into_iter().max_by_key(weight);
    for equation in equations {
        // Terms that cancel make no degree.
        if polynomials::polynomials(names, &equation.rows, coordinates).is_some() {
            continue;
        }
        let rows = equation.rows.iter();
        let Some(found) = worst(rows.filter_map(|&row| obstacle(row, &symbols)).collect()) else {
            continue;
        };
        let written = &names.mechanism.loops[equation.written];
        let terms = [&written.left, &written.right].map(terms).concat();
        let term = terms.into_iter().find(|term| {
            let rows = match names.translate(term) {
                Value::Vector(vector) => vector.iter().collect(),
                scalar => vec![scalar::number(names, &scalar)],
            };
            rows.into_iter()
                .any(|row| obstacle(row, &symbols) == Some(found))
        });
        let subject = loop_names(names.mechanism, &equation.loops);
        let what = match (&term, &equation.loops[..]) {
            (Some(_), _) => format!("this term of {subject} has"),
            (None, [_]) => format!("{subject} has"),
            (None, _) => format!("{subject} have"),
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

/// Returns the text about angles that stand for themselves.
fn obstacle_of_values(mechanism: &Mechanism, valued: &[usize], rows: usize) -> String {
    let angle_names = naming::unknown_list(mechanism, valued.to_vec());
    if rows <= 2 {
        return format!(
            "the angle {angle_names} itself stands in it, and not its direction alone; {OURS}\nhelp: {MAY_STAND}"
        );
    }
    let each = match valued {
        [_] => format!("{angle_names} stands"),
        _ => format!("each of {angle_names} stands"),
    };
    format!(
        "{each} for an angle, and the angle itself, not its direction, stands in a loop\n\
             help: {MAY_STAND}; a slide is a length times a direction, not a number times a vector of lengths"
    )
}

/// The unknown angles of which polynomial loops contain the value.
fn angles_with_values<'m>(
    names: &Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Vec<usize> {
    let polynomials: Vec<_> = equations
        .iter()
        .filter_map(|e| polynomials::polynomials(names, &e.rows, coordinates))
        .collect();
    let angles = coordinates.iter().enumerate().filter(|(k, coordinate)| {
        let value = polynomials::first_symbol(names, coordinates, *k) + 2;
        matches!(coordinate.kind, CoordinateKind::Angle(_))
            && polynomials.iter().any(|p| p.mention(value))
    });
    angles.filter_map(|(_, c)| c.unknown).collect()
}

/// Returns the number of unknowns of polynomial loops in the core.
fn core_of<'m>(names: &Names<'m>, equations: &[Equation<'m>], coordinates: &[Coordinate]) -> usize {
    let polynomials: Vec<_> = equations
        .iter()
        .filter_map(|e| polynomials::polynomials(names, &e.rows, coordinates))
        .collect();
    classify_coupled::private_and_core(names, &polynomials, coordinates)
        .1
        .len()
}

/// The form that serves a body in space whose place was written by angles, for the end of a help.
fn a_body_by_angles(equations: &[Equation], coordinates: &[Coordinate]) -> &'static str {
    let in_space = |e: &Equation| e.rows.len() == 3 || e.distance.is_some();
    let is_angle = |c: &&Coordinate| matches!(c.kind, CoordinateKind::Angle(_));
    if equations.iter().any(in_space) && coordinates.iter().filter(is_angle).count() > 1 {
        "; the place of a body in space is `unknown body = frame(origin, x, z);` without angles, and its points are \
             `point_in(body, (x, y, z))`"
    } else {
        ""
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
            .flat_map(|(_, summand)| terms(summand))
            .collect(),
    }
}
