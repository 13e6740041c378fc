//! Products of vectors, and matrices with rows and columns exchanged.

use linkage_core::Scalar;

pub(super) fn dot<T: Scalar, const N: usize>(a: [T; N], b: [T; N]) -> T {
    let products = a.into_iter().zip(b).map(|(a, b)| a * b);
    products.fold(T::from_f64(0.0), |sum, product| sum + product)
}

pub(super) fn transposed<T: Copy, const N: usize>(matrix: [[T; N]; N]) -> [[T; N]; N] {
    core::array::from_fn(|row| core::array::from_fn(|column| matrix[column][row]))
}
