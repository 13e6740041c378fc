//! Curves over the input.

mod axes;
mod builder;
mod curve;
mod legend;
mod missing;
mod mistakes;
mod output;
mod panel;
mod picture;
mod stroke;

pub use builder::Plot;
