//! Systems of numbers, solved as expressions.

use linkage_symbolic::evaluate;

use crate::algebra::pivots;

use super::*;

/// Numbers from -1 to 1 without a pattern.
pub(crate) fn numbers(count: usize, seed: u32) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state) / f64::from(u32::MAX) * 2.0 - 1.0
    };
    (0..count).map(|_| next()).collect()
}

fn solved(order: &Order, matrix: &[Vec<f64>], right: &[f64]) -> (Vec<f64>, f64) {
    let graph = Graph::new();
    let number = |&x: &f64| graph.number(x);
    let lift = |row: &[f64]| row.iter().map(number).collect::<Vec<_>>();
    let rows: Vec<Vec<Ex>> = matrix.iter().map(|row| lift(row)).collect();
    let InOrder {
        mut solution,
        determinant,
    } = pivots::solve_in_order(&graph, order, &rows, &lift(right));
    let once = pivots::solve_once_in_order(&graph, order, &rows, &lift(right));
    for (single, shared) in once.solution.iter().zip(&solution) {
        let [single, shared] = [single, shared].map(|x| evaluate(&[*x], |_| f64::NAN)[0]);
        let both = single.is_nan() && shared.is_nan();
        assert!(both || (single - shared).abs() <= 1e-9 * shared.abs());
    }
    solution.push(determinant);
    let mut all = evaluate(&solution, |_| f64::NAN);
    let determinant = all.pop().expect("it was pushed");
    (all, determinant)
}

/// Returns the determinant by the first row, column by column.
fn determinant(matrix: &[Vec<f64>]) -> f64 {
    let Some((first, below)) = matrix.split_first() else {
        return 1.0;
    };
    let without = |k: usize| {
        let rows = below.iter();
        let rows = rows.map(|row| [&row[..k], &row[k + 1..]].concat());
        rows.collect::<Vec<_>>()
    };
    let terms = first.iter().enumerate();
    let terms = terms.map(|(k, x)| if k % 2 == 0 { *x } else { -*x } * determinant(&without(k)));
    terms.sum()
}

/// A matrix with zeros.
fn matrix(size: usize, seed: u32) -> Vec<Vec<f64>> {
    let all = numbers(2 * size * size, seed);
    let (values, zeros) = all.split_at(size * size);
    let entry = |k: usize| if zeros[k] > 0.4 { 0.0 } else { values[k] };
    let rows = 0..size;
    rows.map(|i| (0..size).map(|j| entry(i * size + j)).collect())
        .collect()
}

fn order(matrix: &[Vec<f64>]) -> Order {
    let zero = matrix
        .iter()
        .map(|row| row.iter().map(|&x| x == 0.0).collect());
    Order::new(matrix, &zero.collect::<Vec<_>>())
}

#[test]
fn systems_of_all_sizes_are_solved_and_their_determinants_have_the_sign() {
    for size in 4..=8 {
        for seed in 1..=20 {
            let matrix = matrix(size, seed * 7919);
            let known = determinant(&matrix);
            if known.abs() < 1e-3 {
                continue;
            }
            let right = numbers(size, seed);
            let (solution, found) = solved(&order(&matrix), &matrix, &right);
            assert!((found - known).abs() < 1e-12 * (1.0 + known.abs()));
            for (row, right) in matrix.iter().zip(&right) {
                let left: f64 = row.iter().zip(&solution).map(|(a, x)| a * x).sum();
                assert!((left - right).abs() < 1e-11 / known.abs());
            }
        }
    }
}

#[test]
fn the_transposed_matrix_has_the_transposed_order() {
    let original = matrix(7, 77);
    let transposed: Vec<Vec<f64>> = (0..7)
        .map(|j| original.iter().map(|row| row[j]).collect())
        .collect();
    let right = numbers(7, 5);
    let (solution, found) = solved(&order(&original).transposed(), &transposed, &right);
    assert!((found - determinant(&original)).abs() < 1e-13);
    for (row, right) in transposed.iter().zip(&right) {
        let left: f64 = row.iter().zip(&solution).map(|(a, x)| a * x).sum();
        assert!((left - right).abs() < 1e-12);
    }
}

#[test]
fn a_pivot_that_vanishes_or_changes_its_sign_gives_no_number() {
    let at_reference = matrix(6, 11);
    let order = order(&at_reference);
    let Pivot { row, column, .. } = order.pivots[0];
    for factor in [1.0 / 2048.0, 0.0, -1.0] {
        let mut elsewhere = at_reference.clone();
        elsewhere[row][column] *= factor;
        let (solution, found) = solved(&order, &elsewhere, &[1.0; 6]);
        assert!(found.is_nan() && solution.iter().any(|x| x.is_nan()));
    }
}
