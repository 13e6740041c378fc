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

/// Sums that are computed at once.
const LANES: usize = 4;

/// Residuals with their derivatives by the first variables, row after row.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Block {
    /// The number of variables.
    width: usize,
    residuals: Vec<f64>,
    /// Rows of as many numbers as lanes can take, zeros behind the variables.
    slopes: Vec<f64>,
}

impl Block {
    /// A block without a row, of so many variables.
    pub(crate) fn clear(&mut self, width: usize) {
        self.width = width;
        self.residuals.clear();
        self.slopes.clear();
    }

    fn stride(&self) -> usize {
        self.width.next_multiple_of(LANES)
    }

    /// Adds a row.
    pub(crate) fn push(&mut self, residual: f64, slopes: impl Iterator<Item = f64>) {
        self.residuals.push(residual);
        self.slopes.extend(slopes);
        let filled = self.residuals.len() * self.stride();
        self.slopes.resize(filled, 0.0);
    }

    /// The residual of the last row, and its derivatives.
    fn last(&self) -> (f64, &[f64]) {
        let row = self.residuals.len() - 1;
        let slopes = &self.slopes[row * self.stride()..][..self.width];
        (self.residuals[row], slopes)
    }

    /// Adds the products of a factor of each row and of its slopes from the variable `first` on.
    #[inline(always)]
    fn add_products(&self, first: usize, sums: &mut [f64], factor: impl Fn(usize, &[f64]) -> f64) {
        let mut lanes = [0.0; LANES];
        lanes[..sums.len()].copy_from_slice(sums);
        for (row, slopes) in self.slopes.chunks_exact(self.stride()).enumerate() {
            let factor = factor(row, slopes);
            let others = &slopes[first..first + LANES];
            for (lane, other) in lanes.iter_mut().zip(others) {
                *lane += factor * other;
            }
        }
        sums.copy_from_slice(&lanes[..sums.len()]);
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

    /// Adds the rows of a block: in each sum one row after the other, and several sums at once.
    pub(crate) fn add_block(&mut self, block: &Block) {
        let n = self.gradient.len();
        for residual in &block.residuals {
            self.sum += residual * residual;
        }
        for first in (0..block.width).step_by(LANES) {
            let last = block.width.min(first + LANES);
            let sums = &mut self.gradient[first..last];
            block.add_products(first, sums, |row, _| block.residuals[row]);
        }
        for variable in 0..block.width {
            let line = &mut self.gram[variable * n..][..=variable];
            for first in (0..=variable).step_by(LANES) {
                let last = (variable + 1).min(first + LANES);
                block.add_products(first, &mut line[first..last], |_, slopes| slopes[variable]);
            }
        }
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
            block.clear(width);
            for row in 0..7 {
                let residual = number(100 + row);
                let slopes: Vec<f64> = (0..width).map(|k| number(11 * row + k)).collect();
                let free = inputs.map(|variable| (variable, number(200 + row * variable)));
                block.push(residual, slopes.iter().copied());
                all.add_inputs(&block, &free);
                let places: Vec<usize> = (0..width).chain(inputs).collect();
                let slopes = [slopes, free.map(|(_, slope)| slope).to_vec()].concat();
                one_by_one.add(residual, &places, &slopes);
            }
            all.add_block(&block);
            assert_eq!(all, one_by_one, "{width} variables");
        }
    }
}
