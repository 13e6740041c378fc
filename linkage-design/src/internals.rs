//! Items that other crates of linkage use, and users do not.

pub use crate::parallel::in_parallel;
pub use crate::quasi_random::unit as quasi_random;
