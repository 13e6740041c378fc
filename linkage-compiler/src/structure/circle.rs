//! A point at given distances from two fixed points runs on a circle: three unknowns and two loops
//! become one angle.

use linkage_symbolic::{Ex, Graph, SymbolId, V3, Vector};

use crate::algebra::names::Names;
use crate::algebra::{Nominal, nominal};
use crate::structure::equations::{Coordinate, CoordinateKind, Equation, System};
use crate::structure::reductions::Reductions;
use crate::structure::{distance, equations, explicit, point};

/// A distance of an unknown point from a fixed one.
pub(crate) struct Held<'m> {
    /// The equation that says so.
    pub(crate) index: usize,
    pub(crate) end: V3<'m>,
    pub(crate) length: Ex<'m>,
}

/// The points `middle + cos axes[0] + sin axes[1]`.
struct Circle<'m> {
    middle: V3<'m>,
    axes: [V3<'m>; 2],
}

/// A point that runs on a circle, by a new angle.
pub(crate) struct Running<'m> {
    pub(crate) point: V3<'m>,
    pub(crate) angle: Coordinate,
}

/// An unknown point that two distances from fixed points hold, and other loops determine.
pub(crate) fn point_to_circle<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    reductions: &mut Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    for point in coordinates.windows(3) {
        let Some(symbols) = equations::point_symbols(point) else {
            continue;
        };
        let held = held_by(names, &symbols, equations, coordinates);
        let [first, second] = &held[..] else { continue };
        if equations.len() > 2
            && let Some(system) = on_circle(
                names,
                nominal,
                reductions,
                [first, second],
                point,
                equations,
                coordinates,
            )
        {
            return Some(system);
        }
    }
    None
}

/// The distances from fixed points that contain nothing but this point.
fn held_by<'m>(
    names: &Names<'m>,
    point: &[SymbolId],
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Vec<Held<'m>> {
    let mut held = Vec::new();
    for (index, equation) in equations.iter().enumerate() {
        let [row] = equation.rows[..] else { continue };
        let Some((vector, length)) = distance::space_distance(names, row, coordinates) else {
            continue;
        };
        let Some((places, factor, known)) = point::moved_point(names.graph, vector, point) else {
            continue;
        };
        let is_whole = factor.constant_value().is_some_and(|x| x.abs() == 1.0);
        let end = -(known / factor);
        // Seen from points that move, a direction across both may vanish on the way.
        if is_whole && places == [0, 1, 2] && end.is_fixed() {
            held.push(Held { index, end, length });
        }
    }
    held
}

fn on_circle<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    reductions: &mut Reductions<'m>,
    [first, second]: [&Held<'m>; 2],
    point: &[Coordinate],
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    let symbols = equations::point_symbols(point)?;
    let graph = names.graph;
    let symbols_of_point = Vector([0, 1, 2].map(|k| graph.ex(graph.symbol_node(symbols[k]))));
    let running = running(names, nominal, symbols_of_point, [first, second]);
    for (symbol, value) in symbols.into_iter().zip(running.point.0) {
        explicit::make_explicit(reductions, symbol, value);
    }
    let mut gone = equations[first.index].clone();
    gone.absorb(&equations[second.index], &[]);
    let kept = equations.iter().enumerate();
    let kept = kept.filter(|(index, _)| ![first.index, second.index].contains(index));
    let mut kept: Vec<Equation> = kept.map(|(_, equation)| equation.clone()).collect();
    for equation in &mut kept {
        explicit::substitute_in(graph, &reductions.substitutions, equation, &gone, point);
    }
    let mut left: Vec<Coordinate> = coordinates.to_vec();
    left.retain(|coordinate| !point.contains(coordinate));
    left.push(running.angle);
    Some((kept, left))
}

/// A point that two distances hold, by the angle on its circle; `point` is its expression in the
/// unknowns so far.
pub(crate) fn running<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    point: V3<'m>,
    held: [&Held<'m>; 2],
) -> Running<'m> {
    let circle = circle(names.graph, nominal, held[0], held[1]);
    let angle = names.add_angle("circle", None);
    names.angles[angle].estimated = angle_at_estimate(names, nominal, point, &circle);
    let Circle { middle, axes } = circle;
    let Vector([cos, sin]) = names.angles[angle].unit;
    Running {
        point: middle + axes[0].map(|x| cos * x) + axes[1].map(|x| sin * x),
        angle: Coordinate {
            kind: CoordinateKind::Angle(angle),
            unknown: None,
        },
    }
}

/// The circle in which two spheres meet.
fn circle<'m>(
    graph: &'m Graph,
    nominal: &Nominal,
    first: &Held<'m>,
    second: &Held<'m>,
) -> Circle<'m> {
    let (distance, along) = (second.end - first.end).length_and_unit();
    let shares = first.length.difference_of_squares(second.length) / distance;
    let foot = 0.5 * (distance + shares);
    let square = (first.length - foot) * (first.length + foot);
    let radius = square.root(first.length.square());
    let across = along.cross(least_along(graph, nominal, along)).unit();
    Circle {
        middle: first.end + foot * along,
        axes: [radius * across.cross(along), radius * across],
    }
}

/// The axis of coordinates that is farthest from a direction, at the defaults.
fn least_along<'m>(graph: &'m Graph, nominal: &Nominal, direction: V3<'m>) -> V3<'m> {
    let values = nominal.evaluate(&direction.0);
    let sizes = values.iter().map(|x| x.abs()).enumerate();
    let least = sizes.min_by(|(_, a), (_, b)| a.total_cmp(b));
    along(graph, least.map_or(0, |(index, _)| index))
}

/// The direction of an axis of coordinates.
pub(crate) fn along<'m>(graph: &'m Graph, index: usize) -> V3<'m> {
    let (zero, one) = (graph.number(0.0), graph.number(1.0));
    Vector([0, 1, 2].map(|k| if k == index { one } else { zero }))
}

/// The angle at which the point is estimated; 0 if that is nowhere.
fn angle_at_estimate<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    point: V3<'m>,
    circle: &Circle<'m>,
) -> f64 {
    let arm = point - circle.middle;
    let sides = circle.axes.map(|axis| arm.dot(axis));
    let values = nominal::at_estimates(names, nominal, &sides);
    let angle = values[1].atan2(values[0]);
    if angle.is_finite() { angle } else { 0.0 }
}
