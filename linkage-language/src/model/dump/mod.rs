//! The model as text, for golden files.

pub(super) mod expressions;
pub(super) mod mechanics;
pub(super) mod model;
