//! Small dense systems of linear equations in complex numbers.

use super::complex::{Complex, ONE, ZERO};

pub type Vector<const N: usize> = [Complex; N];
pub type Matrix<const N: usize> = [[Complex; N]; N];

/// Returns the square of the length.
#[inline(always)]
pub fn size<const N: usize>(vector: &Vector<N>) -> f64 {
    vector.iter().map(|component| component.square()).sum()
}

#[inline(always)]
pub fn sum<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    core::array::from_fn(|j| a[j] + b[j])
}

/// Solves `matrix * x = right` for several right sides in place, two equations by determinants.
/// Returns about the square of the smallest pivot; 0 for a singular matrix (the right sides are
/// spoilt then).
#[inline(always)]
pub fn solve<const N: usize, const R: usize>(
    matrix: &mut Matrix<N>,
    right: &mut [Vector<N>; R],
) -> f64 {
    if N == 2 {
        solve_two(matrix, right)
    } else {
        solve_many(matrix, right)
    }
}

#[inline(always)]
fn solve_two<const N: usize, const R: usize>(
    matrix: &Matrix<N>,
    right: &mut [Vector<N>; R],
) -> f64 {
    let ([a, b], [c, d]) = ([matrix[0][0], matrix[0][1]], [matrix[1][0], matrix[1][1]]);
    let determinant = a * d - b * c;
    let square = determinant.square();
    if square == 0.0 || !square.is_finite() {
        return 0.0;
    }
    let inverse = determinant.inverse();
    for side in right {
        let [x, y] = [side[0], side[1]];
        side[0] = (d * x - b * y) * inverse;
        side[1] = (a * y - c * x) * inverse;
    }
    square / (a.square() + b.square() + c.square() + d.square())
}

// Not inlined: trackers of paths call it in several places, each with its own number of right
// sides.
#[inline(never)]
fn solve_many<const N: usize, const R: usize>(
    matrix: &mut Matrix<N>,
    right: &mut [Vector<N>; R],
) -> f64 {
    eliminate(matrix, right, |square, _| square)
}

/// Solves as [`solve`] does, by elimination alone. Returns the square of the smallest pivot as a
/// part of its row.
#[inline(always)]
pub fn solve_scaled<const N: usize, const R: usize>(
    matrix: &mut Matrix<N>,
    right: &mut [Vector<N>; R],
) -> f64 {
    eliminate(matrix, right, |square, scale| square * scale)
}

/// Eliminates with pivots chosen as if all rows were of one size. `measure` gives the size of a
/// pivot, from its square and the inverse square of its row. Returns the smallest size, or 0 where
/// one is 0 or not finite.
#[inline(always)]
fn eliminate<const N: usize, const R: usize>(
    matrix: &mut Matrix<N>,
    right: &mut [Vector<N>; R],
    measure: impl Fn(f64, f64) -> f64,
) -> f64 {
    let mut scales = matrix.map(|row| 1.0 / size(&row));
    let mut smallest = f64::INFINITY;
    let mut inverses = [ZERO; N];
    for column in 0..N {
        let share = |row: usize| matrix[row][column].square() * scales[row];
        let best = (column + 1..N).fold(
            column,
            |best, row| {
                if share(row) > share(best) { row } else { best }
            },
        );
        matrix.swap(column, best);
        scales.swap(column, best);
        let pivot = measure(matrix[column][column].square(), scales[column]);
        if pivot == 0.0 || !pivot.is_finite() {
            return 0.0;
        }
        smallest = pivot.min(smallest);
        inverses[column] = matrix[column][column].inverse();
        let (upper, lower) = matrix.split_at_mut(column + 1);
        let factors: Vector<N> = core::array::from_fn(|row| match lower.get(row) {
            Some(lower) => lower[column] * inverses[column],
            None => ZERO,
        });
        for (row, factor) in lower.iter_mut().zip(factors) {
            for (element, above) in row.iter_mut().zip(upper[column]).skip(column + 1) {
                *element = *element - factor * above;
            }
        }
        for side in right.iter_mut() {
            side.swap(column, best);
            let (upper, lower) = side.split_at_mut(column + 1);
            for (element, factor) in lower.iter_mut().zip(factors) {
                *element = *element - factor * upper[column];
            }
        }
    }
    for side in right {
        for row in (0..N).rev() {
            let known = (row + 1..N).map(|k| matrix[row][k] * side[k]);
            side[row] = known.fold(side[row], |rest, term| rest - term) * inverses[row];
        }
    }
    smallest
}

/// Returns the inverse, or nothing of a singular matrix.
pub fn inverse<const N: usize>(matrix: &Matrix<N>) -> Option<Matrix<N>> {
    let mut columns = [[ZERO; N]; N];
    for (row, column) in columns.iter_mut().enumerate() {
        column[row] = ONE;
    }
    let pivot = solve_scaled(&mut matrix.clone(), &mut columns);
    // The right sides are columns of the inverse.
    let inverse = core::array::from_fn(|row| core::array::from_fn(|column| columns[column][row]));
    (pivot > 0.0).then_some(inverse)
}
