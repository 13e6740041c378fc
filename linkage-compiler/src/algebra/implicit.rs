//! Derivatives of the solutions of loops, by the implicit function theorem.
//!
//! A group of loops is `F = sum of coefficient * factor = 0`, where the factors are made of the group's own unknowns and
//! the coefficients of everything known before. Its rates by `x` solve `J r = -sum of d(coefficient)/dx * factor`, and
//! every further derivative follows by differentiating that linear system, so that the square root of the
//! closed form is never differentiated. Each rate is a symbol of its own: common parts are computed once.

use linkage_symbolic::{
    Calculus, DerivativeMemo, Ex, Graph, NodeId, SymbolId, Vector, differentiate,
};

use super::solutions::{Seen, Shown, TurnRule};
use super::{Algebra, AngleRule, Carrier, Rule, Turning};

/// Derivatives of a group's unknowns by some variables, and the right-hand side that they solve.
#[derive(Clone, Debug)]
pub(super) struct Rates<'m> {
    pub(super) right: Vec<Ex<'m>>,
    pub(super) rates: Vec<Ex<'m>>,
}

/// The rules of differentiation, given how unknowns and rates depend on a variable.
pub(super) trait Implicit<'m>: Calculus<'m> {
    fn algebra(&mut self) -> &mut Algebra<'m>;

