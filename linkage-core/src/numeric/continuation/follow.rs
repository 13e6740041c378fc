//! Newton's method with a guard against jumps to another solution.

use super::{Correction, Step};

/// Steps of this size leave nothing but rounding: half of their square, times the ratio of second
/// to first derivatives of the equations, is less than the rounding that is inherent in such
/// equations.
pub(super) const SETTLED: f64 = 1e-8;

/// Steps of this size leave about a hundredth of the error allowed for polynomials, [`SETTLED`].
const ABOUT: f64 = 1e-5;

/// A first correction must not be larger: radians, or lengths on the scale of the state.
const FAR: f64 = 0.25;

/// Each correction must be smaller than the one before by this factor, as it is where Newton's
/// method is certain to converge to the nearest solution.
const CONTRACTION: f64 = 0.2;

/// Corrections that make up one position, at most.
const STEPS: usize = 8;

/// A solution that is followed: the sign of its determinant never changes.
pub(super) struct Follower<'a> {
    correction: &'a mut dyn Correction,
    sign: f64,
    /// Corrections that may still be made.
    left: usize,
}

impl<'a> Follower<'a> {
    /// Begins at `x` with a state that solves the equations about, and improves it. `None` if it
    /// does not.
    pub(super) fn new(
        correction: &'a mut dyn Correction,
        x: &[f64],
        state: &mut [f64],
        most: usize,
    ) -> Option<Self> {
        let step = correction.correct(x, state);
        let small = step.size <= FAR && step.determinant.is_finite() && step.determinant != 0.0;
        let mut follower = Self {
            correction,
            sign: step.determinant.signum(),
            left: most,
        };
        (small && follower.settle(x, state).is_some()).then_some(follower)
    }

    /// One correction; `None` if it is not finite, the determinant has the wrong sign, or too many
    /// have been made.
    pub(super) fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Option<Step> {
        self.left = self.left.checked_sub(1)?;
        let step = self.correction.correct(x, state);
        (step.size.is_finite() && step.determinant * self.sign > 0.0).then_some(step)
    }

    /// Corrects a state until it solves the equations; returns the determinant. `None` if that does
    /// not happen quickly and evenly.
    pub(super) fn settle(&mut self, x: &[f64], state: &mut [f64]) -> Option<f64> {
        self.settle_within(x, state, STEPS, CONTRACTION)
    }

    /// Corrects until the rest is less than the error allowed for polynomials.
    pub(super) fn settle_about(&mut self, x: &[f64], state: &mut [f64]) -> Option<f64> {
        self.settle_to(ABOUT, x, state, STEPS, CONTRACTION)
    }

    /// The same in so many steps, each smaller than the one before by this factor.
    pub(super) fn settle_within(
        &mut self,
        x: &[f64],
        state: &mut [f64],
        steps: usize,
        contraction: f64,
    ) -> Option<f64> {
        self.settle_to(SETTLED, x, state, steps, contraction)
    }

    fn settle_to(
        &mut self,
        settled: f64,
        x: &[f64],
        state: &mut [f64],
        steps: usize,
        contraction: f64,
    ) -> Option<f64> {
        let mut allowed = FAR;
        for _ in 0..steps {
            let step = self.correct(x, state)?;
            if step.size <= settled {
                return Some(step.determinant);
            }
            if step.size > allowed {
                return None;
            }
            allowed = contraction * step.size;
        }
        None
    }

    /// Returns the number of corrections that may still be made.
    pub(super) fn left(&self) -> usize {
        self.left
    }

    /// Returns whether no more corrections may be made.
    pub(super) fn exhausted(&self) -> bool {
        self.left == 0
    }
}
