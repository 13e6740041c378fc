//! Derivatives by parameters from the results backwards.
//!
//! A quantity `q` is a function of parameters, unknowns and rates; the unknowns solve `F = 0`, the rates linear systems with
//! the same Jacobian. Each system gets multipliers `l` with `J^T l = dq/du`, the last system first: what the equations
//! mention of earlier systems is added to their `dq/du`. Then `dq/dp` is the partial derivative
//! of `q` minus the sum of `l . dF/dp`. One sweep serves all parameters, where going forward solves a system for each;
//! forward needs no sweep for each result. [`Direction`] names the ways, lowering takes the cheapest.

use std::collections::{BTreeMap, HashMap};

use linkage_symbolic::{Graph, NodeId, SymbolId, differentiate};

use super::Algebra;
use super::implicit::Rule;
use super::partial::{Solved, System};

/// How derivatives by parameters are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Direction {
    /// The rates of all groups by each parameter.
    #[default]
    Forward,
    /// Backwards from each number that is differentiated.
    FromResults,
    /// Backwards from each unknown in it, then forward: several results often hang on one angle.
    FromUnknowns,
    /// Backwards from each number through its whole formula.
    Gradient,
}

impl Direction {
    /// For the docs.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::FromResults => "backwards from the results",
            Self::FromUnknowns => "backwards from the unknowns",
            Self::Gradient => "backwards through all formulas",
        }
    }
}

/// The multipliers of the equations of each system that something depends on.
type Multipliers = Vec<(System, Vec<NodeId>)>;

/// Multipliers found already.
#[derive(Debug, Default)]
pub(super) struct Adjoints {
    of_nodes: HashMap<NodeId, Multipliers>,
    of_unknowns: HashMap<Solved, Multipliers>,
    rates: HashMap<(Solved, SymbolId), NodeId>,
}

