//! Numeric searches and tables over the range of an input, on plain `f64`: no dependencies.

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod coupled;
pub(crate) mod minimum;
pub mod range;
#[cfg(feature = "alloc")]
pub mod roots;
#[cfg(feature = "alloc")]
pub(crate) mod summit;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod winding;
