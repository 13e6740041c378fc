//! Derivatives of the solutions of loops, by the implicit function theorem.
//!
//! A group of loops is `F = sum of coefficient * factor = 0`, where the factors are made of the group's own unknowns and
//! the coefficients of everything known before. Its rates by `x` solve `J r = -sum of d(coefficient)/dx * factor`, and
//! every further derivative follows by differentiating that linear system, so that the square root of the
//! closed form is never differentiated. Each rate is a symbol of its own: common parts are computed once.

use linkage_symbolic::{Calculus, DerivativeMemo, Graph, NodeId, SymbolId, differentiate};

use super::Algebra;
use super::elimination::Elimination;

/// How a symbol that lives by its definition is differentiated.
#[derive(Clone, Debug)]
pub(crate) enum Rule {
    /// Like this expression, which is equal to the definition.
    Follow(NodeId),
    /// The cosine, sine or value of an angle that a group solves for; `sense` is -1 if the group works with its
    /// negative.
    Cosine(AngleRule),
    Sine(AngleRule),
    Value(AngleRule),
    /// A component of `z u`, a vector that turns with unknown `position` of a group.
    Turning(Box<Turning>),
    /// Unknown `position` of a group.
    Unknown {
        group: usize,
        position: usize,
    },
    /// A derivative of unknown `position` of a group.
    Rate {
        group: usize,
        position: usize,
        by: Vec<SymbolId>,
    },
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct AngleRule {
    pub(crate) group: usize,
    pub(crate) position: usize,
    pub(crate) sense: f64,
    pub(crate) cos: NodeId,
    pub(crate) sin: NodeId,
}

/// See [`Rule::Turning`].
#[derive(Clone, Debug)]
pub(crate) struct Turning {
    pub(crate) group: usize,
    pub(crate) position: usize,
    pub(crate) component: usize,
    /// The vector itself.
    pub(crate) vector: [NodeId; 2],
    pub(crate) z: [NodeId; 2],
    pub(crate) unit: [NodeId; 2],
}

/// One term of a group's equations.
#[derive(Clone, Debug)]
pub(crate) struct Term {
    /// One for each equation.
    pub(crate) coefficient: Vec<NodeId>,
    pub(crate) factor: NodeId,
}

/// What differentiation needs to know of a solved group.
#[derive(Clone, Debug)]
pub(crate) struct Solution {
    pub(crate) terms: Vec<Term>,
    /// Columns: the derivatives of the equations by each unknown.
    pub(crate) jacobian: Vec<Vec<NodeId>>,
    pub(crate) determinant: NodeId,
    /// For a coupled group; closed forms have one or two equations.
    pub(crate) elimination: Option<Elimination>,
}

/// Derivatives of a group's unknowns by some variables, and the right-hand side that they solve.
#[derive(Clone, Debug)]
pub(crate) struct Rates {
    pub(super) right: Vec<NodeId>,
    pub(super) rates: Vec<NodeId>,
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
    ) -> NodeId;

    fn derivative_by_rule(&mut self, symbol: SymbolId, variable: SymbolId) -> NodeId {
        match self.algebra().rules.get(&symbol).cloned() {
            None => self.graph().zero(),
            Some(Rule::Follow(node)) => differentiate(self, node, variable),
            Some(Rule::Cosine(rule)) => {
                let rate = self.angle_rate(rule, variable);
                let product = self.graph().mul(rule.sin, rate);
                self.graph().neg(product)
            }
            Some(Rule::Sine(rule)) => {
                let rate = self.angle_rate(rule, variable);
                self.graph().mul(rule.cos, rate)
            }
            Some(Rule::Value(rule)) => self.angle_rate(rule, variable),
            Some(Rule::Turning(turning)) => self.turning_rate(&turning, variable),
            Some(Rule::Unknown { group, position }) => {
                self.rate(group, position, Vec::new(), variable)
            }
            Some(Rule::Rate {
                group,
                position,
                by,
            }) => self.rate(group, position, by, variable),
        }
    }

    fn angle_rate(&mut self, rule: AngleRule, variable: SymbolId) -> NodeId {
        let rate = self.rate(rule.group, rule.position, Vec::new(), variable);
        if rule.sense < 0.0 {
            self.graph().neg(rate)
        } else {
            rate
        }
    }

