//! Linear equations of any rank.

/// Pivots below this part of the largest one count as zero.
const RELATIVE_ZERO: f64 = 1e-9;

/// The result of an elimination.
pub(crate) struct Solution {
    /// A step that solves the independent equations; free unknowns stay.
    pub(crate) step: Vec<f64>,
    pub(crate) rank: usize,
    /// The smallest pivot as a part of the largest one.
    pub(crate) smallest_pivot: f64,
    /// True if the determinant is negative: it changes where assemblies meet.
    pub(crate) is_negative: bool,
}

/// Solves rows of coefficients, each with its right side at the end.
pub(crate) fn solve(mut rows: Vec<Vec<f64>>, unknowns: usize) -> Solution {
    let mut columns: Vec<usize> = (0..unknowns).collect();
    let mut rank = 0;
    let mut largest = 0.0f64;
    let mut smallest_pivot = 1.0f64;
    let mut is_negative = false;
    while rank < rows.len().min(unknowns) {
        // The largest element that is left, so that the rank is seen in the pivots.
        let mut pivot = (rank, rank, 0.0f64);
        for (row, values) in rows.iter().enumerate().skip(rank) {
            for (position, column) in columns.iter().enumerate().skip(rank) {
                let size = values[*column].abs();
                if size > pivot.2 {
                    pivot = (row, position, size);
                }
            }
        }
        largest = largest.max(pivot.2);
        if pivot.2 <= RELATIVE_ZERO * largest {
            break;
        }
        smallest_pivot = smallest_pivot.min(pivot.2 / largest);
        is_negative ^= (pivot.0 != rank) ^ (pivot.1 != rank);
        is_negative ^= rows[pivot.0][columns[pivot.1]] < 0.0;
        rows.swap(rank, pivot.0);
        columns.swap(rank, pivot.1);
        let column = columns[rank];
        let (top, below) = rows.split_at_mut(rank + 1);
        let top = &top[rank];
        for row in below.iter_mut().filter(|row| row[column] != 0.0) {
            let factor = row[column] / top[column];
            for (value, above) in row.iter_mut().zip(top) {
                *value -= factor * above;
            }
            row[column] = 0.0;
        }
        rank += 1;
    }
    let mut step = vec![0.0; unknowns];
    for index in (0..rank).rev() {
        let row = &rows[index];
        let known: f64 = columns[index + 1..rank]
            .iter()
            .map(|column| row[*column] * step[*column])
            .sum();
        step[columns[index]] = (row[unknowns] - known) / row[columns[index]];
    }
    Solution {
        step,
        rank,
        smallest_pivot,
        is_negative,
    }
}
