//! Rotation variations of the bodies of groups, by variable: the unknowns of their linear systems.

use linkage_symbolic::{Ex, Graph, Node, NodeId, SymbolId, V3, Vector};

use crate::algebra::bodies::{Bodies, Shifts};
use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule;
use crate::algebra::derivatives::by_rule::{GroupRates, RuleCalculus};
use crate::algebra::frame;
use crate::algebra::memo::DerivativeMemos;
use crate::algebra::rules::{DerivativeRule, RotationRule};
use crate::algebra::solutions::Solutions;
use crate::algebra::value::Value;

/// Returns the derivative of a component of a vector on a body, where the rotation of the body is
/// known.
pub(crate) fn slope_of_body_vector(
    algebra: &mut Algebra<'_>,
    node: NodeId,
    variable: SymbolId,
) -> Option<NodeId> {
    if algebra.derivatives.held > 0 {
        return None;
    }
    let carried = algebra.names.body_vectors.get(&node)?.clone();
    algebra.derivatives.offered.turns = true;
    if !algebra.solutions.shortcuts.turns {
        return None;
    }
    let mut coordinates = carried.coordinates.0.into_iter();
    if !coordinates.all(|x| algebra.slope(x, variable).is_zero()) {
        return None;
    }
    let turn = rotation_of_body_with(algebra, &carried.axes, variable)?;
    Some(turn.cross(carried.vector)[carried.component].id())
}

/// The turns of the bodies of a group by two variables.
#[derive(Clone, Debug)]
pub(crate) struct BodyRotations<'m> {
    pub(crate) by: [SymbolId; 2],
    pub(crate) of_bodies: [Vec<V3<'m>>; 2],
}

/// The turns of a group's bodies by a variable, if these do nothing but turn.
fn rotations_by<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    variable: SymbolId,
) -> Option<Vec<V3<'m>>> {
    algebra.rates(group, vec![variable]);
    algebra
        .derivatives
        .rotations
        .get(&(group, variable))
        .cloned()
}

/// The same by two variables.
pub(crate) fn rotations_by_both<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    by: &[SymbolId],
) -> Option<BodyRotations<'m>> {
    let &[x, y] = by else {
        return None;
    };
    Some(BodyRotations {
        by: [x, y],
        of_bodies: [
            rotations_by(algebra, group, x)?,
            rotations_by(algebra, group, y)?,
        ],
    })
}

/// Returns the changes of the directions of bodies that turn no further, in the second derivatives:
/// the turns by one variable times the changes by the other one.
pub(crate) fn shifts_by_rotations<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Bodies<'m>,
    group: usize,
    turns: &BodyRotations<'m>,
) -> Vec<Shifts<'m>> {
    let rates = algebra.rates(group, vec![turns.by[1]]).rates;
    let pairs = bodies.list.iter().zip(&turns.of_bodies[0]);
    let shifts = pairs.map(|(body, turn)| {
        let changes = |columns: [usize; 3]| Vector(columns.map(|k| rates[k]));
        body.columns.map(|columns| turn.cross(changes(columns)))
    });
    shifts.collect()
}

/// The vector by which an unknown frame turns, as symbols: its group's system is solved for it.
pub(crate) fn rotation_of_frame<'m>(
    algebra: &mut Algebra<'m>,
    frame: &Value<'m>,
    variable: SymbolId,
) -> Option<Value<'m>> {
    let [_, axes @ ..] = frame::frame_parts(&algebra.names, frame);
    let turn = rotation_of_body_with(algebra, &axes, variable)?;
    Some(Value::Vector(turn.into()))
}

/// The turn of the body that has two of these directions, as symbols.
pub(crate) fn rotation_of_body_with<'m>(
    algebra: &mut Algebra<'m>,
    axes: &[V3<'m>],
    variable: SymbolId,
) -> Option<V3<'m>> {
    let (group, body, [u, w]) = body_with(&algebra.solutions, axes)?;
    let turn = *rotations_by(algebra, group, variable)?.get(body)?;
    let equal = rotation_of_directions(algebra, [u, w], variable);
    let by = vec![variable];
    let symbols = [0, 1, 2].map(|component| {
        let rule = RotationRule {
            group,
            body,
            component,
            by: by.clone(),
            equal: equal[component],
        };
        rotation_as_symbol(
            algebra.graph,
            &mut algebra.solutions,
            &mut algebra.derivatives,
            turn[component],
            rule,
        )
    });
    Some(Vector(symbols))
}

