//! The result of one search, before it is certified.

use super::super::catalogue::Local;
use super::problem::SearchStart;

/// A condition holds if it is violated by less than this part of its change in a first step.
pub(super) const TOLERANCE: f64 = 1e-9;

/// A result of a search that is verified, not yet certified.
#[derive(Clone)]
pub(super) struct Ended {
    pub(super) at: SearchStart,
    /// The value that the search makes least.
    pub(super) least: f64,
    pub(super) steps: usize,
    pub(super) evaluations: usize,
    pub(super) converged: bool,
}

impl Local for Ended {
    fn varied(&self) -> &[f64] {
        &self.at.x
    }

    fn least(&self) -> f64 {
        self.least
    }
}
