//! Derivatives by parameters from the results backwards.
//!
//! A quantity `q` is a function of parameters, unknowns and rates; the unknowns solve `F = 0`, the rates linear
//! systems with the same Jacobian. Each system gets multipliers `l` with `J^T l = dq/du`, the last system first: what
//! the equations mention of earlier systems is added to their `dq/du`. Then `dq/dp` is the partial derivative of `q`
//! minus the sum of `l . dF/dp`. One sweep serves all parameters, where going forward solves a system for each;
//! forward needs no sweep for each result. [`Direction`] names the ways, lowering takes the cheapest.

use std::collections::BTreeMap;
use std::rc::Rc;

use linkage_symbolic::unordered::Map;

use linkage_symbolic::{Ex, NodeId, SymbolId, V2, Vector};

use super::acting::ByParameter;
use super::implicit::Implicit;
use super::partial::{Solved, System};
use super::preaccumulation::Through;
use super::{Algebra, Rule};

/// How derivatives by parameters are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Direction {
    /// The rates of all groups by each parameter.
    #[default]
    Forward,
    /// Backwards from each number that is differentiated.
    FromResults,
    /// Backwards from the unknowns in it, and anew from each narrow place before these: several results often hang on
    /// one angle.
    FromUnknowns,
    /// Backwards from each number through its whole formula.
    Gradient,
}

impl Direction {
    pub(crate) const ALL: [Self; 4] = [
        Self::Forward,
        Self::FromResults,
        Self::FromUnknowns,
        Self::Gradient,
    ];

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

/// The multipliers of the equations of one system.
#[derive(Clone, Debug)]
pub(super) struct Multiplier<'m> {
    pub(super) system: System,
    /// The derivatives by its results.
    pub(super) weights: Vec<Ex<'m>>,
    pub(super) factors: Vec<Ex<'m>>,
}

/// What a sweep backwards finds.
#[derive(Clone, Debug, Default)]
pub(super) struct Flow<'m> {
    /// Of all systems that it visited.
    pub(super) multipliers: Vec<Multiplier<'m>>,
    /// The places of multipliers whose equations mention a parameter: each parameter visits its own, not all of them.
    pub(super) acting: ByParameter,
    /// The derivatives with respect to unknowns and rates at which it ended.
    pub(super) ends: BTreeMap<Solved, Ex<'m>>,
}

/// Multipliers found already.
#[derive(Clone, Debug, Default)]
pub(super) struct Adjoints<'m> {
    of_nodes: Map<NodeId, Rc<Flow<'m>>>,
    /// Of numbers, with the ends at all narrow places.
    pub(super) flows: Map<NodeId, Rc<Through<'m>>>,
    /// Of narrow places.
    pub(super) of_places: Map<Solved, Rc<Flow<'m>>>,
    /// Derivatives of these, without what passes others before them.
    pub(super) between: Map<(Solved, SymbolId), Ex<'m>>,
}

