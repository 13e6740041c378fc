//! Levenberg's and Marquardt's method within bounds and linear relations.
//!
//! Each step is the least sum of squares of the linearised residuals and of the damped step, within
//! all limits at once: a small quadratic program, in which faces become active and inactive as they
//! should. So the optimum on a bound is as exact as one inside. A descent does not call the
//! function: it says where it wants to know it, so that many descents are evaluated side by side,
//! in lanes over mechanisms.
//!
//! Damping by H. B. Nielsen, "Damping parameter in Marquardt's method", Technical University of
//! Denmark, 1999; scaled by the largest diagonal so far, as J. J. Moré does, so that units do not
//! matter.

use std::vec::Vec;

use super::limits::Limits;
use super::normal::Normal;
use super::quadratic::{Face, Quadratic};

/// The first damping, as part of the diagonal.
const FIRST: f64 = 1e-3;
/// A damping above this part of the diagonal has no step left that rounding would show.
const STUCK: f64 = 1e14;
/// The least damping: below it, nothing of a diagonal is left in double precision.
const LEAST: f64 = 1e-15;
/// A step that promises less than this part of the sum of squares is the last one: some hundred
/// roundoffs, so the sum does not show whether it was good, but the variables, which are the root
/// of that from where they belong, gain half of their digits.
const PROMISE: f64 = 1e-14;
/// A sum of squares of this part of the first one is zero: its root is as far below it as rounding.
const ZERO: f64 = 1e-32;

/// Sums below this part of the first one are alike: their roots differ by some thousand roundoffs.
const NOTHING: f64 = 1e-24;

/// The state of a descent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum State {
    /// It wants to know the function at its trial.
    Running,
    /// No step makes the sum smaller.
    Converged,
    /// The most steps are done.
    Exhausted,
}

/// A descent to a local least sum of squares.
#[derive(Clone, Debug)]
pub(crate) struct Descent {
    /// The best place so far.
    pub(crate) x: Vec<f64>,
    /// The function there.
    pub(crate) here: Normal,
    /// The place of the next evaluation.
    pub(crate) trial: Vec<f64>,
    /// Evaluations so far.
    pub(crate) count: usize,
    most: usize,
    first: f64,
    damping: f64,
    growth: f64,
    promised: f64,
    /// True for the last trial.
    last: bool,
    /// The weight of violated conditions, against half the sum of squares.
    price: f64,
    scale: Vec<f64>,
    gram: Vec<f64>,
    faces: Vec<Face>,
    /// The number of faces, the first ones, that are bounds.
    bounds: usize,
    program: Quadratic,
}

impl Descent {
    /// Begins at a place within the limits, with this many evaluations at most. The first trial is
    /// the place itself.
    pub(crate) fn new(start: Vec<f64>, most: usize) -> Self {
        let n = start.len();
        Self {
            trial: start.clone(),
            x: start,
            here: Normal {
                sum: f64::NAN,
                ..Normal::new(n)
            },
            count: 0,
            most,
            first: f64::NAN,
            damping: FIRST,
            growth: 2.0,
            promised: 0.0,
            last: false,
            price: 0.0,
            scale: std::vec![0.0; n],
            gram: Vec::new(),
            faces: Vec::new(),
            bounds: 0,
            program: Quadratic::default(),
        }
    }

    /// Takes the function at the trial and chooses the next one.
    pub(crate) fn advance(&mut self, limits: &Limits, there: &mut Normal) -> State {
        self.count += 1;
        if self.count == 1 {
            if !there.is_finite() {
                return State::Exhausted;
            }
            self.first = there.sum;
            self.take(there);
        } else if self.last {
            if there.is_finite() && self.merit(there) <= (1.0 + PROMISE) * self.merit(&self.here) {
                self.take(there);
            }
            return State::Converged;
        } else if self.improves(there) {
            let gain = (self.merit(&self.here) - self.merit(there)) / self.promised;
            self.damping =
                (self.damping * (1.0 - (2.0 * gain - 1.0).powi(3)).max(1.0 / 3.0)).max(LEAST);
            self.growth = 2.0;
            self.take(there);
        } else {
            self.damping *= self.growth;
            self.growth *= 2.0;
        }
        if self.here.sum <= ZERO * self.first && self.here.violation() == 0.0 {
            return State::Converged;
        }
        if self.count >= self.most {
            return State::Exhausted;
        }
        self.step(limits)
    }

