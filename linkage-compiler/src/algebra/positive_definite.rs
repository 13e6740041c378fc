//! Linear systems with a symmetric, positive definite matrix.

use linkage_symbolic::Ex;

/// Returns the solution of a system, given the lower triangle of its matrix by rows.
///
/// The factors are `L D L^T`: a positive definite matrix needs no choice of pivots, at no position.
/// Where a pivot is zero, the unknowns that depend on it are NaN.
pub(crate) fn solve<'m>(mut matrix: Vec<Vec<Ex<'m>>>, mut right: Vec<Ex<'m>>) -> Vec<Ex<'m>> {
    let size = right.len();
    let mut factors = Vec::new();
    for j in 0..size {
        let below: Vec<usize> = (j + 1..size).filter(|&i| !matrix[i][j].is_zero()).collect();
        let pivot = Pivot::new(matrix[j][j], !below.is_empty());
        let column: Vec<(usize, Ex)> = below
            .iter()
            .map(|&i| (i, pivot.share(matrix[i][j])))
            .collect();
        for &(i, factor) in &column {
            for &k in below.iter().take_while(|&&k| k <= i) {
                let entry = matrix[k][j];
                matrix[i][k] -= factor * entry;
            }
            let value = right[j];
            right[i] -= factor * value;
        }
        right[j] = pivot.share(right[j]);
        factors.push(column);
    }
    for (j, column) in factors.iter().enumerate().rev() {
        for &(i, factor) in column {
            let value = right[i];
            right[j] -= factor * value;
        }
    }
    right
}

/// A divisor of one number or of several.
enum Pivot<'m> {
    Divisor(Ex<'m>),
    /// Its reciprocal, which costs one division for all numbers.
    Reciprocal(Ex<'m>),
}

impl<'m> Pivot<'m> {
    fn new(pivot: Ex<'m>, several: bool) -> Self {
        // A fixed pivot has its reciprocal before the call.
        if several || pivot.is_fixed() {
            Pivot::Reciprocal(pivot.number(1.0).quotient(pivot))
        } else {
            Pivot::Divisor(pivot)
        }
    }

    fn share(&self, x: Ex<'m>) -> Ex<'m> {
        match *self {
            _ if x.is_zero() => x,
            Pivot::Divisor(pivot) => x.quotient(pivot),
            Pivot::Reciprocal(reciprocal) => x * reciprocal,
        }
    }
}

#[cfg(test)]
mod tests {
    use linkage_random::Random;
    use linkage_symbolic::program::Source;
    use linkage_symbolic::{Graph, evaluate};

    use super::*;

    /// The solution for the rows of a lower triangle. `None` is a zero that the graph knows.
    fn solved(rows: &[Vec<Option<f64>>], right: &[f64]) -> Vec<f64> {
        let graph = Graph::new();
        let mut values = Vec::new();
        let mut number = |value: Option<f64>| match value {
            None => graph.number(0.0),
            Some(value) => {
                values.push(value);
                graph.ex(graph.source(Source::Input(values.len() - 1)))
            }
        };
        let matrix = rows
            .iter()
            .map(|row| row.iter().map(|&x| number(x)).collect());
        let matrix = matrix.collect();
        let right = right.iter().map(|&x| number(Some(x))).collect();
        evaluate(&solve(matrix, right), |source| match source {
            Source::Input(index) => values[index],
            _ => f64::NAN,
        })
    }

    #[test]
    fn solutions_solve_the_system() {
        let mut random = Random::new(0xd1);
        for size in 1..=6 {
            let mut numbers =
                || -> Vec<f64> { (0..size).map(|_| random.between(-1.0, 1.0)).collect() };
            let root: Vec<Vec<f64>> = (0..size).map(|_| numbers()).collect();
            let right = numbers();
            // The product of the root and its transpose.
            let entry = |i: usize, j: usize| -> f64 {
                root[i].iter().zip(&root[j]).map(|(a, b)| a * b).sum()
            };
            let row = |i: usize| (0..=i).map(|j| Some(entry(i, j))).collect();
            let rows: Vec<Vec<Option<f64>>> = (0..size).map(row).collect();
            let found = solved(&rows, &right);
            let scale = found.iter().fold(1.0, |scale: f64, x| scale.max(x.abs()));
            for (i, expected) in right.iter().enumerate() {
                let sum: f64 = (0..size).map(|j| entry(i, j) * found[j]).sum();
                assert!(
                    (sum - expected).abs() < 1e-13 * scale,
                    "{size}: {sum} {expected}"
                );
            }
        }
    }

    #[test]
    fn a_pivot_of_zero_is_no_number_for_its_unknowns_alone() {
        let apart = [
            vec![Some(0.0)],
            vec![None, Some(2.0)],
            vec![None, Some(1.0), Some(2.0)],
        ];
        let found = solved(&apart, &[1.0, 3.0, 3.0]);
        assert!(found[0].is_nan() && found[1..] == [1.0, 1.0], "{found:?}");
        // Of rank 1.
        let coupled = [vec![Some(4.0)], vec![Some(2.0), Some(1.0)]];
        let found = solved(&coupled, &[1.0, 3.0]);
        assert!(found.iter().all(|x| x.is_nan()), "{found:?}");
    }
}
