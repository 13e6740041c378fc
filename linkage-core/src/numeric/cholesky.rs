//! Symmetric positive definite systems of any size.

use crate::math::double::sqrt;
use alloc::vec::Vec;

/// Solves `matrix * x = right` by Cholesky's factorisation of the lower triangle; `None` if the matrix is not positive definite.
pub fn solve(mut matrix: Vec<Vec<f64>>, right: &[f64]) -> Option<Vec<f64>> {
    let n = right.len();
    for j in 0..n {
        for i in j..n {
            let inner: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let rest = matrix[i][j] - inner;
            matrix[i][j] = match i == j {
                true if rest > 0.0 => sqrt(rest),
                true => return None,
                false => rest / matrix[j][j],
            };
        }
    }
    let mut x = right.to_vec();
    for i in 0..n {
        let inner: f64 = (0..i).map(|k| matrix[i][k] * x[k]).sum();
        x[i] = (x[i] - inner) / matrix[i][i];
    }
    for i in (0..n).rev() {
        let inner: f64 = (i + 1..n).map(|k| matrix[k][i] * x[k]).sum();
        x[i] = (x[i] - inner) / matrix[i][i];
    }
    Some(x)
}

#[cfg(test)]
mod tests {
    use super::solve;
    use alloc::vec;

    #[test]
    fn solves_or_says_that_it_cannot() {
        let matrix = vec![
            vec![4.0, 0.0, 0.0],
            vec![2.0, 5.0, 0.0],
            vec![-2.0, 3.0, 14.0],
        ];
        let x = solve(matrix, &[2.0, 21.0, 46.0]).expect("positive definite");
        for (found, known) in x.into_iter().zip([1.0, 2.0, 3.0]) {
            assert!((found - known).abs() < 1e-14);
        }
        let indefinite = vec![vec![1.0, 0.0], vec![2.0, 1.0]];
        assert_eq!(solve(indefinite, &[1.0, 1.0]), None);
    }
}