    /// `z' u + rate perp(z u)`
    fn turning_rate(&mut self, turning: &Turning, variable: SymbolId) -> NodeId {
        let &Turning {
            group,
            position,
            component,
            vector,
            z,
            unit,
        } = turning;
        let stretch = z.map(|x| differentiate(self, x, variable));
        let stretched = self.algebra().complex_product(stretch, unit)[component];
        let rate = self.rate(group, position, Vec::new(), variable);
        let across = [self.graph().neg(vector[1]), vector[0]][component];
        let turned = self.graph().mul(rate, across);
        self.graph().add(stretched, turned)
    }
}

impl<'m> Calculus<'m> for Algebra<'m> {
    fn graph(&self) -> &'m Graph {
        self.graph
    }

    fn memo(&mut self) -> &mut DerivativeMemo {
        &mut self.memo
    }

    fn symbol_derivative(&mut self, symbol: SymbolId, variable: SymbolId) -> NodeId {
        self.derivative_by_rule(symbol, variable)
    }
}

impl<'m> Implicit<'m> for Algebra<'m> {
    fn algebra(&mut self) -> &mut Algebra<'m> {
        self
    }

    fn rate(
        &mut self,
        group: usize,
        position: usize,
        mut by: Vec<SymbolId>,
        variable: SymbolId,
    ) -> NodeId {
        by.push(variable);
        by.sort_unstable();
        self.rates(group, by).rates[position]
    }
}

impl Algebra<'_> {
    /// The derivatives of a group's unknowns by the variables `by`, which are in order.
    pub(super) fn rates(&mut self, group: usize, by: Vec<SymbolId>) -> Rates {
        let key = (group, by);
        if let Some(known) = self.rates.get(&key) {
            return known.clone();
        }
        let right = self.right_hand_side(group, &key.1);
        let rates = self.solve(group, &right, &key.1);
        let rates = Rates { right, rates };
        self.rates.insert(key, rates.clone());
        rates
    }

    fn right_hand_side(&mut self, group: usize, by: &[SymbolId]) -> Vec<NodeId> {
        let (&last, before) = by.split_last().expect("a derivative has a variable");
        let solution = self.solutions[group].clone();
        let equations = solution.jacobian[0].len();
        if before.is_empty() {
            let mut slope = |algebra: &mut Self, node| differentiate(algebra, node, last);
            return (0..equations)
                .map(|row| self.sum_of_slopes(&solution.terms, row, Graph::sub, &mut slope))
                .collect();
        }
        let lower = self.rates(group, before.to_vec());
        (0..equations)
            .map(|row| {
                let start = differentiate(self, lower.right[row], last);
                solution
                    .jacobian
                    .iter()
                    .zip(&lower.rates)
                    .fold(start, |sum, (column, &rate)| {
                        let slope = differentiate(self, column[row], last);
                        let product = self.graph.mul(slope, rate);
                        self.graph.sub(sum, product)
                    })
            })
            .collect()
    }

    /// Cramer's rule, the determinant being known from the closed form; coupled groups are brought down to their core.
    fn solve(&mut self, group: usize, right: &[NodeId], by: &[SymbolId]) -> Vec<NodeId> {
        let solution = &self.solutions[group];
        let (determinant, count) = (solution.determinant, solution.jacobian.len());
        if right.iter().all(|&b| self.graph.is_zero(b)) {
            return vec![self.graph.zero(); count];
        }
        if solution.elimination.is_some() {
            return self.eliminate(group, right, &mut |algebra, position, rate| {
                algebra.rate_symbol(group, position, by, rate)
            });
        }
        let numerators = match *right {
            [b] => vec![b],
            [x, y] => {
                let [first, second] = [0, 1].map(|k| {
                    let column = &self.solutions[group].jacobian[k];
                    [column[0], column[1]]
                });
                vec![self.cross([x, y], second), self.cross(first, [x, y])]
            }
            _ => unreachable!("closed forms have one or two equations"),
        };
        (0..count)
            .map(|position| {
                let quotient = self.graph.div(numerators[position], determinant);
                self.rate_symbol(group, position, by, quotient)
            })
            .collect()
    }

    /// A rate as a symbol of its own.
    fn rate_symbol(
        &mut self,
        group: usize,
        position: usize,
        by: &[SymbolId],
        value: NodeId,
    ) -> NodeId {
        if self.graph.constant_value(value).is_some() {
            return value;
        }
        let name = format!("rate {group}.{position} {by:?}");
        let (symbol, node) = self.graph.unknown(name);
        self.graph.define(symbol, value);
        let rule = Rule::Rate {
            group,
            position,
            by: by.to_vec(),
        };
        self.rules.insert(symbol, rule);
        node
    }
}
