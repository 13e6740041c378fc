//! Derivatives: `calculus` walks through the graph, `chain_rule` has the formula of each operation,
//! `known_slope` those that are said.

mod calculus;
mod chain_rule;
mod known_slope;

pub use calculus::{Calculus, DerivativeMemo, differentiate};
pub use chain_rule::pull_back;
