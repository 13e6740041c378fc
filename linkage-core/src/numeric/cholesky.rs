//! Cholesky's factorisation of symmetric positive definite matrices, of which the lower triangles
//! are given row by row.

use super::vector::dot;
use crate::math::double::sqrt;
use alloc::vec;
use alloc::vec::Vec;

/// Solves `matrix * x = right`; `None` if the matrix is not positive definite. Rows may end with
/// the diagonal.
pub fn solve(matrix: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let n = right.len();
    let mut lower = vec![0.0; n * n];
    for (i, row) in matrix.iter().enumerate() {
        lower[i * n..=i * n + i].copy_from_slice(&row[..=i]);
    }
    factor(&mut lower, n, |_, rest| (rest > 0.0).then_some(rest))?;
    let mut x = right.to_vec();
    substitute(&lower, &mut x);
    Some(x)
}

/// A matrix as the product of a lower triangle and its transpose.
pub struct Cholesky<const N: usize> {
    lower: [[f64; N]; N],
}

impl<const N: usize> Cholesky<N> {
    /// Factors a matrix. A pivot counts as at least `least` of its diagonal, where rounding has
    /// taken it away.
    pub fn with_least_pivot(mut matrix: [[f64; N]; N], least: f64) -> Self {
        factor(matrix.as_flattened_mut(), N, |diagonal, rest| {
            Some(rest.max(least * diagonal))
        });
        Self { lower: matrix }
    }

    /// Returns the solution with this right-hand side.
    pub fn solve(&self, mut right: [f64; N]) -> [f64; N] {
        substitute(self.lower.as_flattened(), &mut right);
        right
    }
}

/// Replaces the lower triangle of `n` rows by its factor. `pivot` gives the square of a pivot, from
/// the diagonal of the matrix and its rest after elimination; `None` ends the factorisation.
pub fn factor(lower: &mut [f64], n: usize, pivot: impl Fn(f64, f64) -> Option<f64>) -> Option<()> {
    for i in 0..n {
        let (above, row) = lower.split_at_mut(i * n);
        for j in 0..i {
            let inner = dot(&row[..j], &above[j * n..j * n + j]);
            row[j] = (row[j] - inner) / above[j * n + j];
        }
        let rest = row[i] - dot(&row[..i], &row[..i]);
        row[i] = sqrt(pivot(row[i], rest)?);
    }
    Some(())
}

/// Solves `lower * x = right` in place.
pub fn forward(lower: &[f64], x: &mut [f64]) {
    let n = x.len();
    for i in 0..n {
        let inner = dot(&lower[i * n..i * n + i], &x[..i]);
        x[i] = (x[i] - inner) / lower[i * n + i];
    }
}

/// Solves with a factor and its transpose, in place.
fn substitute(lower: &[f64], x: &mut [f64]) {
    forward(lower, x);
    let n = x.len();
    for i in (0..n).rev() {
        let inner: f64 = (i + 1..n).map(|k| lower[k * n + i] * x[k]).sum();
        x[i] = (x[i] - inner) / lower[i * n + i];
    }
}

#[cfg(test)]
mod tests {
    use super::{Cholesky, solve};
    use alloc::vec::Vec;

    const MATRIX: [[f64; 3]; 3] = [[4.0, 0.0, 0.0], [2.0, 5.0, 0.0], [-2.0, 3.0, 14.0]];
    const RIGHT: [f64; 3] = [2.0, 21.0, 46.0];

    fn rows<const N: usize>(matrix: [[f64; N]; N]) -> Vec<Vec<f64>> {
        matrix.map(|row| row.to_vec()).to_vec()
    }

    #[test]
    fn solves_or_says_that_it_cannot() {
        let x = solve(&rows(MATRIX), &RIGHT).expect("positive definite");
        for (found, known) in x.iter().zip([1.0, 2.0, 3.0]) {
            assert!((found - known).abs() < 1e-14);
        }
        assert_eq!(solve(&rows([[1.0, 0.0], [2.0, 1.0]]), &[1.0, 1.0]), None);
        let factored = Cholesky::with_least_pivot(MATRIX, 1e-15);
        assert_eq!(factored.solve(RIGHT)[..], x);
    }
}
