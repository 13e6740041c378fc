//! A step of a descent: the least sum of squares of the linearised residuals and of the damped step
//! within all limits.

use std::vec;
use std::vec::Vec;

use super::super::limits::Limits;
use super::super::normal::Normal;
use super::super::quadratic::{Face, Quadratic};

/// The quadratic program of a step, with memory for all descents within the same limits.
#[derive(Clone, Debug)]
pub(crate) struct StepProgram<'l> {
    limits: &'l Limits,
    /// The damped normal matrix.
    gram: Vec<f64>,
    /// The limits, then the conditions.
    faces: Vec<Face>,
    /// The number of faces, the first ones, that are bounds, and of those that are limits.
    bounds: usize,
    linear: usize,
    program: Quadratic,
}

impl<'l> StepProgram<'l> {
    pub(crate) fn new(limits: &'l Limits) -> Self {
        // The slacks are put in before each step.
        let (faces, bounds) = limits.faces(&vec![0.0; limits.len()]);
        Self {
            limits,
            gram: Vec::new(),
            bounds,
            linear: faces.len(),
            faces,
            program: Quadratic::default(),
        }
    }

    /// Solves for the damped step within all limits; conditions that cannot be met at once are met
    /// in part. Returns the largest multiplier, 0 without conditions.
    pub(super) fn solve(
        &mut self,
        x: &[f64],
        here: &Normal,
        damping: f64,
        scale: &[f64],
    ) -> Option<f64> {
        let n = x.len();
        self.gram.clear();
        self.gram.extend_from_slice(&here.gram);
        for (j, scale) in scale.iter().enumerate() {
            // A variable without effect stays where it is.
            let scale = if *scale > 0.0 { *scale } else { 1.0 };
            self.gram[j * n + j] += damping * scale;
        }
        self.faces.truncate(self.linear);
        self.limits.put_slacks(x, &mut self.faces);
        if here.conditions.is_empty() {
            let solved = self.program.solve(&self.gram, &here.gradient, &self.faces);
            return solved.then_some(0.0);
        }
        for part in [1.0, 0.5, 0.1, 0.0] {
            self.faces.truncate(self.linear);
            for (value, slopes) in &here.conditions {
                let normal = slopes
                    .iter()
                    .copied()
                    .enumerate()
                    .filter(|(_, slope)| *slope != 0.0);
                let slack = if *value < 0.0 { part * value } else { *value };
                self.faces.push(Face {
                    normal: normal.collect(),
                    slack,
                    equality: false,
                });
            }
            if self.program.solve(&self.gram, &here.gradient, &self.faces) {
                let multipliers = self.program.multipliers.iter();
                return Some(multipliers.fold(0.0, |most: f64, u| most.max(u.abs())));
            }
        }
        None
    }

    /// Returns the decrease of the linearised sum of squares, with the cost of conditions.
    pub(super) fn promise(&self, here: &Normal, price: f64) -> f64 {
        let d = &self.program.d;
        let n = d.len();
        let mut quadratic = 0.0;
        let mut linear = 0.0;
        for i in 0..n {
            linear += here.gradient[i] * d[i];
            let row = &here.gram[i * n..i * n + i];
            let below: f64 = row.iter().zip(d).map(|(h, d)| h * d).sum();
            quadratic += d[i] * (below + 0.5 * here.gram[i * n + i] * d[i]);
        }
        let after: f64 = here
            .conditions
            .iter()
            .map(|(value, slopes)| {
                let slope: f64 = slopes.iter().zip(d).map(|(s, d)| s * d).sum();
                (-(value + slope)).max(0.0)
            })
            .sum();
        price * (here.violation() - after) - linear - quadratic
    }

    /// Fills the place to which the step leads. Variables at active bounds are on them to the last
    /// bit.
    pub(super) fn put_trial(&self, x: &[f64], trial: &mut Vec<f64>) {
        trial.clear();
        trial.extend(x.iter().zip(&self.program.d).map(|(x, d)| x + d));
        let limits = self.limits;
        limits.clamp(trial);
        let active = self.program.active.iter();
        for &active in active.filter(|&&active| active < self.bounds) {
            for &(j, a) in &self.faces[active].normal {
                trial[j] = if a > 0.0 {
                    limits.lower[j]
                } else {
                    limits.upper[j]
                };
            }
        }
    }
}
