//! Conditions that do not hold.

/// A condition that does not hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Violation {
    /// The number of its objective.
    pub(crate) objective: usize,
    /// The size of the violation.
    pub(crate) by: f64,
    /// The same as a part of its size.
    pub(crate) part: f64,
}
