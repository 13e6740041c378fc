//! Cholesky's factorisation of symmetric positive definite matrices, of which the lower triangles
//! are given by rows.

use crate::math::double::sqrt;
use alloc::vec::Vec;

/// Solves `matrix * x = right`; `None` if the matrix is not positive definite.
pub fn solve(mut matrix: Vec<Vec<f64>>, right: &[f64]) -> Option<Vec<f64>> {
    factor(&mut matrix, |_, rest| (rest > 0.0).then_some(rest))?;
    let mut x = right.to_vec();
    substitute(&matrix, &mut x);
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
        factor(&mut matrix, |diagonal, rest| {
            Some(rest.max(least * diagonal))
        });
        Self { lower: matrix }
    }

    /// Returns the solution with this right-hand side.
    pub fn solve(&self, mut right: [f64; N]) -> [f64; N] {
        substitute(&self.lower, &mut right);
        right
    }
}

/// Replaces the lower triangle by its factor. `pivot` gives the square of a pivot, from the
/// diagonal of the matrix and its rest after elimination.
fn factor<R: AsRef<[f64]> + AsMut<[f64]>>(
    rows: &mut [R],
    pivot: impl Fn(f64, f64) -> Option<f64>,
) -> Option<()> {
    for j in 0..rows.len() {
        for i in j..rows.len() {
            let (row, above) = (rows[i].as_ref(), rows[j].as_ref());
            let inner: f64 = (0..j).map(|k| row[k] * above[k]).sum();
            let rest = row[j] - inner;
            rows[i].as_mut()[j] = if i == j {
                sqrt(pivot(row[j], rest)?)
            } else {
                rest / above[j]
            };
        }
    }
    Some(())
}

/// Solves with a factor, in place.
fn substitute<R: AsRef<[f64]>>(lower: &[R], x: &mut [f64]) {
    for i in 0..x.len() {
        let row = lower[i].as_ref();
        let inner: f64 = (0..i).map(|k| row[k] * x[k]).sum();
        x[i] = (x[i] - inner) / row[i];
    }
    for i in (0..x.len()).rev() {
        let below = (i + 1..x.len()).map(|k| lower[k].as_ref()[i] * x[k]);
        x[i] = (x[i] - below.sum::<f64>()) / lower[i].as_ref()[i];
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
        let x = solve(rows(MATRIX), &RIGHT).expect("positive definite");
        for (found, known) in x.iter().zip([1.0, 2.0, 3.0]) {
            assert!((found - known).abs() < 1e-14);
        }
        assert_eq!(solve(rows([[1.0, 0.0], [2.0, 1.0]]), &[1.0, 1.0]), None);
        let factored = Cholesky::with_least_pivot(MATRIX, 1e-15);
        assert_eq!(factored.solve(RIGHT)[..], x);
    }
}
