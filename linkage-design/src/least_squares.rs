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

mod step_program;
#[cfg(test)]
mod tests;

use std::vec::Vec;

use super::limits::Limits;
use super::normal::Normal;
pub(crate) use step_program::StepProgram;

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
        }
    }

    /// Takes the function at the trial and chooses the next one. `there` has its sum of squares and
    /// its conditions; `derivatives` fills the rest, which is asked for only where the sum is small
    /// enough.
    pub(crate) fn advance(
        &mut self,
        step: &mut StepProgram<'_>,
        there: &mut Normal,
        derivatives: impl FnOnce(&mut Normal),
    ) -> State {
        self.count += 1;
        let small = match (self.count, self.last) {
            (1, _) => there.sum.is_finite(),
            (_, true) => self.merit(there) <= (1.0 + PROMISE) * self.merit(&self.here),
            (_, false) => self.merit(there) < self.merit(&self.here),
        };
        let better = small && {
            derivatives(there);
            there.is_finite()
        };
        if self.count == 1 {
            if !better {
                return State::Exhausted;
            }
            self.first = there.sum;
            self.take(there);
        } else if self.last {
            if better {
                self.take(there);
            }
            return State::Converged;
        } else if better {
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
        self.step(step)
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

    fn merit(&self, at: &Normal) -> f64 {
        0.5 * at.sum + self.price * at.violation()
    }

    /// The next trial, or the end where none promises anything.
    fn step(&mut self, step: &mut StepProgram<'_>) -> State {
        while self.damping < STUCK {
            let Some(steepest) = step.solve(&self.x, &self.here, self.damping, &self.scale) else {
                self.damping *= 10.0;
                continue;
            };
            self.price = self.price.max(2.0 * steepest);
            self.promised = step.promise(&self.here, self.price);
            self.last = self.promised <= PROMISE * self.merit(&self.here);
            step.put_trial(&self.x, &mut self.trial);
            return match self.trial == self.x {
                true => State::Converged,
                false => State::Running,
            };
        }
        State::Converged
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
    let mut step = StepProgram::new(limits);
    loop {
        there.clear();
        evaluate(&descent.trial, &mut there);
        let state = descent.advance(&mut step, &mut there, |_| {});
        if state != State::Running {
            return (descent, state);
        }
    }
}
