//! Items that other crates of linkage use, and users do not.

pub use crate::numbered::{WHOLE, missing, read_results, unite, write_results};
pub use crate::parallel::in_parallel;
pub use crate::quasi_random::unit as quasi_random;
