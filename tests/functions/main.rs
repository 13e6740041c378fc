//! Generated functions: their arguments, their operations, and what they give out of reach.

mod arguments;
mod far_sizes;
mod refusals;
mod slicing;
mod slicing_space;
