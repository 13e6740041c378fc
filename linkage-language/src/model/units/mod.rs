//! Numbers with units: exact conversion, and the units in which results are printed.

pub(super) mod conversion;
pub(super) mod decimal;
pub(super) mod printed;
