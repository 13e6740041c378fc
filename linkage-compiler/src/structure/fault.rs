//! Faults of a mechanism's structure, as messages that are not reported yet.

use crate::diagnostic::OriginId;

/// A fault of the structure.
#[derive(Clone, Debug)]
pub(crate) struct StructureFault {
    /// The words at fault.
    pub(crate) origin: OriginId,
    pub(crate) text: String,
}

/// The text that marks every limit of the compiler.
pub(crate) const OURS: &str = "this is a limit of linkage, not a mistake of yours";
