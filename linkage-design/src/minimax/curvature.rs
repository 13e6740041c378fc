//! The curvature of rows, gathered from their derivatives at the places of a search.

use std::vec;
use std::vec::Vec;

use super::rows::{FunctionRow, Groups, Key};
use linkage_core::numeric::vector::dot;

/// A positive definite approximation of the second derivatives of the rows, each times its weight,
/// in reaches.
///
/// The part of Gauss and Newton of a sum of squares is known, and only the rest is gathered.
///
/// Updated by Broyden, Fletcher, Goldfarb and Shanno with Powell's damping: M. J. D. Powell, "A
/// fast algorithm for nonlinearly constrained optimization calculations", Lecture Notes in
/// Mathematics 630 (1978).
#[derive(Clone, Debug)]
pub(super) struct Curvature {
    reach: Vec<f64>,
    /// The gathered part.
    matrix: Vec<f64>,
    /// The known part at the current place.
    known: Vec<f64>,
    begun: bool,
}

/// Share of a first estimate that is used: too much curvature makes steps short, too little is
/// bounded by the box.
const FIRST: f64 = 0.1;
/// Powell's: an update leaves at least this part of the curvature along the step.
const LEAST: f64 = 0.2;
/// Rows whose places differ by more than this are not the same, in radians or in the unit of the
/// input.
const NEAR: f64 = 0.2;

impl Curvature {
    pub(super) fn new(reach: &[f64]) -> Self {
        Self {
            matrix: vec![0.0; reach.len() * reach.len()],
            known: vec![0.0; reach.len() * reach.len()],
            reach: reach.to_vec(),
            begun: false,
        }
    }

    pub(super) fn entry(&self, i: usize, j: usize) -> f64 {
        let index = i * self.reach.len() + j;
        self.matrix[index] + self.known[index]
    }

    /// The slopes of a row by the variables in reaches.
    fn scaled(&self, row: &FunctionRow) -> Vec<f64> {
        let slopes = row.slopes.iter().zip(&self.reach);
        slopes.map(|(slope, reach)| slope * reach).collect()
    }

    /// The search is at another place.
    pub(super) fn see(&mut self, here: &Groups) {
        let n = self.reach.len();
        self.known.fill(0.0);
        for row in &here.squares {
            let scaled = self.scaled(row);
            for (line, a) in self.known.chunks_exact_mut(n).zip(&scaled) {
                line.iter_mut()
                    .zip(&scaled)
                    .for_each(|(sum, b)| *sum += 2.0 * a * b);
            }
        }
    }

    /// Half the curvature times a step twice.
    pub(super) fn along(&self, d: &[f64]) -> f64 {
        0.5 * (dot(d, &times(&self.matrix, d)) + dot(d, &times(&self.known, d)))
    }

    /// Learns from a step, unless a row that had a weight is no longer there.
    pub(super) fn update(
        &mut self,
        [from, to]: [&[f64]; 2],
        [here, there]: [&Groups; 2],
        weights: &[Vec<f64>],
    ) {
        let n = self.reach.len();
        let d: Vec<f64> = (0..n).map(|j| (to[j] - from[j]) / self.reach[j]).collect();
        let mut y = vec![0.0; n];
        let pairs = [(&here.objective, &there.objective)]
            .into_iter()
            .chain(here.conditions.iter().zip(&there.conditions));
        for ((rows, others), weights) in pairs.zip(weights) {
            for (row, &weight) in rows
                .iter()
                .zip(weights)
                .filter(|(_, weight)| **weight > 0.0)
            {
                let Some(other) = same(row, others) else {
                    return;
                };
                let slopes = other.slopes.iter().zip(&row.slopes).zip(&self.reach);
                for (y, ((after, before), reach)) in y.iter_mut().zip(slopes) {
                    *y += weight * reach * (after - before);
                }
            }
        }
        // The curvature of squares is known: it is taken at the end of the step.
        for row in &there.squares {
            let scaled = self.scaled(row);
            let along = dot(&scaled, &d);
            y.iter_mut()
                .zip(&scaled)
                .for_each(|(y, s)| *y -= 2.0 * along * s);
        }
        let square = dot(&d, &d);
        if square == 0.0 {
            return;
        }
        if !self.begun {
            let size = FIRST * (dot(&y, &y) / square).sqrt();
            if size == 0.0 {
                return;
            }
            (0..n).for_each(|j| self.matrix[j * n + j] = size);
            self.begun = true;
        }
        let image = times(&self.matrix, &d);
        let (bend, change) = (dot(&d, &image), dot(&d, &y));
        let part = if change >= LEAST * bend {
            1.0
        } else {
            (1.0 - LEAST) * bend / (bend - change)
        };
        let damped: Vec<f64> = y
            .iter()
            .zip(&image)
            .map(|(y, b)| part * y + (1.0 - part) * b)
            .collect();
        let along = dot(&d, &damped);
        for i in 0..n {
            for j in 0..n {
                self.matrix[i * n + j] +=
                    damped[i] * damped[j] / along - image[i] * image[j] / bend;
            }
        }
    }
}

fn times(matrix: &[f64], d: &[f64]) -> Vec<f64> {
    let rows = matrix.chunks_exact(d.len().max(1));
    rows.map(|row| dot(row, d)).collect()
}

fn same<'a>(row: &FunctionRow, others: &'a [FunctionRow]) -> Option<&'a FunctionRow> {
    let distance = |other: &FunctionRow| match (row.key, other.key) {
        (Key::Nth(a), Key::Nth(b)) if a == b => 0.0,
        (Key::At(a), Key::At(b)) => (a - b).abs(),
        _ => f64::INFINITY,
    };
    let nearest = others
        .iter()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    (distance(nearest) < NEAR).then_some(nearest)
}
