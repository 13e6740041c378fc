//! Derivatives by parameters from the results backwards.
//!
//! A quantity `q` is a function of parameters, unknowns and rates; the unknowns solve `F = 0`, the rates linear
//! systems with the same Jacobian. Each system gets multipliers `l` with `J^T l = dq/du`, the last system first: what
//! the equations mention of earlier systems is added to their `dq/du`. Then `dq/dp` is the partial derivative of `q`
//! minus the sum of `l . dF/dp`. One sweep serves all parameters, where going forward solves a system for each;
//! forward needs no sweep for each result. [`Direction`] names the ways, lowering takes the cheapest.

use crate::algebra::acting;
use crate::algebra::elimination;
use crate::algebra::gradient;
use crate::algebra::implicit;
use crate::algebra::links;
use crate::algebra::partial;
use crate::algebra::preaccumulation;
use crate::algebra::rows;
use std::collections::BTreeMap;
use std::rc::Rc;

use linkage_symbolic::lookup::Map;

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

/// The derivative by an input, or by a parameter in any direction.
pub(crate) fn derivative<'m>(
    algebra: &mut Algebra<'m>,
    x: Ex<'m>,
    parameter: SymbolId,
    direction: Direction,
) -> Ex<'m> {
    match direction {
        Direction::Forward => algebra.slope(x, parameter),
        Direction::Gradient => gradient::gradient_by(algebra, x, parameter),
        Direction::FromResults => {
            let flow = flow_to(algebra, x);
            let start = partial::partial(algebra, x, parameter);
            minus_slopes(algebra, start, &flow, parameter)
        }
        Direction::FromUnknowns => preaccumulation::derivative_through(algebra, x, parameter),
    }
}

fn flow_to<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>) -> Rc<Flow<'m>> {
    if let Some(known) = algebra.derivatives.adjoints.of_nodes.get(&x.id()) {
        return Rc::clone(known);
    }
    let weights = weights_of(algebra, x);
    let flow = Rc::new(sweep(algebra, weights, |_, _| false));
    let all = &mut algebra.derivatives.adjoints.of_nodes;
    all.insert(x.id(), Rc::clone(&flow));
    flow
}

/// The derivatives by the unknowns and rates in an expression.
pub(super) fn weights_of<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>) -> Vec<(Solved, Ex<'m>)> {
    let mentioned = partial::mentioned_in(algebra, &[x]).into_iter();
    let weights = mentioned.map(|solved| {
        let variable = partial::symbol_for(algebra, &solved);
        (solved, partial::partial(algebra, x, variable))
    });
    weights.collect()
}

/// `start` minus the sum of multiplier times slope by a parameter.
pub(super) fn minus_slopes<'m>(
    algebra: &mut Algebra<'m>,
    start: Ex<'m>,
    flow: &Flow<'m>,
    parameter: SymbolId,
) -> Ex<'m> {
    let acting = flow.acting.of(parameter).iter();
    acting.fold(start, |sum, &place| {
        minus_slope(algebra, sum, &flow.multipliers[place], parameter)
    })
}

/// `sum` minus the multipliers of one system times the slopes of its equations.
fn minus_slope<'m>(
    algebra: &mut Algebra<'m>,
    sum: Ex<'m>,
    own: &Multiplier<'m>,
    variable: SymbolId,
) -> Ex<'m> {
    let sum = sum - links::slope_of_links(algebra, own, variable);
    let rows = own.factors.iter().enumerate();
    rows.fold(sum, |sum, (row, &factor)| {
        sum - factor * slope_of_row(algebra, &own.system, row, variable)
    })
}