impl Algebra<'_> {
    /// The derivative by an input, or by a parameter in any direction.
    pub(crate) fn derivative(
        &mut self,
        node: NodeId,
        parameter: SymbolId,
        direction: Direction,
    ) -> NodeId {
        match direction {
            Direction::Forward => differentiate(self, node, parameter),
            Direction::Gradient => self.gradient_by(node, parameter),
            Direction::FromResults => {
                let multipliers = self.multipliers_of(node);
                let start = self.partial(node, parameter);
                self.minus_slopes(start, &multipliers, parameter)
            }
            Direction::FromUnknowns => {
                let start = self.partial(node, parameter);
                let mentioned = self.mentioned_in(&[node]);
                mentioned.iter().fold(start, |sum, solved| {
                    let variable = self.symbol_for(solved);
                    let weight = self.partial(node, variable);
                    let rate = self.rate_backwards(solved, parameter);
                    let product = self.graph.mul(weight, rate);
                    self.graph.add(sum, product)
                })
            }
        }
    }

    /// The derivative of an unknown or a rate by a parameter.
    fn rate_backwards(&mut self, solved: &Solved, parameter: SymbolId) -> NodeId {
        let key = (solved.clone(), parameter);
        if let Some(&known) = self.adjoints.rates.get(&key) {
            return known;
        }
        let multipliers = match self.adjoints.of_unknowns.get(solved) {
            Some(known) => known.clone(),
            None => {
                let one = self.graph.one();
                let found = self.sweep(vec![(solved.clone(), one)]);
                let all = &mut self.adjoints.of_unknowns;
                all.insert(solved.clone(), found.clone());
                found
            }
        };
        let zero = self.graph.zero();
        let rate = self.minus_slopes(zero, &multipliers, parameter);
        self.adjoints.rates.insert(key, rate);
        rate
    }

    fn multipliers_of(&mut self, node: NodeId) -> Multipliers {
        if let Some(known) = self.adjoints.of_nodes.get(&node) {
            return known.clone();
        }
        let mentioned = self.mentioned_in(&[node]).into_iter();
        let weights = mentioned
            .map(|solved| {
                let variable = self.symbol_for(&solved);
                (solved, self.partial(node, variable))
            })
            .collect();
        let multipliers = self.sweep(weights);
        self.adjoints.of_nodes.insert(node, multipliers.clone());
        multipliers
    }

    /// `start` minus the sum of multiplier times slope.
    fn minus_slopes(
        &mut self,
        start: NodeId,
        multipliers: &Multipliers,
        variable: SymbolId,
    ) -> NodeId {
        multipliers.iter().fold(start, |sum, (system, factors)| {
            let rows = factors.iter().enumerate();
            rows.fold(sum, |sum, (row, &factor)| {
                let slope = self.slope(system, row, variable);
                let product = self.graph.mul(factor, slope);
                self.graph.sub(sum, product)
            })
        })
    }

    /// From the derivatives by unknowns and rates to all multipliers, the last system first.
    fn sweep(&mut self, weights: Vec<(Solved, NodeId)>) -> Multipliers {
        let mut open: BTreeMap<System, Vec<NodeId>> = BTreeMap::new();
        for (solved, weight) in weights {
            self.add_weight(&mut open, solved, weight);
        }
        let mut all = Multipliers::new();
        while let Some((system, weights)) = open.pop_last() {
            let factors = self.solve_transposed(system.group, &weights);
            if factors.iter().all(|&factor| self.graph.is_zero(factor)) {
                continue;
            }
            let zero = self.graph.zero();
            let found = [(system, factors)];
            for solved in self.mentioned_by(&found[0].0) {
                let variable = self.symbol_for(&solved);
                let weight = self.minus_slopes(zero, &found.to_vec(), variable);
                self.add_weight(&mut open, solved, weight);
            }
            all.extend(found);
        }
        all
    }

    fn add_weight(
        &mut self,
        open: &mut BTreeMap<System, Vec<NodeId>>,
        solved: Solved,
        weight: NodeId,
    ) {
        let count = self.solutions[solved.system.group].jacobian.len();
        let zero = self.graph.zero();
        let weights = open
            .entry(solved.system)
            .or_insert_with(|| vec![zero; count]);
        let sum = self.graph.add(weights[solved.position], weight);
        weights[solved.position] = sum;
    }

    /// What the equations of a system mention of earlier ones.
    fn mentioned_by(&mut self, system: &System) -> Vec<Solved> {
        let solution = &self.solutions[system.group];
        let mut nodes: Vec<NodeId> = Vec::new();
        if system.by.is_empty() {
            let coefficients = solution.terms.iter().map(|term| &term.coefficient);
            nodes.extend(coefficients.flatten());
        } else {
            nodes.extend(solution.jacobian.iter().flatten());
            nodes.extend(self.rates(system.group, system.by.clone()).right);
        }
        let mentioned = self.mentioned_in(&nodes).into_iter();
        mentioned
            .filter(|solved| solved.system != *system)
            .collect()
    }

    /// The derivative of an equation of a system by a variable that is not one of its results.
    fn slope(&mut self, system: &System, row: usize, variable: SymbolId) -> NodeId {
        let solution = self.solutions[system.group].clone();
        if system.by.is_empty() {
            let mut slope = |algebra: &mut Self, node| algebra.partial(node, variable);
            return self.sum_of_slopes(&solution.terms, row, Graph::add, &mut slope);
        }
        // J r - right
        let rates = self.rates(system.group, system.by.clone());
        let right = self.partial(rates.right[row], variable);
        let start = self.graph.neg(right);
        let columns = solution.jacobian.iter().zip(&rates.rates);
        columns.fold(start, |sum, (column, &rate)| {
            let slope = self.partial(column[row], variable);
            let product = self.graph.mul(slope, rate);
            self.graph.add(sum, product)
        })
    }

    /// `J^T l = weights` by Cramer's rule. The determinant is known from the closed form. Computed from the scaled weights,
    /// of which there are fewer; differentiated as the quotients, whose derivatives stay in range for lengths of any unit.
    pub(super) fn solve_transposed(&mut self, group: usize, weights: &[NodeId]) -> Vec<NodeId> {
        let solution = self.solutions[group].clone();
        if solution.elimination.is_some() {
            return self.eliminate_transposed(group, weights);
        }
        let determinant = solution.determinant;
        let &[first, second] = weights else {
            return vec![self.graph.div(weights[0], determinant)];
        };
        let [a, b] = [&solution.jacobian[0], &solution.jacobian[1]];
        let scaled = [first, second].map(|weight| self.graph.div(weight, determinant));
        [0, 1]
            .map(|row| {
                let columns = [a[1 - row], b[1 - row]];
                let value = self.transposed_row(row, scaled, columns);
                let numerator = self.transposed_row(row, [first, second], columns);
                let quotient = self.graph.div(numerator, determinant);
                if self.graph.constant_value(quotient).is_some() {
                    return quotient;
                }
                let name = format!("multiplier {group}.{row}");
                let (symbol, node) = self.graph.unknown(name);
                self.graph.define(symbol, value);
                self.rules.insert(symbol, Rule::Follow(quotient));
                node
            })
            .to_vec()
    }

    /// `w1 b2 - w2 a2` for the first row, `w2 a1 - w1 b1` for the second.
    fn transposed_row(&mut self, row: usize, weights: [NodeId; 2], [a, b]: [NodeId; 2]) -> NodeId {
        let graph = &mut self.graph;
        let [left, right] = [graph.mul(weights[0], b), graph.mul(weights[1], a)];
        match row {
            0 => graph.sub(left, right),
            _ => graph.sub(right, left),
        }
    }
}
