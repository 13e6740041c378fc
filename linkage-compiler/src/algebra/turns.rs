//! How the bodies of groups turn: what their linear systems are solved for, by variable.

use crate::algebra::frame;
use crate::algebra::implicit;
use linkage_symbolic::{Ex, Node, SymbolId, V3, Vector};

use super::bodies::Shifts;
use super::implicit::Implicit;
use super::solutions::TurnRule;
use super::{Algebra, Bodies, Rule, Value};

/// The turns of the bodies of a group by two variables.
#[derive(Clone, Debug)]
pub(super) struct Turns<'m> {
    pub(super) by: [SymbolId; 2],
    pub(super) of_bodies: [Vec<V3<'m>>; 2],
}

/// The turns of a group's bodies by a variable, if these do nothing but turn.
fn turns_by<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    variable: SymbolId,
) -> Option<Vec<V3<'m>>> {
    implicit::rates(algebra, group, vec![variable]);
    algebra.derivatives.turns.get(&(group, variable)).cloned()
}

/// The same by two variables.
pub(super) fn turns_by_both<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    by: &[SymbolId],
) -> Option<Turns<'m>> {
    let &[x, y] = by else {
        return None;
    };
    Some(Turns {
        by: [x, y],
        of_bodies: [turns_by(algebra, group, x)?, turns_by(algebra, group, y)?],
    })
}

/// What the directions of bodies that turn no further change by in the second derivatives: the turns by one variable times what they change
/// by the other one.
pub(super) fn shifts_by_turns<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Bodies<'m>,
    group: usize,
    turns: &Turns<'m>,
) -> Vec<Shifts<'m>> {
    let rates = implicit::rates(algebra, group, vec![turns.by[1]]).rates;
    let pairs = bodies.all.iter().zip(&turns.of_bodies[0]);
    let shifts = pairs.map(|(body, turn)| {
        let changes = |columns: [usize; 3]| Vector(columns.map(|k| rates[k]));
        body.columns.map(|columns| turn.cross(changes(columns)))
    });
    shifts.collect()
}

/// The vector by which an unknown frame turns, as symbols: its group's system is solved for it.
pub(crate) fn turn_of_frame<'m>(
    algebra: &mut Algebra<'m>,
    frame: &Value<'m>,
    variable: SymbolId,
) -> Option<Value<'m>> {
    let [_, axes @ ..] = frame::frame_parts(algebra, frame);
    let turn = turn_about(algebra, &axes, variable)?;
    Some(Value::Vector(turn.into()))
}

/// The turn of the body that has two of these directions, as symbols.
pub(super) fn turn_about<'m>(
    algebra: &mut Algebra<'m>,
    axes: &[V3<'m>],
    variable: SymbolId,
) -> Option<V3<'m>> {
    let (group, body, [u, w]) = body_with(algebra, axes)?;
    let turn = *turns_by(algebra, group, variable)?.get(body)?;
    let equal = turn_of_directions(algebra, [u, w], variable);
    let by = vec![variable];
    let own = [0, 1, 2].map(|component| {
        let rule = TurnRule {
            group,
            body,
            component,
            by: by.clone(),
            equal: equal[component],
        };
        turn_as_symbol(algebra, turn[component], rule)
    });
    Some(Vector(own))
}

/// By how much two perpendicular directions turn, from their derivatives: `u x u' + (w' . (u x w)) u`.
fn turn_of_directions<'m>(
    algebra: &mut Algebra<'m>,
    [u, w]: [V3<'m>; 2],
    variable: SymbolId,
) -> V3<'m> {
    let [u1, w1] = [u, w].map(|axis| axis.map(|x| algebra.slope(x, variable)));
    u.cross(u1) + w1.dot(u.cross(w)) * u
}

/// What a component of a turn changes by with a second variable, from the system of second derivatives.
pub(super) fn second_turn<'m>(
    algebra: &mut Algebra<'m>,
    own: &TurnRule<'m>,
    variable: SymbolId,
) -> Option<Ex<'m>> {
    let &[first] = &own.by[..] else {
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
    implicit::rates(algebra, own.group, by.to_vec());
    let turns = algebra.derivatives.second_turns.get(&(own.group, by))?;
    let mut turn = turns[own.body][own.component];
    if by[0] != first {
        // Turns by both do not commute: `dt/dx` of the turn by y is `ds/dy` of that by x and `s x t`.
        let [s, t] = [variable, first].map(|v| turns_by(algebra, own.group, v));
        turn += s?[own.body].cross(t?[own.body])[own.component];
    }
    let equal = algebra.slope(own.equal, variable);
    let rule = TurnRule {
        by: vec![first, variable],
        equal,
        ..own.clone()
    };
    Some(turn_as_symbol(algebra, turn, rule))
}

/// A component of a turn.
fn turn_as_symbol<'m>(algebra: &mut Algebra<'m>, turn: Ex<'m>, rule: TurnRule<'m>) -> Ex<'m> {
    if turn.constant_value().is_some() {
        return turn;
    }
    if let Some(&known) = algebra.derivatives.turns_as_symbols.get(&turn.id()) {
        return known;
    }
    let name = format!("turn {:?}", turn.id());
    let symbol = implicit::symbol_for_value(algebra, name, turn, Rule::Turn(Box::new(rule)));
    algebra
        .derivatives
        .turns_as_symbols
        .insert(turn.id(), symbol);
    symbol
}

/// The body that has two of some directions, by its group and its place there, with them.
fn body_with<'m>(algebra: &Algebra<'m>, axes: &[V3<'m>]) -> Option<(usize, usize, [V3<'m>; 2])> {
    let places: Vec<_> = axes.iter().map(|&axis| places_of(algebra, axis)).collect();
    let group = places.iter().flatten().map(|(group, _)| *group).next()?;
    let elimination = algebra.solutions.groups[group].elimination.as_ref()?;
    let bodies = &elimination.scheme.as_ref()?.bodies.all;
    let place = |columns: &[usize; 3]| {
        places
            .iter()
            .position(|own| *own == Some((group, *columns)))
    };
    let mut found = bodies.iter().enumerate().filter_map(|(index, body)| {
        let [u, w] = body.columns.each_ref().map(place);
        Some((group, index, [axes[u?], axes[w?]]))
    });
    found.next()
}

/// The places of a direction's components among the unknowns of a group.
fn places_of<'m>(algebra: &Algebra<'m>, axis: V3<'m>) -> Option<(usize, [usize; 3])> {
    let place = |k: usize| match axis[k].node() {
        Node::Symbol(symbol) => match algebra.solutions.rule(symbol)? {
            Rule::Unknown { group, position } => Some((*group, *position)),
            _ => None,
        },
        _ => None,
    };
    let [(group, x), (second, y), (third, z)] = [place(0)?, place(1)?, place(2)?];
    (group == second && group == third).then_some((group, [x, y, z]))
}
