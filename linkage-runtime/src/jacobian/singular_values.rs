//! Singular values by turning columns until they are perpendicular (one-sided Jacobi), which finds
//! small ones to full relative accuracy (J. Demmel, K. Veselic, "Jacobi's method is more accurate
//! than QR", SIAM J. Matrix Anal. Appl. 13, 1992).

use linkage_core::Scalar;

use super::vectors::dot;

/// Each sweep over all pairs squares the remaining products. For any matrix of up to six columns
/// none remain after eight, and the last two are for columns of very different lengths.
const SWEEPS: usize = 10;

/// The singular values of a matrix by its columns, the largest first.
pub(super) fn singular_values<T: Scalar, const N: usize>(mut columns: [[T; N]; N]) -> [T; N] {
    for _ in 0..SWEEPS {
        for second in 1..N {
            for first in 0..second {
                let [a, b] = perpendicular(columns[first], columns[second]);
                columns[first] = a;
                columns[second] = b;
            }
        }
    }
    sorted(columns.map(|column| dot(column, column).sqrt()))
}

/// Two columns turned in their plane so that they are perpendicular.
fn perpendicular<T: Scalar, const N: usize>(a: [T; N], b: [T; N]) -> [[T; N]; 2] {
    let [zero, one] = [0.0, 1.0].map(T::from_f64);
    let product = dot(a, b);
    let twice = product + product;
    let difference = dot(b, b) - dot(a, a);
    // The smaller root of t^2 + 2 (difference / twice) t - 1 = 0.
    let divisor = difference.abs() + (difference * difference + twice * twice).sqrt();
    let tangent = T::select(-divisor, zero, difference.sign() * twice / divisor);
    let cosine = one / (one + tangent * tangent).sqrt();
    let sine = cosine * tangent;
    [
        core::array::from_fn(|k| cosine * a[k] - sine * b[k]),
        core::array::from_fn(|k| sine * a[k] + cosine * b[k]),
    ]
}

fn sorted<T: Scalar, const N: usize>(mut values: [T; N]) -> [T; N] {
    for end in (1..N).rev() {
        for k in 0..end {
            let (a, b) = (values[k], values[k + 1]);
            values[k] = a.max(b);
            values[k + 1] = a.min(b);
        }
    }
    values
}
