//! Local optima of a search.

use std::vec::Vec;

use super::catalogue::Local;

/// A local optimum, not yet certified.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Optimum {
    /// The variables.
    pub(crate) x: Vec<f64>,
    pub(crate) sum: f64,
    /// The index of the assembly.
    pub(crate) assembly: usize,
    /// The start that led here.
    pub(crate) start: usize,
    /// The number of starts that led here.
    pub(crate) hits: usize,
    /// True if no step makes the sum smaller.
    pub(crate) converged: bool,
    /// True if the sum is zero except for rounding.
    pub(crate) zero: bool,
}

impl Local for Optimum {
    fn varied(&self) -> &[f64] {
        &self.x
    }

    fn least(&self) -> f64 {
        self.sum
    }
}
