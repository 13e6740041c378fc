//! Steps of the interior point method: a predictor, and a corrector for the error of the predictor.

use alloc::vec;
use alloc::vec::Vec;

use crate::balancing::rows::{ForceRow, dot};
use linkage_core::numeric::cholesky::Cholesky;

/// The least part of its diagonal that a pivot counts as, where rounding has taken it away.
pub(super) const LEAST_PIVOT: f64 = 1e-15;

/// The largest part of the distance to zero in one step of a slack or a multiplier.
const BOUNDARY: f64 = 0.99;

/// A point, `tau`, and for each position a slack, `tau - |f_i + Q_i y|^2` in the end, and a
/// multiplier, both positive.
pub(super) struct State<const N: usize> {
    pub(super) point: [f64; N],
    tau: f64,
    slacks: Vec<f64>,
    pub(super) multipliers: Vec<f64>,
}

/// The change of a state.
struct Step<const N: usize> {
    point: [f64; N],
    tau: f64,
    slacks: Vec<f64>,
    multipliers: Vec<f64>,
}

impl<const N: usize> State<N> {
    /// For forces of length 1 at most.
    pub(super) fn start(rows: &[ForceRow<N>]) -> Self {
        let tau = 2.0;
        let slack = |row: &ForceRow<N>| tau - dot(&row.force, &row.force);
        Self {
            point: [0.0; N],
            tau,
            slacks: rows.iter().map(slack).collect(),
            multipliers: vec![1.0 / rows.len() as f64; rows.len()],
        }
    }

    /// The state after a step. Values that are not finite, after a breakdown by rounding, make no
    /// harm: they never count as progress.
    pub(super) fn next(&self, rows: &[ForceRow<N>]) -> Self {
        let system = System::new(rows, self);
        let products = |slacks: &[f64], multipliers: &[f64]| -> f64 {
            slacks.iter().zip(multipliers).map(|(s, m)| s * m).sum()
        };
        // The predictor aims at products of slack and multiplier of 0.
        let zero = vec![0.0; rows.len()];
        let predictor = system.step(self, &zero, &zero);
        let share = predictor.longest(self);
        let ahead = self.after(&predictor, share);
        let mean = products(&self.slacks, &self.multipliers) / rows.len() as f64;
        let left = products(&ahead.slacks, &ahead.multipliers) / rows.len() as f64;
        // The less it gets there, the more the corrector aims at equal products.
        let centre = mean * (left / mean) * (left / mean) * (left / mean);
        let second = share * share;
        let changes = predictor.slacks.iter().zip(&predictor.multipliers);
        let centres: Vec<f64> = changes.map(|(s, m)| centre - second * s * m).collect();
        let bends = rows.iter().map(|row| {
            let change = row.change(&predictor.point);
            second * dot(&change, &change)
        });
        let bends: Vec<f64> = bends.collect();
        let corrector = system.step(self, &centres, &bends);
        self.after(&corrector, corrector.longest(self))
    }

    fn after(&self, step: &Step<N>, share: f64) -> Self {
        let add = |from: &[f64], changes: &[f64]| -> Vec<f64> {
            let pairs = from.iter().zip(changes);
            pairs.map(|(x, change)| x + share * change).collect()
        };
        Self {
            point: core::array::from_fn(|j| self.point[j] + share * step.point[j]),
            tau: self.tau + share * step.tau,
            slacks: add(&self.slacks, &step.slacks),
            multipliers: add(&self.multipliers, &step.multipliers),
        }
    }
}

impl<const N: usize> Step<N> {
    /// The largest share of the step, at most 1, that leaves slacks and multipliers positive.
    fn longest(&self, from: &State<N>) -> f64 {
        let slacks = from.slacks.iter().zip(&self.slacks);
        let multipliers = from.multipliers.iter().zip(&self.multipliers);
        let falling = slacks
            .chain(multipliers)
            .filter(|(_, change)| **change < 0.0);
        let shares = falling.map(|(x, change)| BOUNDARY * x / -change);
        shares.fold(1.0, f64::min)
    }
}

