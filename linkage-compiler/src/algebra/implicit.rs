//! Derivatives of the solutions of loops, by the implicit function theorem.
//!
//! A group of loops is `F = sum of coefficient * factor = 0`, where the factors are made of the group's own unknowns and
//! the coefficients of everything known before. Its rates by `x` solve `J r = -sum of d(coefficient)/dx * factor`, and
//! every further derivative follows by differentiating that linear system, so that the square root of the
//! closed form is never differentiated. Each rate is a symbol of its own: common parts are computed once.

use crate::algebra::body_vectors;
use crate::algebra::elimination;
use crate::algebra::links;
use crate::algebra::partial;
use crate::algebra::rotating_frame;
use crate::algebra::rows;
use crate::algebra::turns;
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
        rotating_frame::shown(self.algebra(), shown.carrier, change + turned, base)[shown.component]
    }

    /// By how much a carrier turns.
    fn turning_of(&mut self, carrier: Carrier<'m>, variable: SymbolId) -> Ex<'m> {
        let start = carrier.start.map(|x| self.slope(x, variable));
        self.slope(carrier.angle, variable) + carrier.start.cross(start)
    }

    /// What changes in fixed coordinates, seen from the carrier, which turns itself.
    fn seen_rate(&mut self, seen: &Seen<'m>, variable: SymbolId) -> Ex<'m> {
        let change = seen.vector.map(|x| self.slope(x, variable));
        let changed = rotating_frame::seen(self.algebra(), seen.carrier, change);
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
        body_vectors::slope_aboard(self, node, variable)
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
        match turns::second_turn(self, own, variable) {
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
        rates(self, group, by).rates[position]
    }
}

/// The derivatives of a group's unknowns by the variables `by`, which are in order.
pub(super) fn rates<'m>(algebra: &mut Algebra<'m>, group: usize, by: Vec<SymbolId>) -> Rates<'m> {
    let key = (group, by);
    if let Some(known) = algebra.derivatives.rates.get(&key) {
        return known.clone();
    }
    let right = right_hand_side(algebra, group, &key.1);
    let rates = match links::rates_by_products(algebra, group, &key.1) {
        Some(rates) => rates,
        None => solve(algebra, group, &right, &key.1),
    };
    let rates = Rates { right, rates };
    algebra.derivatives.rates.insert(key, rates.clone());
    rates
}

fn right_hand_side<'m>(algebra: &mut Algebra<'m>, group: usize, by: &[SymbolId]) -> Vec<Ex<'m>> {
    let (&last, before) = by.split_last().expect("a derivative has a variable");
    let solution = algebra.solutions.groups[group].clone();
    let equations = solution.jacobian[0].len();
    if before.is_empty() {
        let mut slope = |algebra: &mut Algebra<'m>, x| algebra.slope(x, last);
        let mut of_links = rows::right_of_links(algebra, group, last);
        of_links.resize(equations, None);
        return of_links
            .into_iter()
            .enumerate()
            .map(|(row, own)| match own {
                Some(own) => own,
                None => {
                    partial::sum_of_slopes(algebra, &solution.terms, row, |a, b| a - b, &mut slope)
                }
            })
            .collect();
    }
    if !solution.rows.is_empty() {
        let nothing = vec![algebra.zero(); solution.jacobian.len()];
        return rows::right_of_rows(algebra, group, by, nothing, None);
    }
    let lower = rates(algebra, group, before.to_vec());
    (0..equations)
        .map(|row| {
            let start = algebra.slope(lower.right[row], last);
            let columns = solution.jacobian.iter().zip(&lower.rates);
            columns.fold(start, |sum, (column, &rate)| {
                sum - algebra.slope(column[row], last) * rate
            })
        })
        .collect()
}

/// Cramer's rule, the determinant being known from the closed form; coupled groups are brought down to their core.
fn solve<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    right: &[Ex<'m>],
    by: &[SymbolId],
) -> Vec<Ex<'m>> {
    let solution = &algebra.solutions.groups[group];
    let (determinant, count) = (solution.determinant, solution.jacobian.len());
    if right.iter().all(|b| b.is_zero()) {
        return vec![algebra.zero(); count];
    }
    if solution.elimination.is_some() {
        return elimination::eliminate(
            algebra,
            group,
            right,
            by,
            &mut |algebra, position, rate| rate_symbol(algebra, group, position, by, rate),
        );
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
            rate_symbol(algebra, group, position, by, quotient)
        })
        .collect();
    // Where the other one does not change, only the determinant says whether the loop closes.
    if let Some((alone, row)) = triangular(&jacobian)
        && !rates[1 - alone].is_zero()
    {
        let other = jacobian[1 - alone][row] * rates[1 - alone];
        let quotient = (right[row] - other) / jacobian[alone][row];
        rates[alone] = rate_symbol(algebra, group, alone, by, quotient);
    }
    rates
}

/// A rate as a symbol of its own.
pub(super) fn rate_symbol<'m>(
    algebra: &mut Algebra<'m>,
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
    symbol_for_value(
        algebra,
        format!("rate {group}.{position} {by:?}"),
        value,
        rule,
    )
}

/// A new symbol that is computed as `value` and differentiated by a rule.
pub(crate) fn symbol_for_value<'m>(
    algebra: &mut Algebra<'m>,
    name: String,
    value: Ex<'m>,
    rule: Rule<'m>,
) -> Ex<'m> {
    let (symbol, node) = algebra.graph.unknown(name);
    algebra.graph.define(symbol, value.id());
    algebra.solutions.set_rule(symbol, rule);
    algebra.graph.ex(node)
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
