//! Dense systems of linear equations in complex numbers of 77 digits.

use super::long::{self, Long};
use linkage_core::numeric::complex::Complex;
use std::vec::Vec;

/// Solves `matrix * x = right` in place, in numbers of 77 digits; a row has the elements of all
/// right sides. `None` for a singular matrix. Long numbers take much room, so they are on the heap.
pub(super) fn solve_long<const N: usize, const R: usize>(
    mut matrix: Vec<[Complex<Long>; N]>,
    mut right: Vec<[Complex<Long>; R]>,
) -> Option<Vec<[Complex<Long>; R]>> {
    let measure = |element: &Complex<Long>| element.map(Long::narrow).size();
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
        let inverse = long::inverse(matrix[column][column]);
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