    /// The derivative by `variable` of unknown `position` of a group, or of its derivative `by` some variables.
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
            Rule::Follow(equal) => self.slope(equal, variable),
            Rule::Turn(own) => self.rate_of_turn(&own, variable),
            Rule::Cosine(rule) => {
                let rate = self.angle_rate(rule, variable);
                -(rule.unit[1] * rate)
            }
            Rule::Sine(rule) => {
                let rate = self.angle_rate(rule, variable);
                rule.unit[0] * rate
            }
            Rule::Value(rule) => self.angle_rate(rule, variable),
            Rule::Turning(turning) => self.turning_rate(&turning, variable),
            Rule::Seen(seen) => self.seen_rate(&seen, variable),
            Rule::Shown(shown) => self.shown_rate(&shown, variable),
            Rule::Axis(own) => {
                let (carrier, component) = *own;
                self.turning_of(carrier, variable) * carrier.axis.perp()[component]
            }
            Rule::Unknown { group, position } => self.rate(group, position, Vec::new(), variable),
            Rule::Rate {
                group,
                position,
                by,
            } => self.rate(group, position, by, variable),
        };
        rate.id()
    }

    /// The derivative of a component of a turn.
    fn rate_of_turn(&mut self, own: &TurnRule<'m>, variable: SymbolId) -> Ex<'m> {
        self.slope(own.equal, variable)
    }

    fn angle_rate(&mut self, rule: AngleRule<'m>, variable: SymbolId) -> Ex<'m> {
        let rate = self.rate(rule.group, rule.position, Vec::new(), variable);
        let rate = match rule.carrier {
            Some(carrier) => rate + self.turning_of(carrier, variable),
            None => rate,
        };
        rule.sensed(rate)
    }

    /// What changes seen from the carrier and by its turning, in fixed coordinates.
    fn shown_rate(&mut self, shown: &Shown<'m>, variable: SymbolId) -> Ex<'m> {
        let [change, base] =
            [shown.vector, shown.base].map(|own| own.map(|x| self.slope(x, variable)));
        let turned = self.turning_of(shown.carrier, variable) * shown.vector.perp();
        self.algebra().shown(shown.carrier, change + turned, base)[shown.component]
    }

    /// By how much a carrier turns.
    fn turning_of(&mut self, carrier: Carrier<'m>, variable: SymbolId) -> Ex<'m> {
        let start = carrier.start.map(|x| self.slope(x, variable));
        self.slope(carrier.angle, variable) + carrier.start.cross(start)
    }

    /// What changes in fixed coordinates, seen from the carrier, which turns itself.
    fn seen_rate(&mut self, seen: &Seen<'m>, variable: SymbolId) -> Ex<'m> {
        let change = seen.vector.map(|x| self.slope(x, variable));
        let changed = self.algebra().seen(seen.carrier, change);
        let turned = self.turning_of(seen.carrier, variable) * seen.own.perp();
        (changed - turned)[seen.component]
    }

    /// `z' u + rate perp(z u)`
    fn turning_rate(&mut self, turning: &Turning<'m>, variable: SymbolId) -> Ex<'m> {
        let &Turning {
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

impl<'m> Calculus<'m> for Algebra<'m> {
    fn graph(&self) -> &'m Graph {
        self.graph
    }

    fn memo(&mut self) -> &mut DerivativeMemo {
        &mut self.derivatives.memo
    }

    fn known_derivative(&mut self, node: NodeId, variable: SymbolId) -> Option<NodeId> {
        self.slope_aboard(node, variable)
    }

    fn symbol_derivative(&mut self, symbol: SymbolId, variable: SymbolId) -> NodeId {
        self.derivative_by_rule(symbol, variable)
    }
}

impl<'m> Implicit<'m> for Algebra<'m> {
    fn algebra(&mut self) -> &mut Algebra<'m> {
        self
    }

    fn rate_of_turn(&mut self, own: &TurnRule<'m>, variable: SymbolId) -> Ex<'m> {
        match self.second_turn(own, variable) {
            Some(turn) => turn,
            None => self.slope(own.equal, variable),
        }
    }

    fn rate(
        &mut self,
        group: usize,
        position: usize,
        mut by: Vec<SymbolId>,
        variable: SymbolId,
    ) -> Ex<'m> {
        by.push(variable);
        by.sort_unstable();
        self.rates(group, by).rates[position]
    }
}

impl<'m> Algebra<'m> {
    /// The derivatives of a group's unknowns by the variables `by`, which are in order.
    pub(super) fn rates(&mut self, group: usize, by: Vec<SymbolId>) -> Rates<'m> {
        let key = (group, by);
        if let Some(known) = self.derivatives.rates.get(&key) {
            return known.clone();
        }
        let right = self.right_hand_side(group, &key.1);
        let rates = match self.rates_by_products(group, &key.1) {
            Some(rates) => rates,
            None => self.solve(group, &right, &key.1),
        };
        let rates = Rates { right, rates };
        self.derivatives.rates.insert(key, rates.clone());
        rates
    }

    fn right_hand_side(&mut self, group: usize, by: &[SymbolId]) -> Vec<Ex<'m>> {
        let (&last, before) = by.split_last().expect("a derivative has a variable");
        let solution = self.solutions.groups[group].clone();
        let equations = solution.jacobian[0].len();
        if before.is_empty() {
            let mut slope = |algebra: &mut Self, x| algebra.slope(x, last);
            let mut of_links = self.right_of_links(group, last);
            of_links.resize(equations, None);
            return of_links
                .into_iter()
                .enumerate()
                .map(|(row, own)| match own {
                    Some(own) => own,
                    None => self.sum_of_slopes(&solution.terms, row, |a, b| a - b, &mut slope),
                })
                .collect();
        }
        if !solution.rows.is_empty() {
            let nothing = vec![self.zero(); solution.jacobian.len()];
            return self.right_of_rows(group, by, nothing, None);
        }
        let lower = self.rates(group, before.to_vec());
        (0..equations)
            .map(|row| {
                let start = self.slope(lower.right[row], last);
                let columns = solution.jacobian.iter().zip(&lower.rates);
                columns.fold(start, |sum, (column, &rate)| {
                    sum - self.slope(column[row], last) * rate
                })
            })
            .collect()
    }

    /// Cramer's rule, the determinant being known from the closed form; coupled groups are brought down to their core.
    fn solve(&mut self, group: usize, right: &[Ex<'m>], by: &[SymbolId]) -> Vec<Ex<'m>> {
        let solution = &self.solutions.groups[group];
        let (determinant, count) = (solution.determinant, solution.jacobian.len());
        if right.iter().all(|b| b.is_zero()) {
            return vec![self.zero(); count];
        }
        if solution.elimination.is_some() {
            return self.eliminate(group, right, by, &mut |algebra, position, rate| {
                algebra.rate_symbol(group, position, by, rate)
            });
        }
        let numerators = match *right {
            [b] => vec![b],
            [x, y] => {
                let right = Vector([x, y]);
                let [first, second] = [0, 1].map(|k| {
                    let column = &solution.jacobian[k];
                    Vector([column[0], column[1]])
                });
                vec![right.cross(second), first.cross(right)]
            }
            _ => unreachable!("closed forms have one or two equations"),
        };
        let jacobian = solution.jacobian.clone();
        let mut rates: Vec<Ex> = (0..count)
            .map(|position| {
                let quotient = numerators[position] / determinant;
                self.rate_symbol(group, position, by, quotient)
            })
            .collect();
        // Where the other one does not change, only the determinant says whether the loop closes.
        if let Some((alone, row)) = triangular(&jacobian)
            && !rates[1 - alone].is_zero()
        {
            let other = jacobian[1 - alone][row] * rates[1 - alone];
            let quotient = (right[row] - other) / jacobian[alone][row];
            rates[alone] = self.rate_symbol(group, alone, by, quotient);
        }
        rates
    }

    /// A rate as a symbol of its own.
    pub(super) fn rate_symbol(
        &mut self,
        group: usize,
        position: usize,
        by: &[SymbolId],
        value: Ex<'m>,
    ) -> Ex<'m> {
        if value.constant_value().is_some() {
            return value;
        }
        let rule = Rule::Rate {
            group,
            position,
            by: by.to_vec(),
        };
        self.symbol_for_value(format!("rate {group}.{position} {by:?}"), value, rule)
    }

    /// A new symbol that is computed as `value` and differentiated by a rule.
    pub(crate) fn symbol_for_value(
        &mut self,
        name: String,
        value: Ex<'m>,
        rule: Rule<'m>,
    ) -> Ex<'m> {
        let (symbol, node) = self.graph.unknown(name);
        self.graph.define(symbol, value.id());
        self.solutions.set_rule(symbol, rule);
        self.graph.ex(node)
    }
}

/// Of two equations, the unknown that only one of them contains, and which.
fn triangular(jacobian: &[Vec<Ex>]) -> Option<(usize, usize)> {
    if jacobian.len() != 2 {
        return None;
    }
    let places = [(0, 0), (0, 1), (1, 0), (1, 1)];
    let mut zeros = places
        .into_iter()
        .filter(|&(column, row)| jacobian[column][row].is_zero());
    zeros.next().map(|(column, row)| (column, 1 - row))
}
