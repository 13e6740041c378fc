//! The symbolic engine of the linkage compiler.
//!
//! A [`Graph`] is a flat arena of hash-consed operations, children before parents. Its constructors
//! simplify by [`rules`]. Symbols are its leaves. A symbol may have a definition, which is another
//! node: the solution of a loop is a definition. Derivatives of such a symbol come from
//! [`Calculus::symbol_derivative`], its value comes from the definition. [`inline`] removes the
//! definitions and leaves a plain graph of parameters and inputs, [`schedule`] slices and orders it
//! as a [`Program`](program::Program), [`passes`] polish that, and [`interpret`] runs it. Formulas
//! are written with [`Ex`] and [`Vector`].
//!
//! This crate has no tokens, spans or syntax.

pub mod blocks;
mod differentiate;
mod expression;
mod graph;
pub mod interpret;
pub mod lookup;
mod operands;
mod operation;
pub mod passes;
pub mod program;
pub mod rules;

pub use differentiate::{Calculus, DerivativeMemo, differentiate, pull_back};
pub use expression::{
    Ex, MAX_DEGREE, Monomial, Obstacle, Polynomial, V2, V3, Vector, Vn, collect, evaluate,
    evaluate_given, numerically_equal, numerically_equal_within, obstacle, substitute,
};
pub use graph::{Binding, Graph, Node, NodeId, Snapshot, Symbol, SymbolId};
pub use passes::common_factors::share_common_factors;
pub use passes::half_angles::by_half_angles;
pub use passes::inline;
pub use passes::late_roots::late_roots;
pub use program::{count, schedule};
