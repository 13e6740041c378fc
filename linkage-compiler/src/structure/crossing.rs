//! Crossing lines: a point of a chain of links that two lines hold. The lines give it separately,
//! and the chain leads to it.

use linkage_symbolic::{Ex, SymbolId, V2, Vector, numerically_equal};

use crate::algebra::names::Names;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation, System};
use crate::structure::reductions::Reductions;
use crate::structure::{cancellation, polynomials, set_unknowns};

/// A scalar equation `normal . (point + links) + known = 0`.
struct Line<'m> {
    index: usize,
    normal: V2<'m>,
    links: V2<'m>,
    known: Ex<'m>,
}

/// Two lines that hold the end of links on an unknown point.
struct Crossing<'m> {
    lines: [Line<'m>; 2],
    point: [SymbolId; 2],
}

/// Replaces the equations of two lines by those of their crossing, a new point, and by the vector
/// loop that leads to it; `None` if no lines cross in a point of a chain.
pub(crate) fn by_crossing<'m>(
    names: &mut Names<'m>,
    reductions: &Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    if equations.len() < 3 {
        return None;
    }
    let Crossing { lines, point } = crossing(names, equations, coordinates)?;
    let [first, second] = lines;
    let graph = names.graph;
    let made = ["x", "y"].map(|axis| graph.unknown(format!("crossing.{axis}")));
    let at = Vector(made.map(|(_, node)| graph.ex(node)));
    let point = Vector(point.map(|symbol| graph.ex(graph.symbol_node(symbol))));
    let rows = [&first, &second].map(|line| line.normal.dot(at) + line.known);
    let leads_there = point + first.links - at;
    let mut equations = equations.to_vec();
    let both = [first.index, second.index].map(|index| equations[index].clone());
    for (index, rows) in [(first.index, rows), (second.index, leads_there.0)] {
        let equation = &mut equations[index];
        equation.rows = rows.to_vec();
        equation.relation = None;
        for line in &both {
            equation.absorb(line, &[]);
        }
    }
    let mut coordinates = coordinates.to_vec();
    coordinates.extend(made.map(|(symbol, _)| Coordinate {
        kind: CoordinateKind::Length(symbol),
        unknown: None,
    }));
    set_unknowns::place_eliminated(names, reductions, &mut equations, &coordinates)?;
    Some((equations, coordinates))
}

fn crossing<'m>(
    names: &Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<Crossing<'m>> {
    coordinates.windows(2).find_map(|point| {
        let point = components(point)?;
        let lines = equations.iter().enumerate();
        let mut lines: Vec<Line<'m>> = lines
            .filter_map(|(index, equation)| line(names, index, equation, point, coordinates))
            .collect();
        let crosses = |[a, b]: [usize; 2]| {
            let [a, b] = [&lines[a], &lines[b]];
            let sine = a.normal.cross(b.normal);
            let is_one_point = (0..2).all(|k| numerically_equal(a.links[k], b.links[k]));
            is_one_point && !numerically_equal(sine, names.zero())
        };
        let mut pairs = (0..lines.len()).flat_map(|b| (0..b).map(move |a| [a, b]));
        let [first, second] = pairs.find(|pair| crosses(*pair))?;
        let second = lines.swap_remove(second);
        let first = lines.swap_remove(first);
        Some(Crossing {
            lines: [first, second],
            point,
        })
    })
}

/// The symbols of two coordinates, if they are a point of the plane.
fn components(point: &[Coordinate]) -> Option<[SymbolId; 2]> {
    let [x, y] = point else { return None };
    match (x.kind, y.kind) {
        (CoordinateKind::Length(first), CoordinateKind::Length(second))
            if x.unknown.is_some() && x.unknown == y.unknown =>
        {
            Some([first, second])
        }
        _ => None,
    }
}

/// A scalar equation as a line that holds the end of links on a point.
fn line<'m>(
    names: &Names<'m>,
    index: usize,
    equation: &Equation<'m>,
    point: [SymbolId; 2],
    coordinates: &[Coordinate],
) -> Option<Line<'m>> {
    if equation.rows.len() != 1 {
        return None;
    }
    let zero = names.zero();
    let mut rest = polynomials::polynomials(names, &equation.rows, coordinates)?;
    let normal = Vector(point.map(|symbol| rest.take(&[symbol], zero)[0]));
    let known = rest.take(&[], zero)[0];
    let mut links = Vector([zero; 2]);
    for coordinate in coordinates {
        let CoordinateKind::Angle(angle) = coordinate.kind else {
            continue;
        };
        let angle = &names.angles[angle];
        let along = [angle.cos, angle.sin].map(|symbol| rest.take(&[symbol], zero)[0]);
        if along.iter().all(|x| x.is_zero()) {
            continue;
        }
        let mut pairs = along.into_iter().zip(normal.components());
        let length = pairs.find_map(|(x, n)| cancellation::ratio_of_terms(x, n))?;
        let mut pairs = along.into_iter().zip(normal.components());
        if !pairs.all(|(x, n)| numerically_equal(x, length * n)) {
            return None;
        }
        links = links + length * angle.unit;
    }
    (rest.is_exhausted() && !normal.is_zero()).then_some(Line {
        index,
        normal,
        links,
        known,
    })
}
