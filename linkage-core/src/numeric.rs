//! Numeric methods on plain `f64`, without dependencies: complex and double-double numbers, linear
//! systems, searches, and tables over the range of an input.
//!
//! For the compiler and generated code, which shall do the same: what they need may change with
//! every version, so users do not see it.

pub mod bracket;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod cholesky;
pub mod choose_assembly;
pub mod complex;
pub mod complex_matrix;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod continuation;
pub mod double_double;
pub mod golden_section;
#[cfg(feature = "alloc")]
pub mod inverse;
#[cfg(feature = "alloc")]
pub mod largest_box;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod least_squares;
#[cfg(feature = "alloc")]
pub mod maximise;
pub mod range;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod rank;
#[cfg(feature = "alloc")]
pub mod roots;
pub mod vector;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod winding;
