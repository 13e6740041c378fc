//! Cholesky's factor of a matrix, with several elements computed at once.
//!
//! Each sum adds its products in the order of a loop over one element, so that the result is the
//! same to the last bit. Several sums side by side do not wait for each other.

use std::vec::Vec;

/// Elements of a column that are computed at once.
const LANES: usize = 8;

/// A lower triangle, by columns and by rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Factor {
    n: usize,
    /// Column by column, `n` numbers of each and as many zeros as lanes may reach beyond.
    columns: Vec<f64>,
    /// Row by row, in the same way.
    rows: Vec<f64>,
}

impl Factor {
    /// Factors a matrix of `n` rows, of which the lower triangle is given row by row. Returns false
    /// if it is not positive definite.
    pub(super) fn compute(&mut self, gram: &[f64], n: usize) -> bool {
        let stride = n + LANES;
        if self.n != n {
            self.n = n;
            self.columns.clear();
            self.columns.resize(n * stride, 0.0);
            self.rows.clear();
            self.rows.resize(n * stride, 0.0);
        }
        for j in 0..n {
            let (known, column) = self.columns.split_at_mut(j * stride);
            let mut pivot = f64::NAN;
            for first in (j..n).step_by(LANES) {
                let mut sums = [-0.0; LANES];
                for other in known.chunks_exact(stride) {
                    add(&mut sums, &other[first..], other[j]);
                }
                let last = n.min(first + LANES);
                let mut rests = [0.0; LANES];
                for ((rest, sum), i) in rests.iter_mut().zip(sums).zip(first..last) {
                    *rest = gram[i * n + j] - sum;
                }
                if first == j {
                    if !(rests[0] > 0.0 && rests[0].is_finite()) {
                        return false;
                    }
                    pivot = rests[0].sqrt();
                }
                let mut elements = rests.map(|rest| rest / pivot);
                if first == j {
                    elements[0] = pivot;
                }
                // Zeros after the last row, so that the length is a constant.
                column[first..first + LANES].copy_from_slice(&elements);
                for (i, element) in (first..last).zip(elements) {
                    self.rows[i * stride + j] = element;
                }
            }
        }
        true
    }

    /// Solves `L x = right` in place, for a right side that is zero before the element `from`.
    pub(super) fn forward(&self, x: &mut [f64], from: usize) {
        let n = self.n;
        let stride = n + LANES;
        for first in (from..n).step_by(LANES) {
            let mut sums = [-0.0; LANES];
            let columns = self.columns.chunks_exact(stride).zip(x.iter());
            for (column, x) in columns.take(first).skip(from) {
                add(&mut sums, &column[first..], *x);
            }
            for (lane, i) in (first..n.min(first + LANES)).enumerate() {
                let column = &self.columns[i * stride..][..stride];
                x[i] = (x[i] - sums[lane]) / column[i];
                add(&mut sums, &column[first..], x[i]);
            }
        }
    }

    /// Solves `L' x = right` in place.
    pub(super) fn backward(&self, x: &mut [f64]) {
        let n = self.n;
        let stride = n + LANES;
        for first in (0..n).step_by(LANES).rev() {
            let last = n.min(first + LANES);
            let mut rests = [0.0; LANES];
            for (rest, x) in rests.iter_mut().zip(&x[first..last]) {
                *rest = *x;
            }
            for i in (last..n).rev() {
                add(&mut rests, &self.rows[i * stride + first..], -x[i]);
            }
            for i in (first..last).rev() {
                let row = &self.rows[i * stride..][..stride];
                x[i] = rests[i - first] / row[i];
                add(&mut rests, &row[first..], -x[i]);
            }
        }
    }
}

/// Adds the products of a factor and of the first numbers of a list.
#[inline(always)]
fn add(sums: &mut [f64; LANES], numbers: &[f64], factor: f64) {
    for (sum, number) in sums.iter_mut().zip(&numbers[..LANES]) {
        *sum += number * factor;
    }
}

#[cfg(test)]
mod tests {
    use super::Factor;
    use linkage_core::numeric::cholesky;
    use linkage_random::Random;
    use std::vec;
    use std::vec::Vec;

    /// The factor, and solutions with it, are those of loops over one element: to the last bit.
    #[test]
    fn lanes_change_no_bit() {
        let mut random = Random::new(3);
        let mut factor = Factor::default();
        for n in (1..20).chain([9, 3]) {
            let root: Vec<f64> = (0..n * n).map(|_| random.between(-1.0, 1.0)).collect();
            let entry = |at: usize| {
                let [i, j] = [at / n, at % n];
                let products = (0..n).map(|k| root[i * n + k] * root[j * n + k]);
                products.sum::<f64>() + f64::from(i == j)
            };
            let gram: Vec<f64> = (0..n * n).map(entry).collect();
            let mut lower = gram.clone();
            cholesky::factor(&mut lower, n, |_, rest| Some(rest)).expect("a pivot");
            assert!(factor.compute(&gram, n));
            for from in 0..n {
                let mut x = vec![0.0; n];
                x[from..].fill_with(|| random.between(-1.0, 1.0));
                let (mut known, mut right) = (x.clone(), x.clone());
                cholesky::forward(&lower, &mut known);
                factor.forward(&mut x, from);
                assert_eq!(x, known, "{n} rows, from {from}");
                factor.backward(&mut x);
                for i in (0..n).rev() {
                    known[i] /= lower[i * n + i];
                    for j in 0..i {
                        known[j] -= lower[i * n + j] * known[i];
                    }
                }
                assert_eq!(x, known, "{n} rows, from {from}");
                // The matrix times the solution is the right side.
                for (i, right) in right.iter_mut().enumerate() {
                    let at = |j: usize| i.max(j) * n + i.min(j);
                    *right -= (0..n).map(|j| gram[at(j)] * x[j]).sum::<f64>();
                }
                assert!(right.iter().all(|rest| rest.abs() < 1e-12), "{right:?}");
            }
            let mut bent = gram;
            bent[n * n - 1] = -1.0;
            assert!(!factor.compute(&bent, n), "{n} rows");
        }
    }
}
