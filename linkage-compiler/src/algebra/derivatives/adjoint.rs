//! Derivatives by parameters from the results backwards.
//!
//! A quantity `q` is a function of parameters, unknowns and rates; the unknowns solve `F = 0`, the
//! rates linear systems with the same Jacobian. Each system gets multipliers `l` with `J^T l =
//! dq/du`, the last system first. Its equations add to the `dq/du` of the earlier systems that they
//! mention. Then `dq/dp` is the partial derivative of `q` minus the sum of `l . dF/dp`. One sweep
//! serves all parameters, where going forward solves a system for each; forward needs no sweep for
//! each result. `Direction` names the choices, and the cheapest is taken.

use std::collections::BTreeMap;
use std::rc::Rc;

use linkage_symbolic::{Ex, Graph, SymbolId, V2, Vector};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule::GroupRates;
use crate::algebra::derivatives::{
    acting, by_rule, elimination, links, mentioned, partial, written_rows,
};
use crate::algebra::memo::{Flow, Multiplier};
use crate::algebra::rules::DerivativeRule;
use crate::algebra::solutions::Solutions;
use crate::algebra::systems::{Solved, System};

pub(crate) fn flow_to<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>) -> Rc<Flow<'m>> {
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
pub(crate) fn weights_of<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>) -> Vec<(Solved, Ex<'m>)> {
    let memo = &mut algebra.derivatives.partials.mentioned;
    let mentioned = mentioned::mentioned_in(algebra.graph, &algebra.solutions, memo, &[x]);
    let weights = mentioned.into_iter().map(|solved| {
        let variable = partial::symbol_for(algebra, &solved);
        (solved, partial::partial(algebra, x, variable))
    });
    weights.collect()
}

/// `start` minus the sum of multiplier times slope by a parameter.
pub(crate) fn minus_slopes<'m>(
    algebra: &mut Algebra<'m>,
    start: Ex<'m>,
    flow: &Flow<'m>,
    parameter: SymbolId,
) -> Ex<'m> {
    let acting = flow.acting.positions_for(parameter).iter();
    acting.fold(start, |sum, &index| {
        minus_slope(algebra, sum, &flow.multipliers[index], parameter)
    })
}

/// `sum` minus the multipliers of one system times the slopes of its equations.
fn minus_slope<'m>(
    algebra: &mut Algebra<'m>,
    sum: Ex<'m>,
    multiplier: &Multiplier<'m>,
    variable: SymbolId,
) -> Ex<'m> {
    let sum = sum - links::slope_of_links(algebra, multiplier, variable);
    let rows = multiplier.factors.iter().enumerate();
    rows.fold(sum, |sum, (row, &factor)| {
        sum - factor * slope_of_row(algebra, &multiplier.system, row, variable)
    })
}

/// Sweeps from the derivatives by unknowns and rates to all multipliers, the last system first, but
/// not beyond ends.
pub(crate) fn sweep<'m>(
    algebra: &mut Algebra<'m>,
    weights: Vec<(Solved, Ex<'m>)>,
    is_end: impl Fn(&Solutions<'m>, &Solved) -> bool,
) -> Flow<'m> {
    let zero = algebra.zero();
    let mut open: BTreeMap<System, Vec<Ex<'m>>> = BTreeMap::new();
    let mut flow = Flow::default();
    let mut add =
        |solutions: &Solutions<'m>, open: &mut BTreeMap<_, _>, solved: Solved, weight: Ex<'m>| {
            if is_end(solutions, &solved) {
                *flow.ends.entry(solved).or_insert(zero) += weight;
            } else {
                add_weight(solutions, open, solved, weight);
            }
        };
    for (solved, weight) in weights {
        add(&algebra.solutions, &mut open, solved, weight);
    }
    while let Some((system, weights)) = open.pop_last() {
        let factors = solve_transposed(
            algebra.graph,
            &mut algebra.solutions,
            system.group,
            &weights,
        );
        if factors.iter().all(|factor| factor.is_zero()) {
            continue;
        }
        let found = Multiplier {
            system,
            weights,
            factors,
        };
        for solved in mentioned::mentioned_by(algebra, &found.system) {
            let variable = partial::symbol_for(algebra, &solved);
            let weight = minus_slope(algebra, zero, &found, variable);
            add(&algebra.solutions, &mut open, solved, weight);
        }
        flow.multipliers.push(found);
    }
    for (index, multiplier) in flow.multipliers.iter().enumerate() {
        flow.acting.add(
            index,
            &acting::acting_on_system(algebra, &multiplier.system),
        );
    }
    flow
}

fn add_weight<'m>(
    solutions: &Solutions<'m>,
    open: &mut BTreeMap<System, Vec<Ex<'m>>>,
    solved: Solved,
    weight: Ex<'m>,
) {
    let count = solutions.groups[solved.system.group].jacobian.len();
    let zero = weight.number(0.0);
    let weights = open
        .entry(solved.system)
        .or_insert_with(|| vec![zero; count]);
    weights[solved.position] += weight;
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
        let links = links::terms_of_links(&algebra.solutions, system.group);
        let zero = algebra.zero();
        let mut slope = |x| partial::partial(algebra, x, variable);
        let written = solution
            .rows
            .get(row)
            .and_then(|written| written.links.as_ref());
        if let Some(links) = written {
            return written_rows::slope_of_squares(links, &mut slope);
        }
        // Those of links are found by themselves.
        let terms = &solution.terms[links..];
        return partial::sum_of_slopes(zero, terms, row, |a, b| a + b, &mut slope);
    }
    // J r - right
    let rates = algebra.rates(system.group, system.by.clone());
    let right = partial::partial(algebra, rates.right[row], variable);
    let columns = solution.jacobian.iter().zip(&rates.rates);
    columns.fold(-right, |sum, (column, &rate)| {
        sum + partial::partial(algebra, column[row], variable) * rate
    })
}

/// `J^T l = weights` by Cramer's rule. The determinant is known from the closed form. Computed from
/// the scaled weights, of which there are fewer; differentiated as the quotients, whose derivatives
/// stay in range for lengths of any unit.
pub(crate) fn solve_transposed<'m>(
    graph: &'m Graph,
    solutions: &mut Solutions<'m>,
    group: usize,
    weights: &[Ex<'m>],
) -> Vec<Ex<'m>> {
    let solution = solutions.groups[group].clone();
    if solution.elimination.is_some() {
        return elimination::eliminate_transposed(graph, &solution, weights);
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
            by_rule::symbol_for_value(
                graph,
                solutions,
                name,
                value,
                DerivativeRule::Follow(quotient),
            )
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
