//! A sum of squares near a point: its value, gradient and normal matrix, gathered row by row.

use std::vec;
use std::vec::Vec;

/// The sum of squares of residuals at a point, with `J'r` and the lower triangle of `J'J`;
/// conditions with their gradients.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Normal {
    /// The sum of squares; NaN where a residual has no value.
    pub(crate) sum: f64,
    /// `J'r`.
    pub(crate) gradient: Vec<f64>,
    /// `J'J`, the lower triangle of `n` rows of length `n`.
    pub(crate) gram: Vec<f64>,
    /// Nonlinear conditions, each a number that must not be negative, with its derivatives.
    pub(crate) conditions: Vec<(f64, Vec<f64>)>,
}

/// Rows and columns of sums that are computed at once.
const LANES: usize = 4;

/// Residuals with their derivatives by the first variables, row after row, and the sums of their
/// products.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Block {
    /// The number of variables.
    width: usize,
    /// Rows of the derivatives, then the residual, then zeros up to whole lanes.
    rows: Vec<f64>,
    /// The products of two numbers of a row, summed over all rows: those with the first number in
    /// one row, as long as those of derivatives.
    sums: Vec<f64>,
}

impl Block {
    /// A block without a row, of so many variables, all sums zero.
    pub(crate) fn begin(&mut self, width: usize) {
        self.width = width;
        self.rows.clear();
        self.sums.clear();
        self.sums.resize(self.stride() * self.stride(), 0.0);
    }

    fn stride(&self) -> usize {
        (self.width + 1).next_multiple_of(LANES)
    }

    /// Adds a row; returns its derivatives, which are zero.
    pub(crate) fn push(&mut self, residual: f64) -> &mut [f64] {
        let (first, stride) = (self.rows.len(), self.stride());
        self.rows.resize(first + stride, 0.0);
        let (slopes, rest) = self.rows[first..].split_at_mut(self.width);
        rest[0] = residual;
        slopes
    }

    /// The residual of the last row, and its derivatives.
    fn last(&self) -> (f64, &[f64]) {
        let row = &self.rows[self.rows.len() - self.stride()..];
        (row[self.width], &row[..self.width])
    }

    /// Adds the products of all rows to the sums and removes the rows: in each sum one row after
    /// the other, and several sums at once.
    pub(crate) fn add_products(&mut self) {
        let stride = self.stride();
        for line in (0..stride).step_by(LANES) {
            for first in (0..=line).step_by(LANES) {
                let mut lanes = [[0.0; LANES]; LANES];
                for (k, lanes) in lanes.iter_mut().enumerate() {
                    lanes.copy_from_slice(&self.sums[(line + k) * stride + first..][..LANES]);
                }
                for row in self.rows.chunks_exact(stride) {
                    let (factors, others) = (&row[line..][..LANES], &row[first..][..LANES]);
                    for (lanes, factor) in lanes.iter_mut().zip(factors) {
                        for (lane, other) in lanes.iter_mut().zip(others) {
                            *lane += factor * other;
                        }
                    }
                }
                for (k, lanes) in lanes.iter().enumerate() {
                    self.sums[(line + k) * stride + first..][..LANES].copy_from_slice(lanes);
                }
            }
        }
        self.rows.clear();
    }
}

impl Normal {
    pub(crate) fn new(n: usize) -> Self {
        Self {
            sum: 0.0,
            gradient: vec![0.0; n],
            gram: vec![0.0; n * n],
            conditions: Vec::new(),
        }
    }

    pub(crate) fn clear(&mut self) {
        self.sum = 0.0;
        self.gradient.fill(0.0);
        self.gram.fill(0.0);
        self.conditions.clear();
    }

    /// Adds a residual whose derivatives by the variables `places`, which ascend, are `slopes`.
    #[inline]
    pub(crate) fn add(&mut self, residual: f64, places: &[usize], slopes: &[f64]) {
        let n = self.gradient.len();
        self.sum += residual * residual;
        // The first variables one after the other, as most residuals have them, are added in lanes.
        let pairs = places.iter().enumerate();
        let first = pairs.take_while(|(i, variable)| i == *variable).count();
        for (i, (&row, &slope)) in places.iter().zip(slopes).enumerate() {
            self.gradient[row] += slope * residual;
            let line = &mut self.gram[row * n..row * n + n];
            let before = first.min(i + 1);
            for (sum, other) in line.iter_mut().zip(&slopes[..before]) {
                *sum += slope * other;
            }
            for (&column, &other) in places[before..=i].iter().zip(&slopes[before..]) {
                line[column] += slope * other;
            }
        }
    }

    /// Takes the sums of a block as those of the first variables. The sum of squares stays.
    pub(crate) fn take_block(&mut self, block: &Block) {
        let (n, stride, width) = (self.gradient.len(), block.stride(), block.width);
        for (variable, sums) in block.sums.chunks_exact(stride).take(width).enumerate() {
            let line = self.gram[variable * n..].iter_mut().zip(&sums[..=variable]);
            line.for_each(|(to, sum)| *to = *sum);
        }
        let sums = &block.sums[width * stride..][..width];
        self.gradient[..width].copy_from_slice(sums);
    }

    /// Adds what inputs of its own, each a variable behind those of the block with its slope, make of
    /// the last row of a block. They ascend.
    pub(crate) fn add_inputs(&mut self, block: &Block, inputs: &[(usize, f64)]) {
        let n = self.gradient.len();
        let (residual, slopes) = block.last();
        for (number, &(variable, slope)) in inputs.iter().enumerate() {
            self.gradient[variable] += slope * residual;
            let line = &mut self.gram[variable * n..][..n];
            for (sum, other) in line.iter_mut().zip(slopes) {
                *sum += slope * other;
            }
            for &(column, other) in &inputs[..=number] {
                line[column] += slope * other;
            }
        }
    }

    /// Returns the sum of all violations of conditions.
    pub(crate) fn violation(&self) -> f64 {
        self.conditions
            .iter()
            .map(|(value, _)| (-value).max(0.0))
            .sum()
    }

    /// Returns true if all numbers are finite: the mechanism assembles at all positions.
    pub(crate) fn is_finite(&self) -> bool {
        self.sum.is_finite()
            && self.gradient.iter().all(|x| x.is_finite())
            && self
                .conditions
                .iter()
                .all(|(value, slopes)| value.is_finite() && slopes.iter().all(|x| x.is_finite()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of a block and inputs of their own, and the same rows one by one: equal to the last bit.
    #[test]
    fn blocks_are_their_rows() {
        let number = |k: usize| (1.0 + k as f64).sin() / 3.0;
        for width in 0..11 {
            let (n, inputs) = (width + 3, [width, width + 2]);
            let (mut block, mut all, mut one_by_one) =
                (Block::default(), Normal::new(n), Normal::new(n));
            block.begin(width);
            for row in 0..7 {
                let residual = number(100 + row);
                let slopes: Vec<f64> = (0..width).map(|k| number(11 * row + k)).collect();
                let free = inputs.map(|variable| (variable, number(200 + row * variable)));
                block.push(residual).copy_from_slice(&slopes);
                all.sum += residual * residual;
                all.add_inputs(&block, &free);
                let places: Vec<usize> = (0..width).chain(inputs).collect();
                let slopes = [slopes, free.map(|(_, slope)| slope).to_vec()].concat();
                one_by_one.add(residual, &places, &slopes);
                if row == 2 {
                    // The rows of another objective follow.
                    block.add_products();
                }
            }
            block.add_products();
            all.take_block(&block);
            assert_eq!(all, one_by_one, "{width} variables");
        }
    }
}
