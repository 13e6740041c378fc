//! Formulas: expressions and vectors of expressions, with their values, polynomials and equality.

mod any_vector;
mod evaluate;
mod ex;
mod lengths;
mod numeric_equality;
mod of_graph;
mod partial;
mod polynomial;
mod substitute;
mod vector;

pub use any_vector::Vn;
pub use evaluate::{evaluate, evaluate_given};
pub use ex::Ex;
pub use numeric_equality::{numerically_equal, numerically_equal_within};
pub use polynomial::{MAX_DEGREE, Monomial, Obstacle, Polynomial, collect, obstacle};
pub use substitute::substitute;
pub(crate) use substitute::{rebuild, rebuild_shared};
pub use vector::{V2, V3, Vector};
