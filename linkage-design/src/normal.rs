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
