//! Derivatives of the solutions of loops, by the implicit function theorem.
//!
//! A group of loops is `F = sum of coefficient * factor = 0`, where the factors are made of the
//! group's own unknowns and the coefficients of everything known before. Its rates by `x` solve `J
//! r = -sum of d(coefficient)/dx * factor`, and every further derivative follows by differentiating
//! that linear system, so that the square root of the closed form is never differentiated. Each
//! rate is a symbol of its own: common parts are computed once.

use linkage_symbolic::{Calculus, DerivativeMemo, Ex, Graph, NodeId, SymbolId, Vector};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule::{GroupRates, RuleCalculus};
use crate::algebra::derivatives::{
    by_rule, elimination, links, partial, rotation_variation, written_rows,
};
use crate::algebra::memo::Rates;
use crate::algebra::rules::RotationRule;

impl<'m> Calculus<'m> for Algebra<'m> {
    fn graph(&self) -> &'m Graph {
        self.graph
    }

    fn memo(&mut self) -> &mut DerivativeMemo {
        &mut self.derivatives.memo
    }

    fn known_derivative(&mut self, node: NodeId, variable: SymbolId) -> Option<NodeId> {
        rotation_variation::slope_of_body_vector(self, node, variable)
    }

    fn symbol_derivative(&mut self, symbol: SymbolId, variable: SymbolId) -> NodeId {
        self.derivative_by_rule(symbol, variable)
    }
}

impl<'m> RuleCalculus<'m> for Algebra<'m> {
    fn algebra(&mut self) -> &mut Algebra<'m> {
        self
    }

    fn rate_of_rotation(&mut self, rule: &RotationRule<'m>, variable: SymbolId) -> Ex<'m> {
        match rotation_variation::second_rotation(self, rule, variable) {
            Some(turn) => turn,
            None => self.slope(rule.equal, variable),
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

impl<'m> GroupRates<'m> for Algebra<'m> {
    fn rates(&mut self, group: usize, by: Vec<SymbolId>) -> Rates<'m> {
        let key = (group, by);
        if let Some(known) = self.derivatives.rates.get(&key) {
            return known.clone();
        }
        let right = right_hand_side(self, group, &key.1);
        let rates = match links::rates_by_products(self, group, &key.1) {
            Some(rates) => rates,
            None => solve(self, group, &right, &key.1),
        };
        let rates = Rates { right, rates };
        self.derivatives.rates.insert(key, rates.clone());
        rates
    }
}

fn right_hand_side<'m>(algebra: &mut Algebra<'m>, group: usize, by: &[SymbolId]) -> Vec<Ex<'m>> {
    let (&last, before) = by.split_last().expect("a derivative has a variable");
    let solution = algebra.solutions.groups[group].clone();
    let equations = solution.jacobian[0].len();
    if before.is_empty() {
        let mut of_links = written_rows::right_of_links(algebra, group, last);
        of_links.resize(equations, None);
        return of_links
            .into_iter()
            .enumerate()
            .map(|(row, known)| match known {
                Some(known) => known,
                None => {
                    let zero = algebra.zero();
                    let mut slope = |x| algebra.slope(x, last);
                    partial::sum_of_slopes(zero, &solution.terms, row, |a, b| a - b, &mut slope)
                }
            })
            .collect();
    }
    if !solution.rows.is_empty() {
        let nothing = vec![algebra.zero(); solution.jacobian.len()];
        return written_rows::right_of_rows(algebra, group, by, nothing, None);
    }
    let lower = algebra.rates(group, before.to_vec());
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

/// Cramer's rule, the determinant being known from the closed form; coupled groups are brought down
/// to their core.
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
        return elimination::eliminate(algebra, group, right, by);
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
            by_rule::rate_symbol(
                algebra.graph,
                &mut algebra.solutions,
                group,
                position,
                by,
                quotient,
            )
        })
        .collect();
    // The determinant alone shows whether the loop closes where the other one does not change.
    if let Some((alone, row)) = triangular(&jacobian)
        && !rates[1 - alone].is_zero()
    {
        let other = jacobian[1 - alone][row] * rates[1 - alone];
        let quotient = (right[row] - other) / jacobian[alone][row];
        rates[alone] = by_rule::rate_symbol(
            algebra.graph,
            &mut algebra.solutions,
            group,
            alone,
            by,
            quotient,
        );
    }
    rates
}

/// Returns the unknown that only one of two equations contains, and the number of that equation.
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