/// The linear system of a state. Slacks, multipliers and `tau` are eliminated from it: gradients of
/// the squares count from their weighted mean.
struct System<const N: usize> {
    gradients: Vec<[f64; N]>,
    /// The errors of the slacks.
    lacks: Vec<f64>,
    /// Multiplier over slack, and their sum.
    weights: Vec<f64>,
    weight: f64,
    mean: [f64; N],
    matrix: Cholesky<N>,
}

impl<const N: usize> System<N> {
    fn new(rows: &[ForceRow<N>], state: &State<N>) -> Self {
        let rests: Vec<[f64; 3]> = rows.iter().map(|row| row.with(&state.point)).collect();
        let pairs = rows.iter().zip(&rests);
        let gradients: Vec<[f64; N]> = pairs
            .map(|(row, rest)| row.effects.map(|effect| 2.0 * dot(&effect, rest)))
            .collect();
        let pairs = rests.iter().zip(&state.slacks);
        let lacks = pairs.map(|(rest, slack)| state.tau - dot(rest, rest) - slack);
        let pairs = state.multipliers.iter().zip(&state.slacks);
        let weights: Vec<f64> = pairs
            .map(|(multiplier, slack)| multiplier / slack)
            .collect();
        let weight: f64 = weights.iter().sum();
        let mut mean = [0.0; N];
        for (gradient, w) in gradients.iter().zip(&weights) {
            for (sum, g) in mean.iter_mut().zip(gradient) {
                *sum += w / weight * g;
            }
        }
        let mut matrix = [[0.0; N]; N];
        for (i, row) in rows.iter().enumerate() {
            let from_mean: [f64; N] = core::array::from_fn(|j| gradients[i][j] - mean[j]);
            for j in 0..N {
                for k in 0..=j {
                    let curvature = 2.0 * dot(&row.effects[j], &row.effects[k]);
                    matrix[j][k] +=
                        state.multipliers[i] * curvature + weights[i] * from_mean[j] * from_mean[k];
                }
            }
        }
        Self {
            lacks: lacks.collect(),
            gradients,
            weights,
            weight,
            mean,
            matrix: Cholesky::with_least_pivot(matrix, LEAST_PIVOT),
        }
    }

    /// The step to products of slack and multiplier of `centres`, if the squares grow by `bends`
    /// beyond their gradients.
    fn step(&self, state: &State<N>, centres: &[f64], bends: &[f64]) -> Step<N> {
        let count = self.weights.len();
        let lacks: Vec<f64> = (0..count).map(|i| self.lacks[i] - bends[i]).collect();
        let pulls = (0..count).map(|i| centres[i] / state.slacks[i] - self.weights[i] * lacks[i]);
        let pulls: Vec<f64> = pulls.collect();
        let excess = pulls.iter().sum::<f64>() - 1.0;
        let mut right = self.mean.map(|mean| excess * mean);
        for (gradient, pull) in self.gradients.iter().zip(&pulls) {
            for (sum, g) in right.iter_mut().zip(gradient) {
                *sum -= pull * g;
            }
        }
        let point = self.matrix.solve(right);
        let along =
            |gradient: &[f64; N]| -> f64 { gradient.iter().zip(&point).map(|(g, y)| g * y).sum() };
        let tau = excess / self.weight + along(&self.mean);
        let rises = self.gradients.iter().zip(&lacks);
        let slacks: Vec<f64> = rises.map(|(g, lack)| tau - along(g) + lack).collect();
        let multipliers = (0..count).map(|i| {
            centres[i] / state.slacks[i] - state.multipliers[i] - self.weights[i] * slacks[i]
        });
        Step {
            multipliers: multipliers.collect(),
            point,
            tau,
            slacks,
        }
    }
}
