//! The best mechanism of a cycle.

use core::fmt;
use std::vec::Vec;

use linkage_core::format::rounded;

/// A local optimum that holds all that must hold.
#[derive(Clone, Debug, PartialEq)]
pub struct BestCycle<M, A> {
    /// Its dimensions.
    pub mechanism: M,
    /// Assembled on the circuit that runs through the whole range.
    pub assembly: A,
    /// The value of the goal, such as the longest dwell or the least peak, verified by the
    /// mechanism.
    pub goal: f64,
    /// The variables that each objective has for itself, in the order of the objectives: where a
    /// dwell begins and others.
    pub auxiliary: Vec<Vec<f64>>,
    /// Its smallest margin over the range, 0 at a dead point.
    pub margin: f64,
    /// The input where the margin is smallest.
    pub margin_at: f64,
    /// Names of the parameters that are at a bound, with the bound.
    pub at_bound: Vec<(&'static str, f64)>,
    /// Steps of the search, those that were taken back among them.
    pub steps: usize,
    /// Mechanisms that were tried.
    pub evaluations: usize,
    /// True if the first-order conditions hold: no step as long as the first one gains, to first
    /// order, more than 1e-5 of the change of the goal by such a step. Not if steps, time limit or
    /// cancellation ended the search, if it found no step although slopes promise one, or if the
    /// best result is that of narrower bounds.
    pub converged: bool,
    /// Number of starts that led here.
    pub hits: usize,
}

/// The figures in a few lines.
impl<M, A> fmt::Display for BestCycle<M, A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "goal {}", rounded(self.goal))?;
        writeln!(
            f,
            "smallest margin {} at {}",
            rounded(self.margin),
            rounded(self.margin_at)
        )?;
        let end = if self.converged {
            ""
        } else {
            ", ended before it converged"
        };
        writeln!(
            f,
            "{} steps, {} mechanisms{end}",
            self.steps, self.evaluations
        )?;
        let names: Vec<&str> = self.at_bound.iter().map(|(name, _)| *name).collect();
        match names.is_empty() {
            true => writeln!(f, "no parameter is at a bound"),
            false => writeln!(f, "at a bound: {}", names.join(", ")),
        }
    }
}
