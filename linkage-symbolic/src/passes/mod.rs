//! Passes that rewrite programs, and graphs before they become programs.
//!
//! `inline` copies a graph without definitions. `common_factors`, `half_angles` and `late_roots`
//! rewrite a plain graph before it is scheduled. The others rewrite a program. A pass does not
//! change the results. Its name is printed in dumps. [`stages`] cuts long programs.

pub mod common_factors;
pub mod contract;
pub mod double_angles;
pub mod half_angles;
pub mod inline;
pub mod late_roots;
mod list;
pub mod reciprocals;
pub mod sine_pairs;
pub mod singular;
pub mod stages;

pub use list::{PASSES, Pass, polished};
