//! Items of the struct block and functions of the `impl` block.

pub(super) mod arc;
pub(super) mod argument;
pub(super) mod coordinates;
pub(super) mod definitions;
pub(super) mod evaluators;
pub(super) mod link_elements;
pub(super) mod parameter;
pub(super) mod scalars;
pub(super) mod struct_block;
pub(super) mod unknown_frame;
