//! The unknown parameters of an identification.

use std::vec::Vec;

use crate::limits::Limits;
use linkage_runtime::Parameter;

/// The unknown parameters.
pub(super) struct Named {
    pub(super) parameters: Vec<Parameter>,
    /// Their places in `PARAMETERS`.
    pub(super) places: Vec<usize>,
    pub(super) starts: Vec<f64>,
    pub(super) values: Vec<f64>,
    pub(super) ranges: Vec<f64>,
    pub(super) limits: Limits,
}
