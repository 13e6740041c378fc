//! The mechanism assembled at its reference inputs.

use crate::algebra::Nominal;

use super::interpreter::Machine;

/// The mechanism assembled at the reference inputs.
#[derive(Debug)]
pub(crate) struct Reference {
    pub(crate) machine: Machine,
    /// Factors that make the slack of each group positive and about 1 at the reference.
    pub(crate) scales: Vec<f64>,
    /// True if all groups closed.
    pub(crate) closed: bool,
    /// The length that counts like a radian where assemblies are compared with estimates.
    pub(crate) longest: f64,
    /// Values at the reference of unknowns without an estimate, with their numbers.
    pub(crate) found: Vec<(usize, Vec<f64>)>,
}

/// The mechanism at its reference position.
#[derive(Clone, Copy)]
pub(crate) struct AtReference<'a> {
    pub(crate) reference: &'a Reference,
    /// The dimensions, with an estimate of every unknown.
    pub(crate) nominal: &'a Nominal,
    /// The dimensions with the estimates as they are declared.
    pub(crate) written: &'a Nominal,
}
