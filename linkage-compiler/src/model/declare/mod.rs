//! Declaration of all names of a struct block, before any item is resolved.

pub(super) mod counts;
pub(super) mod names;
pub(super) mod parts;