impl<'m> Algebra<'m> {
    /// The derivative by an input, or by a parameter in any direction.
    pub(crate) fn derivative(
        &mut self,
        x: Ex<'m>,
        parameter: SymbolId,
        direction: Direction,
    ) -> Ex<'m> {
        match direction {
            Direction::Forward => self.slope(x, parameter),
            Direction::Gradient => self.gradient_by(x, parameter),
            Direction::FromResults => {
                let flow = self.flow_to(x);
                let start = self.partial(x, parameter);
                self.minus_slopes(start, &flow, parameter)
            }
            Direction::FromUnknowns => self.derivative_through(x, parameter),
        }
    }

    fn flow_to(&mut self, x: Ex<'m>) -> Rc<Flow<'m>> {
        if let Some(known) = self.derivatives.adjoints.of_nodes.get(&x.id()) {
            return Rc::clone(known);
        }
        let weights = self.weights_of(x);
        let flow = Rc::new(self.sweep(weights, |_, _| false));
        let all = &mut self.derivatives.adjoints.of_nodes;
        all.insert(x.id(), Rc::clone(&flow));
        flow
    }

    /// The derivatives by the unknowns and rates in an expression.
    pub(super) fn weights_of(&mut self, x: Ex<'m>) -> Vec<(Solved, Ex<'m>)> {
        let mentioned = self.mentioned_in(&[x]).into_iter();
        let weights = mentioned.map(|solved| {
            let variable = self.symbol_for(&solved);
            (solved, self.partial(x, variable))
        });
        weights.collect()
    }

    /// `start` minus the sum of multiplier times slope by a parameter.
    pub(super) fn minus_slopes(
        &mut self,
        start: Ex<'m>,
        flow: &Flow<'m>,
        parameter: SymbolId,
    ) -> Ex<'m> {
        let acting = flow.acting.of(parameter).iter();
        acting.fold(start, |sum, &place| {
            self.minus_slope(sum, &flow.multipliers[place], parameter)
        })
    }

    /// `sum` minus the multipliers of one system times the slopes of its equations.
    fn minus_slope(&mut self, sum: Ex<'m>, own: &Multiplier<'m>, variable: SymbolId) -> Ex<'m> {
        let sum = sum - self.slope_of_links(own, variable);
        let rows = own.factors.iter().enumerate();
        rows.fold(sum, |sum, (row, &factor)| {
            sum - factor * self.slope_of_row(&own.system, row, variable)
        })
    }

    /// From the derivatives by unknowns and rates to all multipliers, the last system first, but not beyond ends.
    pub(super) fn sweep(
        &mut self,
        weights: Vec<(Solved, Ex<'m>)>,
        is_end: impl Fn(&Self, &Solved) -> bool,
    ) -> Flow<'m> {
        let zero = self.zero();
        let mut open: BTreeMap<System, Vec<Ex<'m>>> = BTreeMap::new();
        let mut flow = Flow::default();
        let mut add = |own: &Self, open: &mut BTreeMap<_, _>, solved: Solved, weight: Ex<'m>| {
            if is_end(own, &solved) {
                *flow.ends.entry(solved).or_insert(zero) += weight;
            } else {
                own.add_weight(open, solved, weight);
            }
        };
        for (solved, weight) in weights {
            add(self, &mut open, solved, weight);
        }
        while let Some((system, weights)) = open.pop_last() {
            let factors = self.solve_transposed(system.group, &weights);
            if factors.iter().all(|factor| factor.is_zero()) {
                continue;
            }
            let found = Multiplier {
                system,
                weights,
                factors,
            };
            for solved in self.mentioned_by(&found.system) {
                let variable = self.symbol_for(&solved);
                let weight = self.minus_slope(zero, &found, variable);
                add(self, &mut open, solved, weight);
            }
            flow.multipliers.push(found);
        }
        for (place, own) in flow.multipliers.iter().enumerate() {
            flow.acting.add(place, &self.acting_on_system(&own.system));
        }
        flow
    }

    fn add_weight(&self, open: &mut BTreeMap<System, Vec<Ex<'m>>>, solved: Solved, weight: Ex<'m>) {
        let count = self.solutions.groups[solved.system.group].jacobian.len();
        let zero = self.zero();
        let weights = open
            .entry(solved.system)
            .or_insert_with(|| vec![zero; count]);
        weights[solved.position] += weight;
    }

    /// What the equations of a system mention of earlier ones.
    pub(super) fn mentioned_by(&mut self, system: &System) -> Vec<Solved> {
        let solution = &self.solutions.groups[system.group];
        let mut all: Vec<Ex<'m>> = Vec::new();
        if system.by.is_empty() {
            let coefficients = solution.terms.iter().map(|term| &term.coefficient);
            all.extend(coefficients.flatten());
        } else {
            all.extend(solution.jacobian.iter().flatten());
            all.extend(self.rates(system.group, system.by.clone()).right);
        }
        let mentioned = self.mentioned_in(&all).into_iter();
        mentioned
            .filter(|solved| solved.system != *system)
            .collect()
    }

    /// The derivative of an equation of a system by a variable that is not one of its results.
    fn slope_of_row(&mut self, system: &System, row: usize, variable: SymbolId) -> Ex<'m> {
        let solution = self.solutions.groups[system.group].clone();
        if system.by.is_empty() {
            let mut slope = |algebra: &mut Self, x| algebra.partial(x, variable);
            let written = solution.rows.get(row).and_then(|own| own.links.as_ref());
            if let Some(links) = written {
                return self.slope_of_squares(links, &mut slope);
            }
            // Those of links are found by themselves.
            let links = self.terms_of_links(system.group);
            let terms = &solution.terms[links..];
            return self.sum_of_slopes(terms, row, |a, b| a + b, &mut slope);
        }
        // J r - right
        let rates = self.rates(system.group, system.by.clone());
        let right = self.partial(rates.right[row], variable);
        let columns = solution.jacobian.iter().zip(&rates.rates);
        columns.fold(-right, |sum, (column, &rate)| {
            sum + self.partial(column[row], variable) * rate
        })
    }

    /// `J^T l = weights` by Cramer's rule. The determinant is known from the closed form. Computed from the scaled
    /// weights, of which there are fewer; differentiated as the quotients, whose derivatives stay in range for lengths
    /// of any unit.
    pub(super) fn solve_transposed(&mut self, group: usize, weights: &[Ex<'m>]) -> Vec<Ex<'m>> {
        let solution = self.solutions.groups[group].clone();
        if solution.elimination.is_some() {
            return self.eliminate_transposed(group, weights);
        }
        let determinant = solution.determinant;
        let &[first, second] = weights else {
            return vec![weights[0] / determinant];
        };
        let weights = Vector([first, second]);
        let [a, b] = [&solution.jacobian[0], &solution.jacobian[1]];
        let scaled = weights / determinant;
        [0, 1]
            .map(|row| {
                let columns = Vector([a[1 - row], b[1 - row]]);
                let value = transposed_row(row, scaled, columns);
                let quotient = transposed_row(row, weights, columns) / determinant;
                if quotient.constant_value().is_some() {
                    return quotient;
                }
                let name = format!("multiplier {group}.{row}");
                self.symbol_for_value(name, value, Rule::Follow(quotient))
            })
            .to_vec()
    }
}

/// `w1 b2 - w2 a2` for the first row, `w2 a1 - w1 b1` for the second.
fn transposed_row<'m>(row: usize, weights: V2<'m>, columns: V2<'m>) -> Ex<'m> {
    let left = weights[0] * columns[1];
    let right = weights[1] * columns[0];
    match row {
        0 => left - right,
        _ => right - left,
    }
}
