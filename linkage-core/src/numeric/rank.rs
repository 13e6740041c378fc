//! Ranks of matrices of plain numbers by elimination: independence of rows and columns,
//! combinations, null vectors.

use super::vector::dot;
use crate::math::double::sqrt;
use alloc::vec::Vec;

/// Rows of equal length that are being eliminated.
struct Rows(Vec<Vec<f64>>);

impl Rows {
    /// Brings columns, then rows, to size 1. A column of zeros becomes NaN.
    fn balance(&mut self) {
        let Self(rows) = self;
        for k in 0..rows.len() {
            let column = rows.iter().map(|row| row[k].abs()).fold(0.0, f64::max);
            rows.iter_mut().for_each(|row| row[k] /= column);
        }
        for row in rows {
            let size = row.iter().map(|x| x.abs()).fold(0.0, f64::max);
            row.iter_mut().for_each(|x| *x /= size);
        }
    }

    /// Moves the row with the largest number in column `k` to row `k`. Returns that number, or
    /// `None` if no row is left.
    fn pivot_in_column(&mut self, k: usize) -> Option<f64> {
        let Self(rows) = self;
        let largest =
            (k..rows.len()).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()))?;
        rows.swap(k, largest);
        Some(rows[k][k])
    }

    /// Moves the largest number among the rows and columns from `k` on to the diagonal. Returns
    /// that number.
    fn pivot_anywhere(&mut self, k: usize) -> f64 {
        let Self(rows) = self;
        let count = rows.len();
        let places = (k..count).flat_map(|i| (k..count).map(move |j| (i, j)));
        let largest = places.fold((k, k), |(a, b), (i, j)| {
            match rows[i][j].abs() > rows[a][b].abs() {
                true => (i, j),
                false => (a, b),
            }
        });
        rows.swap(k, largest.0);
        rows.iter_mut().for_each(|row| row.swap(k, largest.1));
        rows[k][k]
    }

    /// Subtracts row `k` from rows from `first` on, so that their column `k` is zero.
    fn clear_column(&mut self, k: usize, first: usize) {
        let Self(rows) = self;
        let pivot = rows[k].clone();
        let others = rows.iter_mut().enumerate().skip(first);
        for (_, row) in others.filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot[k];
            let pairs = row.iter_mut().zip(&pivot);
            pairs.for_each(|(x, p)| *x -= factor * p);
        }
    }
}

/// Returns the factors that make a list of numbers from others; `None` if there are none. Numbers
/// below `least` are zero: factors, errors of the combination, and pivots of lists that are
/// combinations of those before them.
pub fn combination(basis: &[&[f64]], numbers: &[f64], least: f64) -> Option<Vec<f64>> {
    let count = basis.len();
    // [basis | numbers], one row for each number.
    let row = |k: usize| {
        let numbers_of_basis = basis.iter().map(|list| list[k]);
        numbers_of_basis.chain([numbers[k]]).collect()
    };
    let mut rows = Rows((0..numbers.len()).map(row).collect());
    for k in 0..count {
        if rows.pivot_in_column(k)?.abs() < least {
            return None;
        }
        rows.clear_column(k, 0);
    }
    let Rows(rows) = rows;
    if rows[count..].iter().any(|row| row[count].abs() > least) {
        return None;
    }
    let shares = (0..count).map(|k| rows[k][count] / rows[k][k]);
    let shares = shares.map(|x| if x.abs() < least { 0.0 } else { x });
    Some(shares.collect())
}

/// Returns whether the rows of a square matrix repeat each other: they do if they are independent
/// by less than `least` of their size.
pub fn is_singular(rows: Vec<Vec<f64>>, least: f64) -> bool {
    let mut rows = Rows(rows);
    rows.balance();
    for k in 0..rows.0.len() {
        let pivot = rows.pivot_anywhere(k);
        if pivot.is_nan() || pivot.abs() < least {
            return true;
        }
        rows.clear_column(k, k + 1);
    }
    false
}

/// Returns the null vectors of a matrix with `width` columns, one for each free column; none of a
/// regular matrix. A pivot is zero below `least`, the last one below `last`, both as parts of the
/// largest entry.
pub fn null_vectors(matrix: &[Vec<f64>], width: usize, [least, last]: [f64; 2]) -> Vec<Vec<f64>> {
    let mut rows = matrix.to_vec();
    for row in &mut rows {
        let most = row.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        if most > 0.0 {
            row.iter_mut().for_each(|x| *x /= most);
        }
    }
    let mut free: Vec<usize> = (0..width).collect();
    let mut pivots: Vec<usize> = Vec::new();
    while pivots.len() < rows.len() && !free.is_empty() {
        let done = pivots.len();
        let entries =
            (done..rows.len()).flat_map(|row| free.iter().map(move |&column| (row, column)));
        let size = |&(row, column): &(usize, usize)| rows[row][column].abs();
        let Some((row, column)) = entries.max_by(|a, b| size(a).total_cmp(&size(b))) else {
            break;
        };
        let pivot = rows[row][column];
        let is_last = free.len() == 1 && done + 1 == width;
        let least = if is_last { last } else { least };
        if pivot.abs() <= least {
            break;
        }
        rows.swap(done, row);
        rows[done].iter_mut().for_each(|x| *x /= pivot);
        let pivot_row = rows[done].clone();
        for (index, other) in rows.iter_mut().enumerate() {
            let factor = other[column];
            if index != done {
                other
                    .iter_mut()
                    .zip(&pivot_row)
                    .for_each(|(x, y)| *x -= factor * y);
            }
        }
        free.retain(|&other| other != column);
        pivots.push(column);
    }
    let vectors = free.iter().map(|&column| {
        let mut vector = alloc::vec![0.0; width];
        vector[column] = 1.0;
        for (row, &pivot) in rows.iter().zip(&pivots) {
            vector[pivot] = -row[column];
        }
        vector
    });
    vectors.collect()
}

