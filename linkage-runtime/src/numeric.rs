//! Numeric searches over the range of an input, on plain `f64`: no dependencies, no allocation.

mod minimum;
pub mod range;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod winding;
