//! Vectors that a matrix makes zero.

use linkage_core::numeric::rank;

/// A pivot below this part of the largest entry is zero: entries are differences, exact to some
/// 1e-10.
pub(crate) const ZERO: f64 = 1e-6;

/// The same of the last pivot where a way was followed to a dead point: it ends shortly before it.
pub(crate) const NEARLY_ZERO: f64 = 0.02;

/// Shares of a null vector below this part of the largest one are none.
pub(crate) const LITTLE: f64 = 1e-3;

pub(crate) fn largest(all: &[f64]) -> f64 {
    all.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

pub(crate) fn transposed(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let width = matrix.first().map_or(0, Vec::len);
    let column = |k: usize| matrix.iter().map(|row| row[k]).collect();
    (0..width).map(column).collect()
}

/// The places of a null vector that count.
pub(crate) fn used(vector: &[f64]) -> Vec<usize> {
    let most = largest(vector);
    let used = (0..vector.len()).filter(|&k| vector[k].abs() > LITTLE * most);
    used.collect()
}

/// Returns the null vectors of a matrix with `width` columns. The last pivot is zero below `last`.
pub(crate) fn null_vectors(matrix: &[Vec<f64>], width: usize, last: f64) -> Vec<Vec<f64>> {
    rank::null_vectors(matrix, width, [ZERO, last])
}
