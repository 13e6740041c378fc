//! Freudenstein's ratios, which are linear in his equation.

use nalgebra::{Matrix4, SVD};

/// Factors of the ratios, and the left side.
pub(super) fn row(input: f64, output: f64) -> [f64; 4] {
    [output.cos(), -input.cos(), 1.0, (input - output).cos()]
}

/// The ratios to which four rows belong that depend on each other.
pub(super) fn ratios(rows: &[[f64; 4]; 4]) -> Option<[f64; 3]> {
    let svd = SVD::new(Matrix4::from_fn(|i, j| rows[i][j]), false, true);
    let vectors = svd.v_t?;
    Some([0, 1, 2].map(|j| -vectors[(3, j)] / vectors[(3, 3)]))
}
