//! Items that other crates of linkage use, and users do not.

pub use crate::components::{in_space, norm};
#[cfg(feature = "report")]
pub use crate::cyclogram::files::{bars, intervals};
pub use crate::tolerance::modulus::corners;
pub use crate::tolerance::student::outside as student_outside;
