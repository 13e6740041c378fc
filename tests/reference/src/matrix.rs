//! Dense linear equations in high precision.

use crate::Big;

/// A square matrix, factorised with row exchanges (rows compared relative to their largest entry).
pub(crate) struct Factors {
    rows: Vec<Vec<Big>>,
    inverse_pivots: Vec<Big>,
    order: Vec<usize>,
    even: bool,
}

impl Factors {
    /// Factorises; `None` if a pivot vanishes.
    pub(crate) fn new(mut rows: Vec<Vec<Big>>) -> Option<Self> {
        let n = rows.len();
        let mut order: Vec<usize> = (0..n).collect();
        let mut even = true;
        let mut inverse_pivots = Vec::with_capacity(n);
        let mut size: Vec<Big> = rows.iter().map(|row| largest(row)).collect();
        for k in 0..n {
            let mut best = k;
            for i in k + 1..n {
                if rows[i][k].abs() * &size[best] > rows[best][k].abs() * &size[i] {
                    best = i;
                }
            }
            if rows[best][k].is_zero() || rows[best][k].is_invalid() {
                return None;
            }
            if best != k {
                rows.swap(k, best);
                order.swap(k, best);
                size.swap(k, best);
                even = !even;
            }
            let (above, below) = rows.split_at_mut(k + 1);
            let pivot = &above[k];
            let inverse = Big::one() / &pivot[k];
            for row in below {
                if row[k].is_zero() {
                    continue;
                }
                row[k] = &row[k] * &inverse;
                for j in k + 1..n {
                    row[j] = &row[j] - &row[k] * &pivot[j];
                }
            }
            inverse_pivots.push(inverse);
        }
        Some(Self {
            rows,
            inverse_pivots,
            order,
            even,
        })
    }

    /// Solves for one right-hand side.
    pub(crate) fn solve(&self, right: &[Big]) -> Vec<Big> {
        let n = self.rows.len();
        let mut x: Vec<Big> = self.order.iter().map(|&i| right[i].clone()).collect();
        for i in 0..n {
            for j in 0..i {
                x[i] = &x[i] - &self.rows[i][j] * &x[j];
            }
        }
        for i in (0..n).rev() {
            for j in i + 1..n {
                x[i] = &x[i] - &self.rows[i][j] * &x[j];
            }
            x[i] = &x[i] * &self.inverse_pivots[i];
        }
        x
    }

    /// The determinant.
    pub(crate) fn determinant(&self) -> Big {
        let product = self
            .rows
            .iter()
            .enumerate()
            .fold(Big::one(), |p, (i, row)| p * &row[i]);
        if self.even { product } else { -product }
    }
}

/// The largest magnitude among the numbers.
pub(crate) fn largest(numbers: &[Big]) -> Big {
    numbers.iter().fold(Big::zero(), |m, x| m.max(&x.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_with_exchanges_and_bad_row_scales() {
        let huge = 2f64.powi(500);
        let row = |r: [f64; 3]| r.into_iter().map(Big::from).collect::<Vec<_>>();
        let rows = vec![
            row([0.0, 2.0, 1.0]),
            row([huge, huge, 0.0]),
            row([1.0, 0.0, 3.0]),
        ];
        let factors = Factors::new(rows).expect("regular");
        let x = factors.solve(&[Big::from(7.0), Big::from(3.0 * huge), Big::from(10.0)]);
        let x: Vec<f64> = x.iter().map(Big::to_f64).collect();
        assert_eq!(x, [1.0, 2.0, 3.0]);
        assert!((factors.determinant().to_f64() / (-7.0 * huge) - 1.0).abs() < 1e-15);
    }
}
