//! Derivatives of symbols by their rules, for total and for partial derivatives.

use linkage_symbolic::{Calculus, Ex, Graph, NodeId, SymbolId, differentiate};

use crate::algebra::context::Algebra;
use crate::algebra::memo::Rates;
use crate::algebra::rotating_frame;
use crate::algebra::rules::{
    AngleRule, DerivativeRule, FromFrame, RotatingFrame, RotationRule, ToFrame, TurnedVector,
};
use crate::algebra::solutions::Solutions;

/// The derivatives of the unknowns of groups.
///
/// A trait, since they are built from the functions that use them: rows, links and rotations
/// differentiate with it, and `implicit`, above these files, implements it.
pub(crate) trait GroupRates<'m> {
    /// Returns the derivatives of a group's unknowns by the variables `by`, which are in order.
    fn rates(&mut self, group: usize, by: Vec<SymbolId>) -> Rates<'m>;
}

/// The rules of differentiation, given how unknowns and rates depend on a variable.
pub(crate) trait RuleCalculus<'m>: Calculus<'m> {
    fn algebra(&mut self) -> &mut Algebra<'m>;

    /// The derivative by `variable` of unknown `position` of a group, or of its derivative `by`
    /// some variables.
    fn rate(
        &mut self,
        group: usize,
        position: usize,
        by: Vec<SymbolId>,
        variable: SymbolId,
    ) -> Ex<'m>;

    fn slope(&mut self, x: Ex<'m>, variable: SymbolId) -> Ex<'m> {
        let graph = self.graph();
        graph.ex(differentiate(self, x.id(), variable))
    }

    fn derivative_by_rule(&mut self, symbol: SymbolId, variable: SymbolId) -> NodeId {
        let Some(rule) = self.algebra().solutions.rule(symbol).cloned() else {
            return self.graph().zero();
        };
        let rate = match rule {
            DerivativeRule::Follow(equal) => self.slope(equal, variable),
            DerivativeRule::Rotation(rotation) => self.rate_of_rotation(&rotation, variable),
            DerivativeRule::Cosine(rule) => {
                let rate = self.rate_of_angle(rule, variable);
                -(rule.unit[1] * rate)
            }
            DerivativeRule::Sine(rule) => {
                let rate = self.rate_of_angle(rule, variable);
                rule.unit[0] * rate
            }
            DerivativeRule::Value(rule) => self.rate_of_angle(rule, variable),
            DerivativeRule::TurnedVector(turning) => self.rate_of_turned_vector(&turning, variable),
            DerivativeRule::ToFrame(to_frame) => self.rate_of_to_frame(&to_frame, variable),
            DerivativeRule::FromFrame(from_frame) => self.rate_of_from_frame(&from_frame, variable),
            DerivativeRule::Axis(axis) => {
                let (link_frame, component) = *axis;
                self.rotation_of_frame(link_frame, variable) * link_frame.axis.perp()[component]
            }
            DerivativeRule::Unknown { group, position } => {
                self.rate(group, position, Vec::new(), variable)
            }
            DerivativeRule::Rate {
                group,
                position,
                by,
            } => self.rate(group, position, by, variable),
        };
        rate.id()
    }

    /// The derivative of a component of a turn.
    fn rate_of_rotation(&mut self, rule: &RotationRule<'m>, variable: SymbolId) -> Ex<'m> {
        self.slope(rule.equal, variable)
    }

    fn rate_of_angle(&mut self, rule: AngleRule<'m>, variable: SymbolId) -> Ex<'m> {
        let rate = self.rate(rule.group, rule.position, Vec::new(), variable);
        let rate = match rule.link_frame {
            Some(link_frame) => rate + self.rotation_of_frame(link_frame, variable),
            None => rate,
        };
        rule.sensed(rate)
    }

    /// Returns the change as seen from the frame, and by its rotation, in fixed coordinates.
    fn rate_of_from_frame(&mut self, from_frame: &FromFrame<'m>, variable: SymbolId) -> Ex<'m> {
        let [change, base] = [from_frame.vector, from_frame.base]
            .map(|vector| vector.map(|x| self.slope(x, variable)));
        let turned =
            self.rotation_of_frame(from_frame.link_frame, variable) * from_frame.vector.perp();
        let algebra = self.algebra();
        let vector = change + turned;
        let (graph, solutions) = (algebra.graph, &mut algebra.solutions);
        rotating_frame::from_frame(graph, solutions, from_frame.link_frame, vector, base)
            [from_frame.component]
    }

    /// Returns the rotation of a frame.
    fn rotation_of_frame(&mut self, link_frame: RotatingFrame<'m>, variable: SymbolId) -> Ex<'m> {
        let start = link_frame.start.map(|x| self.slope(x, variable));
        self.slope(link_frame.angle, variable) + link_frame.start.cross(start)
    }

    /// Returns the change in fixed coordinates, as seen from the frame, which rotates itself.
    fn rate_of_to_frame(&mut self, to_frame: &ToFrame<'m>, variable: SymbolId) -> Ex<'m> {
        let change = to_frame.vector.map(|x| self.slope(x, variable));
        let algebra = self.algebra();
        let (graph, solutions) = (algebra.graph, &mut algebra.solutions);
        let changed = rotating_frame::to_frame(graph, solutions, to_frame.link_frame, change);
        let turned =
            self.rotation_of_frame(to_frame.link_frame, variable) * to_frame.in_frame.perp();
        (changed - turned)[to_frame.component]
    }

    /// `z' u + rate perp(z u)`
    fn rate_of_turned_vector(&mut self, turning: &TurnedVector<'m>, variable: SymbolId) -> Ex<'m> {
        let &TurnedVector {
            group,
            position,
            component,
            vector,
            z,
            unit,
        } = turning;
        let stretch = z.map(|x| self.slope(x, variable));
        let stretched = stretch.turned(unit);
        let rate = self.rate(group, position, Vec::new(), variable);
        let across = vector.perp();
        stretched[component] + rate * across[component]
    }
}

/// A rate as a symbol of its own.
pub(crate) fn rate_symbol<'m>(
    graph: &'m Graph,
    solutions: &mut Solutions<'m>,
    group: usize,
    position: usize,
    by: &[SymbolId],
    value: Ex<'m>,
) -> Ex<'m> {
    if value.constant_value().is_some() {
        return value;
    }
    let rule = DerivativeRule::Rate {
        group,
        position,
        by: by.to_vec(),
    };
    symbol_for_value(
        graph,
        solutions,
        format!("rate {group}.{position} {by:?}"),
        value,
        rule,
    )
}

/// A new symbol that is computed as `value` and differentiated by a rule.
pub(crate) fn symbol_for_value<'m>(
    graph: &'m Graph,
    solutions: &mut Solutions<'m>,
    name: String,
    value: Ex<'m>,
    rule: DerivativeRule<'m>,
) -> Ex<'m> {
    let (symbol, node) = graph.unknown(name);
    graph.define(symbol, value.id());
    solutions.set_rule(symbol, rule);
    graph.ex(node)
}
