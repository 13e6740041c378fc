//! Gauss elimination on plain numbers: independence of rows, and lists of numbers as combinations
//! of others.

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

    /// Moves the row with the largest number in column `k` to place `k`; the result is that number,
    /// `None` if no row is left.
    fn pivot_in_column(&mut self, k: usize) -> Option<f64> {
        let Self(rows) = self;
        let largest =
            (k..rows.len()).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()))?;
        rows.swap(k, largest);
        Some(rows[k][k])
    }

    /// Moves the largest number of those rows and columns that are left to place `k`; the result is
    /// that number.
    fn pivot_anywhere(&mut self, k: usize) -> f64 {
        let Self(rows) = self;
        let count = rows.len();
        let places = (k..count).flat_map(|i| (k..count).map(move |j| (i, j)));
        let largest = places.fold((k, k), |(a, b), (i, j)| {
            if rows[i][j].abs() > rows[a][b].abs() {
                (i, j)
            } else {
                (a, b)
            }
        });
        rows.swap(k, largest.0);
        rows.iter_mut().for_each(|row| row.swap(k, largest.1));
        rows[k][k]
    }

    /// Subtracts row `k` from rows from `first` on, so that nothing is left there of column `k`.
    fn clear_column(&mut self, k: usize, first: usize) {
        let Self(rows) = self;
        let pivot = rows[k].clone();
        let others = rows.iter_mut().enumerate().skip(first);
        for (_, row) in others.filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot[k];
            let entries = row.iter_mut().zip(&pivot);
            entries.for_each(|(x, p)| *x -= factor * p);
        }
    }
}

/// Returns the factors that make a list of numbers from others; `None` if there are none. Numbers
/// below `least` count as 0: the rest of a list after those before it, the error of a combination,
/// and factors.
pub(super) fn combination(basis: &[&[f64]], numbers: &[f64], least: f64) -> Option<Vec<f64>> {
    let count = basis.len();
    // [basis | numbers], one row for each number.
    let row = |k: usize| {
        let entries = basis.iter().map(|list| list[k]);
        entries.chain([numbers[k]]).collect()
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

/// True if the rows of a square matrix repeat each other. Rows that are independent by less than
/// `least` of their size are not.
pub(super) fn is_singular(rows: Vec<Vec<f64>>, least: f64) -> bool {
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

#[cfg(test)]
mod tests {
    use super::{combination, is_singular};

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
}
