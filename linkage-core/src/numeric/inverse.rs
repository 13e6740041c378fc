//! Inverses of small matrices.

use alloc::vec;
use alloc::vec::Vec;

/// The inverse of a matrix by rows, by elimination with the largest pivots; nothing where one is 0
/// or not finite.
pub fn inverse(mut matrix: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let count = matrix.len();
    for (k, row) in matrix.iter_mut().enumerate() {
        let mut unit = vec![0.0; count];
        unit[k] = 1.0;
        row.extend(unit);
    }
    for column in 0..count {
        let size = |row: &usize| matrix[*row][column].abs();
        let pivot = (column..count).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        matrix.swap(column, pivot);
        let factor = 1.0 / matrix[column][column];
        if !factor.is_finite() || factor == 0.0 {
            return None;
        }
        matrix[column].iter_mut().for_each(|x| *x *= factor);
        let pivot_row = matrix[column].clone();
        for (_, row) in matrix
            .iter_mut()
            .enumerate()
            .filter(|(row, _)| *row != column)
        {
            let factor = row[column];
            row.iter_mut()
                .zip(&pivot_row)
                .for_each(|(x, pivot)| *x -= factor * pivot);
        }
    }
    Some(
        matrix
            .into_iter()
            .map(|row| row[count..].to_vec())
            .collect(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_times_its_inverse_is_one() {
        let matrix = vec![
            vec![0.0, 2.0, -1.0],
            vec![1e-3, 1.0, 4.0],
            vec![3.0, -2.0, 0.5],
        ];
        let inverse = inverse(matrix.clone()).expect("it is regular");
        for (i, row) in matrix.iter().enumerate() {
            let products = |j: usize| row.iter().zip(&inverse).map(move |(x, row)| x * row[j]);
            let product: Vec<f64> = (0..3).map(|j| products(j).sum()).collect();
            let off = product.iter().enumerate();
            let off = off.map(|(j, x)| (x - if i == j { 1.0 } else { 0.0 }).abs());
            assert!(off.fold(0.0, f64::max) < 1e-15, "{product:?}");
        }
    }

    #[test]
    fn a_singular_matrix_has_none() {
        assert_eq!(inverse(vec![vec![1.0, 2.0], vec![2.0, 4.0]]), None);
        assert_eq!(inverse(vec![vec![f64::NAN]]), None);
    }
}
