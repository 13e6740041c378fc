//! The root of a matrix of correlations.

/// A matrix with a row for each parameter.
pub(super) type Square<const N: usize> = [[f64; N]; N];

/// Remainder of a variance of 1 that counts as nothing: roundoffs of some ten subtractions of
/// products, which may also be a little below 0.
const NOTHING: f64 = 1e-13;

/// The lower triangle `r` with `r * transposed(r)` equal to the matrix, by Cholesky's method; a
/// column of zeros where a quantity follows from those before it.
///
/// # Errors
///
/// The first row that contradicts those above it, and the variance that these leave.
pub(super) fn root<const N: usize>(correlations: &Square<N>) -> Result<Square<N>, (usize, f64)> {
    let mut root = [[0.0; N]; N];
    for i in 0..N {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| root[i][k] * root[j][k]).sum();
            let left = correlations[i][j] - known;
            if i == j {
                if left < -NOTHING {
                    return Err((i, left));
                }
                root[i][i] = if left > NOTHING { left.sqrt() } else { 0.0 };
            } else if root[j][j] > 0.0 {
                root[i][j] = left / root[j][j];
            } else if left.abs() > NOTHING.sqrt() {
                // Quantity j follows from those before it, and so does its correlation with i.
                return Err((i, left));
            }
        }
    }
    Ok(root)
}

/// No correlations.
pub(super) fn identity<const N: usize>() -> Square<N> {
    core::array::from_fn(|i| core::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }))
}

#[cfg(test)]
mod tests {
    use super::root;

    #[test]
    fn products_of_roots_are_the_correlations() {
        let matrices = [
            [[1.0, 0.5, -0.3], [0.5, 1.0, 0.2], [-0.3, 0.2, 1.0]],
            // The second follows from the first.
            [[1.0, -1.0, 0.4], [-1.0, 1.0, -0.4], [0.4, -0.4, 1.0]],
            // The third is the sum of the others, divided by its deviation.
            [[1.0, 0.0, 0.6], [0.0, 1.0, 0.8], [0.6, 0.8, 1.0]],
        ];
        for matrix in matrices {
            let root = root(&matrix).unwrap();
            for i in 0..3 {
                for j in 0..3 {
                    let product: f64 = (0..3).map(|k| root[i][k] * root[j][k]).sum();
                    assert!((product - matrix[i][j]).abs() < 1e-15, "{matrix:?}");
                }
            }
        }
    }

    #[test]
    fn what_no_quantities_have() {
        let (row, left) = root(&[[1.0, 0.9, 0.9], [0.9, 1.0, 0.0], [0.9, 0.0, 1.0]]).unwrap_err();
        assert_eq!(row, 2);
        // 1 - 0.9^2 - (0.81 / sqrt(0.19))^2
        assert!((left - (0.19 - 0.81 * 0.81 / 0.19)).abs() < 1e-14, "{left}");
        let (row, left) = root(&[[1.0, 1.0, 0.5], [1.0, 1.0, 0.3], [0.5, 0.3, 1.0]]).unwrap_err();
        assert_eq!(row, 2);
        assert!((left + 0.2).abs() < 1e-15, "{left}");
    }
}
