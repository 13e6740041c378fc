//! Symmetric positive definite systems.

use linkage_core::math::double::sqrt;

/// A matrix as the product of a lower triangle and its transpose.
pub(super) struct Cholesky<const N: usize> {
    lower: [[f64; N]; N],
}

/// The least part of its diagonal that a pivot counts as, where rounding has taken it away.
const LEAST_PIVOT: f64 = 1e-15;

impl<const N: usize> Cholesky<N> {
    /// Cholesky factor of a matrix whose lower half is given.
    pub(super) fn new(mut matrix: [[f64; N]; N]) -> Self {
        for j in 0..N {
            let diagonal = matrix[j][j];
            let taken: f64 = matrix[j][..j].iter().map(|x| x * x).sum();
            matrix[j][j] = sqrt((diagonal - taken).max(LEAST_PIVOT * diagonal));
            for i in j + 1..N {
                let taken: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
                matrix[i][j] = (matrix[i][j] - taken) / matrix[j][j];
            }
        }
        Self { lower: matrix }
    }

    /// The solution with this right-hand side.
    pub(super) fn solve(&self, mut right: [f64; N]) -> [f64; N] {
        for j in 0..N {
            let taken: f64 = (0..j).map(|k| self.lower[j][k] * right[k]).sum();
            right[j] = (right[j] - taken) / self.lower[j][j];
        }
        for j in (0..N).rev() {
            let taken: f64 = (j + 1..N).map(|k| self.lower[k][j] * right[k]).sum();
            right[j] = (right[j] - taken) / self.lower[j][j];
        }
        right
    }
}

#[cfg(test)]
mod tests {
    use super::Cholesky;

    #[test]
    fn solves() {
        let system = Cholesky::new([[4.0, 0.0, 0.0], [2.0, 5.0, 0.0], [-2.0, 3.0, 14.0]]);
        let x = system.solve([2.0, 21.0, 46.0]);
        for (found, known) in x.into_iter().zip([1.0, 2.0, 3.0]) {
            assert!((found - known).abs() < 1e-14, "{x:?}");
        }
    }
}
