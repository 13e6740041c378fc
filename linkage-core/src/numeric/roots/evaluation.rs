//! Values of a homotopy.

use crate::numeric::complex_matrix::{Matrix, Vector};

/// Values and derivatives at a point.
pub(super) struct Evaluation<const N: usize> {
    pub(super) values: Vector<N>,
    pub(super) matrix: Matrix<N>,
    /// Derivatives with respect to `t`.
    pub(super) drift: Vector<N>,
}
