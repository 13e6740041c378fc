//! Systems of numbers with bodies in them, against the same systems with an order of their own.

use linkage_symbolic::evaluate;

use crate::algebra::pivots::tests::numbers;
use crate::algebra::{bodies, pivots};

use super::*;

/// A direction of length 1, or near it.
fn unit([x, y, z]: [f64; 3]) -> [f64; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// A body whose components stand among the unknowns in some order: its axes.
fn axes(seed: u32) -> [[f64; 3]; 2] {
    let all = numbers(6, seed);
    let u = unit([all[0], all[1], all[2]]);
    let w = unit(cross(u, [all[3], all[4], all[5]]));
    [u, w]
}

/// Bodies, other unknowns beside each, and equations of the bodies between others.
fn matrix(bodies: usize, seed: u32) -> (Vec<Vec<f64>>, Vec<[[f64; 3]; 2]>) {
    let size = 8 * bodies;
    let mut rows: Vec<Vec<f64>> = numbers(size * size, seed)
        .chunks(size)
        .map(<[f64]>::to_vec)
        .collect();
    let all: Vec<_> = (0..bodies).map(|k| axes(seed + 31 * k as u32)).collect();
    for (body, [u, w]) in all.iter().enumerate() {
        let first = 8 * body + 1;
        for row in [2, 3, 6] {
            rows[8 * body + row].fill(0.0);
        }
        for k in 0..3 {
            rows[8 * body + 6][first + k] = u[k];
            rows[8 * body + 2][first + 3 + k] = w[k];
            rows[8 * body + 3][first + k] = w[k];
            rows[8 * body + 3][first + 3 + k] = u[k];
        }
    }
    (rows, all)
}

fn check(bodies: usize, seed: u32) {
    let (rows, axes) = matrix(bodies, seed);
    let size = rows.len();
    let right = numbers(size, seed + 5);
    let graph = &Graph::new();
    let lift = |row: &[f64]| row.iter().map(|&x| graph.number(x)).collect::<Vec<_>>();
    let matrix: Vec<Vec<Ex>> = rows.iter().map(|row| lift(row)).collect();
    let body_and_position = |k: usize| (k / 8, (k % 8).checked_sub(1).filter(|k| *k < 6));
    let unknowns = (0..size).map(|k| {
        let (body, position) = body_and_position(k);
        position.map(|k| graph.number(axes[body][k / 3][k % 3]))
    });
    let bodies = Bodies::in_matrix(&matrix, &unknowns.collect::<Vec<_>>());
    assert_eq!(bodies.list.len(), axes.len());
    let order = |matrix: &[Vec<Ex>]| {
        let values: Vec<Vec<f64>> = matrix
            .iter()
            .map(|row| evaluate(row, |_| f64::NAN))
            .collect();
        let zero: Vec<Vec<bool>> = values
            .iter()
            .map(|row| row.iter().map(|x| *x == 0.0).collect())
            .collect();
        Order::new(&values, &zero)
    };
    let whole = order(&matrix);
    let freedoms = bodies.rows.iter();
    let freedoms: Vec<Vec<Ex>> = freedoms
        .map(|&row| bodies.by_freedoms(&matrix[row]))
        .collect();
    let scheme = Scheme {
        order: order(&freedoms),
        freedoms,
        bodies,
    };
    let right = lift(&right);
    let numbers = |all: &[Ex]| evaluate(all, |_| f64::NAN);
    let near = |found: Vec<f64>, known: Vec<f64>| {
        let largest = known.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        for (found, known) in found.iter().zip(&known) {
            let off = (found - known).abs();
            assert!(off < 1e-9 * largest, "seed {seed}: {found} {known}");
        }
    };
    let found = bodies::solve_by_scheme(graph, &scheme, &matrix, &right);
    let known = pivots::solve_in_order(graph, &whole, &matrix, &right);
    near(numbers(&found.solution), numbers(&known.solution));
    near(numbers(&[found.determinant]), numbers(&[known.determinant]));
    let transposed: Vec<Vec<Ex>> = (0..size)
        .map(|column| matrix.iter().map(|row| row[column]).collect())
        .collect();
    let found = bodies::solve_transposed_by_scheme(graph, &scheme, &matrix, &right);
    let known = pivots::solve_in_order(graph, &whole.transposed(), &transposed, &right);
    near(numbers(&found), numbers(&known.solution));
}

#[test]
fn systems_are_solved_in_the_freedoms_of_one_body_and_of_several() {
    for seed in 1..=20 {
        check(1, 7919 * seed);
        check(2, 104_729 * seed);
        check(3, 1_299_709 * seed);
    }
}
