//! Systems that are solved together, and their results: variables of partial derivatives.

use linkage_symbolic::SymbolId;

/// Values that are solved together: a group's unknowns, or their derivatives by some variables.
/// Systems are in the order in which they depend on each other: a system mentions its own results
/// and those of smaller ones.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct System {
    pub(crate) group: usize,
    pub(crate) order: usize,
    /// In order; empty for the unknowns themselves.
    pub(crate) by: Vec<SymbolId>,
}

impl System {
    pub(crate) fn new(group: usize, by: Vec<SymbolId>) -> Self {
        Self {
            group,
            order: by.len(),
            by,
        }
    }
}

/// One result of a system.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Solved {
    pub(crate) system: System,
    pub(crate) position: usize,
}
