//! A matrix as reflections and a triangle (Householder): no pivots, hence no branch, and as stable
//! as with them.

use linkage_core::Scalar;

use super::vectors::{dot, transposed};

/// `Q R` of a square matrix.
pub(super) struct Factors<T, const N: usize> {
    /// The vectors across which columns are reflected, each with 2 over its square; 0 for one that
    /// is zero.
    mirrors: [([T; N], T); N],
    /// The triangle, by columns.
    triangle: [[T; N]; N],
}

impl<T: Scalar, const N: usize> Factors<T, N> {
    pub(super) fn new(rows: [[T; N]; N]) -> Self {
        let zero = T::from_f64(0.0);
        let mut columns = transposed(rows);
        let mut mirrors = [([zero; N], zero); N];
        for step in 0..N {
            let below: [T; N] =
                core::array::from_fn(|row| if row < step { zero } else { columns[step][row] });
            let length = dot(below, below).sqrt();
            let mut mirror = below;
            mirror[step] = mirror[step] + mirror[step].sign() * length;
            let square = dot(mirror, mirror);
            let twice = T::from_f64(2.0) / square;
            // A column of zeros is left as it is.
            let factor = T::select(-square, zero, twice);
            for column in &mut columns[step..] {
                *column = reflected(*column, mirror, factor);
            }
            mirrors[step] = (mirror, factor);
        }
        Self {
            mirrors,
            triangle: columns,
        }
    }

    /// Each mirror that is one changes the sign.
    pub(super) fn determinant(&self) -> T {
        let steps = self.mirrors.iter().zip(&self.triangle).enumerate();
        steps.fold(T::from_f64(1.0), |product, (k, ((_, factor), column))| {
            let sign = T::select(-*factor, T::from_f64(1.0), T::from_f64(-1.0));
            product * sign * column[k]
        })
    }

    /// The vector that the matrix brings to this one.
    pub(super) fn solve(&self, right: [T; N]) -> [T; N] {
        let mirrors = self.mirrors.iter();
        let mut x = mirrors.fold(right, |x, (mirror, factor)| reflected(x, *mirror, *factor));
        for k in (0..N).rev() {
            x[k] = x[k] / self.triangle[k][k];
            for row in 0..k {
                x[row] = x[row] - self.triangle[k][row] * x[k];
            }
        }
        x
    }
}

fn reflected<T: Scalar, const N: usize>(v: [T; N], mirror: [T; N], factor: T) -> [T; N] {
    let along = factor * dot(v, mirror);
    core::array::from_fn(|k| v[k] - along * mirror[k])
}