/// Returns the turn of two perpendicular directions, from their derivatives: `u x u' + (w' . (u x
/// w)) u`.
fn rotation_of_directions<'m>(
    algebra: &mut Algebra<'m>,
    [u, w]: [V3<'m>; 2],
    variable: SymbolId,
) -> V3<'m> {
    let [u1, w1] = [u, w].map(|axis| axis.map(|x| algebra.slope(x, variable)));
    u.cross(u1) + w1.dot(u.cross(w)) * u
}

/// Returns the change of a component of a turn with a second variable, from the system of second
/// derivatives.
pub(crate) fn second_rotation<'m>(
    algebra: &mut Algebra<'m>,
    rule: &RotationRule<'m>,
    variable: SymbolId,
) -> Option<Ex<'m>> {
    let &[first] = &rule.by[..] else {
        return None;
    };
    if algebra.derivatives.held > 0 {
        return None;
    }
    algebra.derivatives.offered.turns = true;
    if !algebra.solutions.shortcuts.turns {
        return None;
    }
    let mut by = [first, variable];
    by.sort_unstable();
    algebra.rates(rule.group, by.to_vec());
    let turns = algebra
        .derivatives
        .second_rotations
        .get(&(rule.group, by))?;
    let mut turn = turns[rule.body][rule.component];
    if by[0] != first {
        // Turns by both do not commute: `dt/dx` of the turn by y is `ds/dy` of that by x and `s x
        // t`.
        let [s, t] = [variable, first].map(|v| rotations_by(algebra, rule.group, v));
        turn += s?[rule.body].cross(t?[rule.body])[rule.component];
    }
    let equal = algebra.slope(rule.equal, variable);
    let rule = RotationRule {
        by: vec![first, variable],
        equal,
        ..rule.clone()
    };
    Some(rotation_as_symbol(
        algebra.graph,
        &mut algebra.solutions,
        &mut algebra.derivatives,
        turn,
        rule,
    ))
}

/// A component of a turn.
fn rotation_as_symbol<'m>(
    graph: &'m Graph,
    solutions: &mut Solutions<'m>,
    derivatives: &mut DerivativeMemos<'m>,
    turn: Ex<'m>,
    rule: RotationRule<'m>,
) -> Ex<'m> {
    if turn.constant_value().is_some() {
        return turn;
    }
    if let Some(&known) = derivatives.rotation_symbols.get(&turn.id()) {
        return known;
    }
    let name = format!("turn {:?}", turn.id());
    let symbol = by_rule::symbol_for_value(
        graph,
        solutions,
        name,
        turn,
        DerivativeRule::Rotation(Box::new(rule)),
    );
    derivatives.rotation_symbols.insert(turn.id(), symbol);
    symbol
}

/// The body that has two of some directions, by its group and its place there, with them.
fn body_with<'m>(
    solutions: &Solutions<'m>,
    axes: &[V3<'m>],
) -> Option<(usize, usize, [V3<'m>; 2])> {
    let places: Vec<_> = axes
        .iter()
        .map(|&axis| positions_of(solutions, axis))
        .collect();
    let group = places.iter().flatten().map(|(group, _)| *group).next()?;
    let elimination = solutions.groups[group].elimination.as_ref()?;
    let bodies = &elimination.scheme.as_ref()?.bodies.list;
    let axis_of = |columns: &[usize; 3]| {
        places
            .iter()
            .position(|axis| *axis == Some((group, *columns)))
    };
    let mut found = bodies.iter().enumerate().filter_map(|(index, body)| {
        let [u, w] = body.columns.each_ref().map(axis_of);
        Some((group, index, [axes[u?], axes[w?]]))
    });
    found.next()
}

/// The places of a direction's components among the unknowns of a group.
fn positions_of(solutions: &Solutions, axis: V3) -> Option<(usize, [usize; 3])> {
    let unknown = |k: usize| match axis[k].node() {
        Node::Symbol(symbol) => match solutions.rule(symbol)? {
            DerivativeRule::Unknown { group, position } => Some((*group, *position)),
            _ => None,
        },
        _ => None,
    };
    let [(group, x), (second, y), (third, z)] = [unknown(0)?, unknown(1)?, unknown(2)?];
    (group == second && group == third).then_some((group, [x, y, z]))
}
