//! Small dense systems of linear equations in complex numbers.

use super::complex::{Complex, ONE, ZERO};
use super::long::Long;
use alloc::vec::Vec;

pub(super) type Matrix<const N: usize> = [[Complex; N]; N];

/// Solves `matrix * x = right` for several right sides in place. The result is the smallest pivot as a part of its row,
/// squared; 0 for a singular matrix (the right sides are spoilt then).
#[inline(always)]
pub(super) fn solve<const N: usize, const R: usize>(
    matrix: &mut Matrix<N>,
    right: &mut [[Complex; N]; R],
) -> f64 {
    let mut scales =
        matrix.map(|row| 1.0 / row.iter().map(|element| element.square()).sum::<f64>());
    let mut smallest = f64::INFINITY;
    let mut inverses = [ZERO; N];
    for column in 0..N {
        let measure = |row: usize| matrix[row][column].square() * scales[row];
        let best = (column + 1..N).fold(column, |best, row| {
            if measure(row) > measure(best) {
                row
            } else {
                best
            }
        });
        let pivot = measure(best);
        if pivot.is_nan() || pivot <= 0.0 || pivot.is_infinite() {
            return 0.0;
        }
        smallest = pivot.min(smallest);
        matrix.swap(column, best);
        scales.swap(column, best);
        for side in right.iter_mut() {
            side.swap(column, best);
        }
        inverses[column] = matrix[column][column].inverse();
        let above = matrix[column];
        for row in column + 1..N {
            let factor = matrix[row][column] * inverses[column];
            for (element, above) in matrix[row].iter_mut().zip(above).skip(column + 1) {
                *element = *element - factor * above;
            }
            for side in right.iter_mut() {
                side[row] = side[row] - factor * side[column];
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

/// `None` for a singular matrix.
pub(super) fn inverse<const N: usize>(matrix: &Matrix<N>) -> Option<Matrix<N>> {
    let mut unit = [[ZERO; N]; N];
    for (row, unit) in unit.iter_mut().enumerate() {
        unit[row] = ONE;
    }
    let columns = &mut unit;
    let pivot = solve(&mut matrix.clone(), columns);
    // The right sides are columns of the inverse.
    let inverse = core::array::from_fn(|row| core::array::from_fn(|column| columns[column][row]));
    (pivot > 0.0).then_some(inverse)
}

/// Solves `matrix * x = right` in place, in numbers of 77 digits; a row has what belongs to it of all right sides. `None` for
/// a singular matrix. Long numbers take much room: they stand on the heap.
pub(super) fn solve_long<const N: usize, const R: usize>(
    mut matrix: Vec<[Complex<Long>; N]>,
    mut right: Vec<[Complex<Long>; R]>,
) -> Option<Vec<[Complex<Long>; R]>> {
    let measure = |element: &Complex<Long>| element.rounded().size();
    let mut scales: Vec<f64> = matrix
        .iter()
        .map(|row| row.iter().map(measure).fold(0.0, f64::max))
        .collect();
    let mut inverses = Vec::with_capacity(N);
    for column in 0..N {
        let part = |row: usize| measure(&matrix[row][column]) / scales[row];
        let best = (column + 1..N).fold(
            column,
            |best, row| {
                if part(row) > part(best) { row } else { best }
            },
        );
        let pivot = part(best);
        if pivot.is_nan() || pivot <= 0.0 || pivot.is_infinite() {
            return None;
        }
        matrix.swap(column, best);
        right.swap(column, best);
        scales.swap(column, best);
        let inverse = matrix[column][column].reciprocal();
        inverses.push(inverse);
        let (above, side) = (matrix[column], right[column]);
        for row in column + 1..N {
            let factor = matrix[row][column] * inverse;
            if measure(&factor) == 0.0 {
                continue;
            }
            for (element, above) in matrix[row].iter_mut().zip(above).skip(column + 1) {
                *element = *element - factor * above;
            }
            for (element, side) in right[row].iter_mut().zip(side) {
                *element = *element - factor * side;
            }
        }
    }
    for row in (0..N).rev() {
        let (left, known) = right.split_at_mut(row + 1);
        for (side, rest) in left[row].iter_mut().enumerate() {
            let terms = matrix[row][row + 1..].iter().zip(&*known);
            let sum = terms.fold(*rest, |rest, (&by, known)| rest - by * known[side]);
            *rest = sum * inverses[row];
        }
    }
    Some(right)
}
