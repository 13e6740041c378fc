//! How the bodies of groups turn: what their linear systems are solved for, by variable.

use linkage_symbolic::{Ex, Node, SymbolId, V3, Vector};

use super::bodies::Shifts;
use super::{Algebra, Bodies, Rule, Value};

/// The turns of the bodies of a group by two variables.
#[derive(Clone, Debug)]
pub(super) struct Turns<'m> {
    pub(super) by: [SymbolId; 2],
    pub(super) of_bodies: [Vec<V3<'m>>; 2],
}

impl<'m> Algebra<'m> {
    /// The turns of a group's bodies by a variable, if these do nothing but turn.
    fn turns(&mut self, group: usize, variable: SymbolId) -> Option<Vec<V3<'m>>> {
        self.rates(group, vec![variable]);
        self.derivatives.turns.get(&(group, variable)).cloned()
    }

    /// The same by two variables.
    pub(super) fn turns_by_both(&mut self, group: usize, by: &[SymbolId]) -> Option<Turns<'m>> {
        let &[x, y] = by else {
            return None;
        };
        Some(Turns {
            by: [x, y],
            of_bodies: [self.turns(group, x)?, self.turns(group, y)?],
        })
    }

    /// What the directions of bodies that turn no further change by in the second derivatives: the turns by one variable times what they change
    /// by the other one.
    pub(super) fn shifts_by_turns(
        &mut self,
        bodies: &Bodies<'m>,
        group: usize,
        turns: &Turns<'m>,
    ) -> Vec<Shifts<'m>> {
        let rates = self.rates(group, vec![turns.by[1]]).rates;
        let pairs = bodies.all.iter().zip(&turns.of_bodies[0]);
        let shifts = pairs.map(|(body, turn)| {
            let changes = |columns: [usize; 3]| Vector(columns.map(|k| rates[k]));
            body.columns.map(|columns| turn.cross(changes(columns)))
        });
        shifts.collect()
    }

    /// The vector by which a frame turns, which is equal to `turning`: that of the body that it is, whose system is solved for it.
    pub(crate) fn as_turn_of_body(
        &mut self,
        frame: &Value<'m>,
        variable: SymbolId,
        turning: Value<'m>,
    ) -> Value<'m> {
        let Some(turn) = self.turn_of_body(frame, variable) else {
            return turning;
        };
        let equal = self.space_vector(&turning);
        let own = [0, 1, 2].map(|k| match turn[k].constant_value() {
            Some(_) => turn[k],
            None => self.turn_as_symbol(turn[k], equal[k]),
        });
        Value::Vector(Vector(own).into())
    }

    /// A component of a turn, which is equal to another expression: derivatives are those of that. It is a quotient of large sums itself.
    fn turn_as_symbol(&mut self, turn: Ex<'m>, equal: Ex<'m>) -> Ex<'m> {
        if let Some(&known) = self.derivatives.turns_as_symbols.get(&turn.id()) {
            return known;
        }
        let symbol =
            self.symbol_for_value(format!("turn {:?}", turn.id()), turn, Rule::Follow(equal));
        self.derivatives.turns_as_symbols.insert(turn.id(), symbol);
        symbol
    }

    /// The turn of the body that a frame is.
    fn turn_of_body(&mut self, frame: &Value<'m>, variable: SymbolId) -> Option<V3<'m>> {
        let [_, axes @ ..] = self.frame_parts(frame);
        let places = axes.map(|axis| self.places_of(axis));
        let group = places.iter().flatten().map(|(group, _)| *group).next()?;
        let elimination = self.solutions.groups[group].elimination.as_ref()?;
        let bodies = &elimination.scheme.as_ref()?.bodies.all;
        let is_axis = |columns: &[usize; 3]| places.contains(&Some((group, *columns)));
        let body = bodies
            .iter()
            .position(|body| body.columns.iter().all(is_axis))?;
        self.turns(group, variable)?.get(body).copied()
    }

    /// The places of a direction's components among the unknowns of a group.
    fn places_of(&self, axis: V3<'m>) -> Option<(usize, [usize; 3])> {
        let place = |k: usize| match axis[k].node() {
            Node::Symbol(symbol) => match self.solutions.rule(symbol)? {
                Rule::Unknown { group, position } => Some((*group, *position)),
                _ => None,
            },
            _ => None,
        };
        let [(group, x), (second, y), (third, z)] = [place(0)?, place(1)?, place(2)?];
        (group == second && group == third).then_some((group, [x, y, z]))
    }
}
