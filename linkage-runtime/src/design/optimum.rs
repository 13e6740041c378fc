//! Local optima of a search.

use alloc::vec::Vec;

use super::catalogue::Local;

/// A local optimum, not yet certified.
#[derive(Clone, Debug)]
pub(crate) struct Optimum {
    /// The variables.
    pub(crate) x: Vec<f64>,
    pub(crate) sum: f64,
    /// Which of the assemblies.
    pub(crate) assembly: usize,
    /// The start that led here.
    pub(crate) start: usize,
    /// How many starts did.
    pub(crate) hits: usize,
    /// Whether no step makes the sum smaller.
    pub(crate) converged: bool,
    /// Whether the sum is zero but for rounding.
    pub(crate) zero: bool,
}

impl Local for Optimum {
    fn place(&self) -> &[f64] {
        &self.x
    }

    fn least(&self) -> f64 {
        self.sum
    }
}
