//! Curves over the input.

mod axes;
mod builder;
mod curve;
mod gaps;
mod legend;
mod mistakes;
mod output;
mod panel;
mod picture;
mod stroke;
pub(super) mod ticks;

pub use builder::Plot;
