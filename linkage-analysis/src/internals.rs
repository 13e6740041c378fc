//! Items that other crates of linkage use, and users do not.

#[cfg(feature = "alloc")]
pub use crate::components::in_space;
pub use crate::components::norm;
#[cfg(feature = "files")]
pub use crate::cyclogram::files::{bars, intervals};
#[cfg(feature = "tolerance")]
pub use crate::tolerance::modulus::corners;
#[cfg(feature = "tolerance")]
pub use crate::tolerance::student::outside as student_outside;