/// Returns whether no column is a combination of those before it. A column is one if less than
/// `least` of its length is across them.
pub fn are_independent(columns: &[Vec<f64>], least: f64) -> bool {
    let mut units: Vec<Vec<f64>> = Vec::new();
    for column in columns {
        let mut across = column.clone();
        for unit in &units {
            let along = dot(&across, unit);
            across
                .iter_mut()
                .zip(unit)
                .for_each(|(x, u)| *x -= along * u);
        }
        let length = sqrt(dot(&across, &across));
        // A column of zeros, or one that is no number, is none either.
        let across_enough = length > least * sqrt(dot(column, column));
        if !across_enough {
            return false;
        }
        units.push(across.into_iter().map(|x| x / length).collect());
    }
    true
}

#[cfg(test)]
mod tests {
    use super::{combination, is_singular, null_vectors};
    use alloc::vec;
    use alloc::vec::Vec;

    const LEAST: f64 = 1e-9;

    #[test]
    fn a_list_is_made_of_others() {
        let basis: [&[f64]; 2] = [&[1.0, 0.0, 2.0], &[0.0, 4.0, -1.0]];
        let found = combination(&basis, &[3.0, -8.0, 8.0], LEAST);
        assert_eq!(found, Some(vec![3.0, -2.0]));
        assert_eq!(
            combination(&basis, &[0.0, 4.0, -1.0], LEAST),
            Some(vec![0.0, 1.0])
        );
        assert_eq!(combination(&basis, &[3.0, -8.0, 8.1], LEAST), None);
    }

    #[test]
    fn nothing_is_made_of_nothing() {
        assert_eq!(combination(&[], &[0.0, 1e-12], LEAST), Some(vec![]));
        assert_eq!(combination(&[], &[0.0, 1.0], LEAST), None);
        assert_eq!(combination(&[], &[], LEAST), Some(vec![]));
    }

    #[test]
    fn others_that_repeat_each_other_make_nothing() {
        let basis: [&[f64]; 2] = [&[1.0, 2.0], &[2.0, 4.0]];
        assert_eq!(combination(&basis, &[1.0, 2.0], LEAST), None);
        // More lists than numbers.
        let basis: [&[f64]; 2] = [&[1.0], &[2.0]];
        assert_eq!(combination(&basis, &[1.0], LEAST), None);
    }

    #[test]
    fn rows_repeat_each_other_or_do_not() {
        let singular =
            |rows: &[[f64; 3]]| is_singular(rows.iter().map(|row| row.to_vec()).collect(), LEAST);
        assert!(!singular(&[
            [0.0, 0.0, 3.0],
            [0.0, -2.0, 1.0],
            [5.0, 1.0, 1.0]
        ]));
        assert!(singular(&[
            [1.0, 2.0, 3.0],
            [4.0, 5.0, 6.0],
            [7.0, 8.0, 9.0]
        ]));
        // A column of zeros, a row of zeros, a number that is none.
        assert!(singular(&[
            [1.0, 0.0, 3.0],
            [4.0, 0.0, 6.0],
            [7.0, 0.0, 9.5]
        ]));
        assert!(singular(&[[1.0, 2.0, 3.0], [0.0; 3], [7.0, 8.0, 1.0]]));
        assert!(singular(&[
            [f64::NAN, 2.0, 3.0],
            [4.0, 5.0, 6.0],
            [7.0, 8.0, 1.0]
        ]));
        assert!(!is_singular(Vec::new(), LEAST));
    }

    #[test]
    fn units_do_not_matter() {
        let rows = |a: f64, b: f64| vec![vec![a, 2.0 * b], vec![3e7 * a, 5e7 * b]];
        for (a, b) in [(1.0, 1.0), (1e-12, 1e9), (1e20, 1e-15)] {
            assert!(!is_singular(rows(a, b), LEAST));
        }
        assert!(is_singular(vec![vec![1.0, 2.0], vec![3e7, 6e7]], LEAST));
    }

    #[test]
    fn null_vectors_are_those_of_the_rows() {
        let matrix = [
            vec![1.0, 2.0, 3.0, 4.0],
            vec![2.0, -1.0, 0.5, 1.0],
            vec![3.0, 1.0, 3.5, 5.0],
        ];
        let found = null_vectors(&matrix, 4, [LEAST; 2]);
        assert_eq!(found.len(), 2);
        for vector in &found {
            for row in &matrix {
                let product: f64 = row.iter().zip(vector).map(|(a, b)| a * b).sum();
                assert!(product.abs() < 1e-14, "{product}");
            }
        }
        let column = |k: usize| matrix.iter().map(|row| row[k]).collect();
        let columns: Vec<Vec<f64>> = (0..4).map(column).collect();
        let [weights] = &null_vectors(&columns, 3, [LEAST; 2])[..] else {
            panic!("the third row is the sum of the others")
        };
        assert!((weights[0] / weights[2] + 1.0).abs() < 1e-14);
        assert!((weights[1] / weights[2] + 1.0).abs() < 1e-14);
        assert!(null_vectors(&[vec![1.0, 2.0], vec![2.0, 1.0]], 2, [LEAST; 2]).is_empty());
    }
}
