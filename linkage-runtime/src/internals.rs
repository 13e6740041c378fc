//! Items that other crates of linkage use, and users do not.

pub use crate::cyclogram::files::{bars, intervals};
