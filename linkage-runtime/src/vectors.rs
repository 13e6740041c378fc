//! Vectors of two and three components: those of nalgebra, or small ones.

#[cfg(any(not(feature = "nalgebra"), test))]
mod small;

#[cfg(feature = "nalgebra")]
pub use nalgebra::{Vector2, Vector3};
#[cfg(not(feature = "nalgebra"))]
pub use small::{Vector2, Vector3};