/// From the derivatives by unknowns and rates to all multipliers, the last system first, but not beyond ends.
pub(super) fn sweep<'m>(
    algebra: &mut Algebra<'m>,
    weights: Vec<(Solved, Ex<'m>)>,
    is_end: impl Fn(&Algebra<'m>, &Solved) -> bool,
) -> Flow<'m> {
    let zero = algebra.zero();
    let mut open: BTreeMap<System, Vec<Ex<'m>>> = BTreeMap::new();
    let mut flow = Flow::default();
    let mut add = |own: &Algebra<'m>, open: &mut BTreeMap<_, _>, solved: Solved, weight: Ex<'m>| {
        if is_end(own, &solved) {
            *flow.ends.entry(solved).or_insert(zero) += weight;
        } else {
            add_weight(own, open, solved, weight);
        }
    };
    for (solved, weight) in weights {
        add(algebra, &mut open, solved, weight);
    }
    while let Some((system, weights)) = open.pop_last() {
        let factors = solve_transposed(algebra, system.group, &weights);
        if factors.iter().all(|factor| factor.is_zero()) {
            continue;
        }
        let found = Multiplier {
            system,
            weights,
            factors,
        };
        for solved in mentioned_by(algebra, &found.system) {
            let variable = partial::symbol_for(algebra, &solved);
            let weight = minus_slope(algebra, zero, &found, variable);
            add(algebra, &mut open, solved, weight);
        }
        flow.multipliers.push(found);
    }
    for (place, own) in flow.multipliers.iter().enumerate() {
        flow.acting
            .add(place, &acting::acting_on_system(algebra, &own.system));
    }
    flow
}

fn add_weight<'m>(
    algebra: &Algebra<'m>,
    open: &mut BTreeMap<System, Vec<Ex<'m>>>,
    solved: Solved,
    weight: Ex<'m>,
) {
    let count = algebra.solutions.groups[solved.system.group].jacobian.len();
    let zero = algebra.zero();
    let weights = open
        .entry(solved.system)
        .or_insert_with(|| vec![zero; count]);
    weights[solved.position] += weight;
}

/// What the equations of a system mention of earlier ones.
pub(super) fn mentioned_by<'m>(algebra: &mut Algebra<'m>, system: &System) -> Vec<Solved> {
    let solution = &algebra.solutions.groups[system.group];
    let mut all: Vec<Ex<'m>> = Vec::new();
    if system.by.is_empty() {
        let coefficients = solution.terms.iter().map(|term| &term.coefficient);
        all.extend(coefficients.flatten());
    } else {
        all.extend(solution.jacobian.iter().flatten());
        all.extend(implicit::rates(algebra, system.group, system.by.clone()).right);
    }
    let mentioned = partial::mentioned_in(algebra, &all).into_iter();
    mentioned
        .filter(|solved| solved.system != *system)
        .collect()
}

/// The derivative of an equation of a system by a variable that is not one of its results.
fn slope_of_row<'m>(
    algebra: &mut Algebra<'m>,
    system: &System,
    row: usize,
    variable: SymbolId,
) -> Ex<'m> {
    let solution = algebra.solutions.groups[system.group].clone();
    if system.by.is_empty() {
        let mut slope = |algebra: &mut Algebra<'m>, x| partial::partial(algebra, x, variable);
        let written = solution.rows.get(row).and_then(|own| own.links.as_ref());
        if let Some(links) = written {
            return rows::slope_of_squares(algebra, links, &mut slope);
        }
        // Those of links are found by themselves.
        let links = links::terms_of_links(algebra, system.group);
        let terms = &solution.terms[links..];
        return partial::sum_of_slopes(algebra, terms, row, |a, b| a + b, &mut slope);
    }
    // J r - right
    let rates = implicit::rates(algebra, system.group, system.by.clone());
    let right = partial::partial(algebra, rates.right[row], variable);
    let columns = solution.jacobian.iter().zip(&rates.rates);
    columns.fold(-right, |sum, (column, &rate)| {
        sum + partial::partial(algebra, column[row], variable) * rate
    })
}

/// `J^T l = weights` by Cramer's rule. The determinant is known from the closed form. Computed from the scaled
/// weights, of which there are fewer; differentiated as the quotients, whose derivatives stay in range for lengths
/// of any unit.
pub(super) fn solve_transposed<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    weights: &[Ex<'m>],
) -> Vec<Ex<'m>> {
    let solution = algebra.solutions.groups[group].clone();
    if solution.elimination.is_some() {
        return elimination::eliminate_transposed(algebra, group, weights);
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
            implicit::symbol_for_value(algebra, name, value, Rule::Follow(quotient))
        })
        .to_vec()
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
