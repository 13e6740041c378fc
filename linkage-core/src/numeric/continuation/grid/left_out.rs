//! Parts of the ranges that a grid does not serve.

use alloc::vec::Vec;

/// The part of the ranges that a grid should serve and does not.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// The share of the ranges.
    pub share: f64,
    /// The inputs at one of the positions.
    pub at: Vec<f64>,
}
