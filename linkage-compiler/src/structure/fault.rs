//! Faults of a mechanism's structure, as messages that are not reported yet.

use crate::diagnostic::OriginId;

/// A fault of the structure.
#[derive(Clone, Debug)]
pub(crate) struct StructureFault {
    /// The words at fault.
    pub(crate) origin: OriginId,
    pub(crate) text: String,
}
