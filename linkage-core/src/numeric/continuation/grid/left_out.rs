//! Parts of the ranges that a grid does not serve.

use alloc::vec::Vec;

/// Where a grid serves less than it should.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// The share of the ranges.
    pub share: f64,
    /// The inputs at one of the positions.
    pub at: Vec<f64>,
}
