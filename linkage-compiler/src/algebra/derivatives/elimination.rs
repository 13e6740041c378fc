//! The linear systems of coupled groups: private unknowns are eliminated, the core is solved by
//! cofactors.
//!
//! In a loop with a private unknown, whose column is `c`, a multiplier `m` across `c` gives one
//! equation without it: `m . column` for every other unknown. The rest is a small square matrix,
//! the same for every right-hand side. Cofactors need no choice of pivots, which would be a branch,
//! and no division but the last. They grow with the factorial of the size: larger matrices are
//! eliminated in an order that is known before (`pivots`).

use linkage_symbolic::{Ex, Graph, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::rotation_variation::BodyRotations;
use crate::algebra::derivatives::{by_rule, rotation_variation, written_rows};
use crate::algebra::equations::Solution;
use crate::algebra::{bodies, cofactors};

/// The unknowns of `J r = right`, the core first: derivatives by some variables.
pub(crate) fn eliminate<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    right: &[Ex<'m>],
    by: &[SymbolId],
) -> Vec<Ex<'m>> {
    let solution = algebra.solutions.groups[group].clone();
    let Some(elimination) = &solution.elimination else {
        unreachable!("closed forms are solved by Cramer's rule");
    };
    let graph = algebra.graph;
    let of_core = |right: &[Ex<'m>]| -> Vec<Ex<'m>> {
        let rows = elimination.rows.iter();
        rows.map(|row| cofactors::product_sum(graph, &row.factors, &right[row.first..]))
            .collect()
    };
    let core = of_core(right);
    let quotients = match &elimination.scheme {
        Some(scheme) if by.len() > 1 && elimination.privates.is_empty() => {
            let turns = rotation_variation::rotations_by_both(algebra, group, by);
            let bodies = &scheme.bodies;
            let shifts = match &turns {
                Some(turns) => {
                    rotation_variation::shifts_by_rotations(algebra, bodies, group, turns)
                }
                None => bodies.shifts(&core),
            };
            // The rest in the other equations is a derivative like others: by the entries of the
            // matrix it takes more.
            let nothing = vec![algebra.zero(); scheme.freedoms.len()];
            let held = bodies.unknowns(&nothing, &shifts);
            let pairs = elimination.units.iter().zip(&held);
            let held = pairs.map(|(&unit, &shift)| unit * shift).collect();
            let left = written_rows::right_of_rows(algebra, group, by, held, turns.as_ref());
            let left = of_core(&left);
            let solved = bodies::solve_left_by_scheme(graph, scheme, &shifts, &left);
            if let Some(BodyRotations { by, .. }) = turns {
                let second = &mut algebra.derivatives.second_rotations;
                second.insert((group, by), solved.turns);
            }
            solved.solution
        }
        Some(scheme) => {
            let solved = bodies::solve_by_scheme(graph, scheme, &elimination.matrix, &core);
            if let (&[variable], Some(turns)) = (by, solved.turns) {
                algebra
                    .derivatives
                    .rotations
                    .insert((group, variable), turns);
            }
            solved.solution
        }
        None => solve_core(
            algebra.graph,
            &elimination.matrix,
            &core,
            solution.determinant,
        ),
    };
    let mut rates = Vec::new();
    for (position, quotient) in quotients.into_iter().enumerate() {
        let rate = elimination.units[position] * quotient;
        rates.push(by_rule::rate_symbol(
            graph,
            &mut algebra.solutions,
            group,
            position,
            by,
            rate,
        ));
    }
    let count = rates.len();
    for (k, private) in elimination.privates.iter().enumerate() {
        let rows = [private.first, private.first + 1];
        let left = rows.map(|row| {
            let columns = solution.jacobian[..count].iter().zip(&rates);
            columns.fold(right[row], |sum, (column, &rate)| sum - column[row] * rate)
        });
        let column = rows.map(|row| solution.jacobian[count + k][row]);
        let rate = cofactors::product_sum(graph, &column, &left) / private.square;
        rates.push(by_rule::rate_symbol(
            graph,
            &mut algebra.solutions,
            group,
            count + k,
            by,
            rate,
        ));
    }
    rates
}

/// The multipliers of `J^T l = weights`.
pub(crate) fn eliminate_transposed<'m>(
    graph: &'m Graph,
    solution: &Solution<'m>,
    weights: &[Ex<'m>],
) -> Vec<Ex<'m>> {
    let Some(elimination) = &solution.elimination else {
        unreachable!("closed forms are solved by Cramer's rule");
    };
    let count = elimination.units.len();
    let zero = graph.number(0.0);
    let mut multipliers = vec![zero; solution.jacobian[0].len()];
    for (k, private) in elimination.privates.iter().enumerate() {
        let factor = weights[count + k] / private.square;
        for row in [private.first, private.first + 1] {
            multipliers[row] = factor * solution.jacobian[count + k][row];
        }
    }
    let core: Vec<Ex> = (0..count)
        .map(|position| {
            let known = cofactors::product_sum(graph, &multipliers, &solution.jacobian[position]);
            elimination.units[position] * (weights[position] - known)
        })
        .collect();
    let factors: Vec<Ex> = match &elimination.scheme {
        Some(scheme) => {
            bodies::solve_transposed_by_scheme(graph, scheme, &elimination.matrix, &core)
        }
        None => {
            let transposed: Vec<Vec<Ex>> = (0..count)
                .map(|column| elimination.matrix.iter().map(|row| row[column]).collect())
                .collect();
            let numerators = cofactors::cofactor_products(graph, &transposed, &core).into_iter();
            numerators
                .map(|numerator| numerator / solution.determinant)
                .collect()
        }
    };
    for (row, factor) in elimination.rows.iter().zip(factors) {
        for (k, &share) in row.factors.iter().enumerate() {
            multipliers[row.first + k] += factor * share;
        }
    }
    multipliers
}

/// Solves a linear system. A right-hand side that is mostly 0 is divided by the determinant itself.
fn solve_core<'m>(
    graph: &'m Graph,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
    determinant: Ex<'m>,
) -> Vec<Ex<'m>> {
    let entries = right.iter().filter(|x| !x.is_zero()).count();
    if entries < right.len() {
        let right: Vec<Ex> = right.iter().map(|&x| x / determinant).collect();
        return cofactors::cofactor_products(graph, matrix, &right);
    }
    let numerators = cofactors::cofactor_products(graph, matrix, right).into_iter();
    numerators
        .map(|numerator| numerator / determinant)
        .collect()
}
