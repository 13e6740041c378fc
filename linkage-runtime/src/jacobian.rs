//! Jacobians of mechanisms with as many results as inputs: both ways, for motions and for forces,
//! and where they are singular.

mod factors;
mod matrix;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod search;
mod singular_values;
#[cfg(test)]
mod tests;
mod vectors;

pub use matrix::Jacobian;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use search::{Singularity, SingularityKind, singularities};
