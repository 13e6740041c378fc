//! The model as text, for golden files.

pub(super) mod bodies;
pub(super) mod expression;
pub(super) mod mechanism;
