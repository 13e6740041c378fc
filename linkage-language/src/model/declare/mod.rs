//! Declaration of all names of a struct block, before any item is resolved.

pub(super) mod name_counts;
pub(super) mod part_names;
pub(super) mod passes;
pub(super) mod struct_names;