    /// Returns true if the sum is zero except for rounding.
    pub(crate) fn is_zero(&self) -> bool {
        self.here.sum <= NOTHING * self.first
    }

    fn take(&mut self, there: &mut Normal) {
        core::mem::swap(&mut self.here, there);
        self.x.copy_from_slice(&self.trial);
        let n = self.x.len();
        for (j, scale) in self.scale.iter_mut().enumerate() {
            *scale = scale.max(self.here.gram[j * n + j]);
        }
    }

    fn improves(&self, there: &Normal) -> bool {
        there.is_finite() && self.merit(there) < self.merit(&self.here)
    }

    fn merit(&self, at: &Normal) -> f64 {
        0.5 * at.sum + self.price * at.violation()
    }

    /// The next trial, or the end where none promises anything.
    fn step(&mut self, limits: &Limits) -> State {
        let n = self.x.len();
        while self.damping < STUCK {
            self.gram.clear();
            self.gram.extend_from_slice(&self.here.gram);
            for (j, scale) in self.scale.iter().enumerate() {
                // A variable without effect stays where it is.
                let scale = if *scale > 0.0 { *scale } else { 1.0 };
                self.gram[j * n + j] += self.damping * scale;
            }
            if !self.solve(limits) {
                self.damping *= 10.0;
                continue;
            }
            self.promised = self.promise();
            self.last = self.promised <= PROMISE * self.merit(&self.here);
            self.trial.clear();
            self.trial
                .extend(self.x.iter().zip(&self.program.d).map(|(x, d)| x + d));
            limits.clamp(&mut self.trial);
            self.touch(limits);
            return match self.trial == self.x {
                true => State::Converged,
                false => State::Running,
            };
        }
        State::Converged
    }

    /// Puts variables at active bounds on them to the last bit.
    fn touch(&mut self, limits: &Limits) {
        for &active in self
            .program
            .active
            .iter()
            .filter(|&&active| active < self.bounds)
        {
            for &(j, a) in &self.faces[active].normal {
                self.trial[j] = if a > 0.0 {
                    limits.lower[j]
                } else {
                    limits.upper[j]
                };
            }
        }
    }

    /// The damped step within all limits; conditions that cannot be met at once are met in part.
    fn solve(&mut self, limits: &Limits) -> bool {
        self.bounds = limits.faces(&self.x, &mut self.faces);
        let linear = self.faces.len();
        if self.here.conditions.is_empty() {
            return self
                .program
                .solve(&self.gram, &self.here.gradient, &self.faces);
        }
        for part in [1.0, 0.5, 0.1, 0.0] {
            self.faces.truncate(linear);
            for (value, slopes) in &self.here.conditions {
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
            if self
                .program
                .solve(&self.gram, &self.here.gradient, &self.faces)
            {
                let steepest = self
                    .program
                    .multipliers
                    .iter()
                    .fold(0.0, |most: f64, u| most.max(u.abs()));
                self.price = self.price.max(2.0 * steepest);
                return true;
            }
        }
        false
    }

    /// Returns the decrease of the linearised sum of squares, with the cost of conditions.
    fn promise(&self) -> f64 {
        let n = self.x.len();
        let d = &self.program.d;
        let mut quadratic = 0.0;
        let mut linear = 0.0;
        for i in 0..n {
            linear += self.here.gradient[i] * d[i];
            let row = &self.here.gram[i * n..i * n + i];
            let below: f64 = row.iter().zip(d).map(|(h, d)| h * d).sum();
            quadratic += d[i] * (below + 0.5 * self.here.gram[i * n + i] * d[i]);
        }
        let after: f64 = self
            .here
            .conditions
            .iter()
            .map(|(value, slopes)| {
                let slope: f64 = slopes.iter().zip(d).map(|(s, d)| s * d).sum();
                (-(value + slope)).max(0.0)
            })
            .sum();
        self.price * (self.here.violation() - after) - linear - quadratic
    }
}

/// Descends from a place to a local least sum of squares. `evaluate` clears and fills the function
/// at a place.
pub(crate) fn minimise(
    start: Vec<f64>,
    limits: &Limits,
    most: usize,
    mut evaluate: impl FnMut(&[f64], &mut Normal),
) -> (Descent, State) {
    let mut there = Normal::new(start.len());
    let mut descent = Descent::new(start, most);
    loop {
        there.clear();
        evaluate(&descent.trial, &mut there);
        let state = descent.advance(limits, &mut there);
        if state != State::Running {
            return (descent, state);
        }
    }
}

#[cfg(test)]
mod tests;
