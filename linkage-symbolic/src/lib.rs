//! The symbolic engine of the linkage compiler.
//!
//! A [`Graph`] is a flat arena of hash-consed operations, children before parents; its constructors simplify by [`rules`].
//! Symbols are its leaves; a symbol may have a definition (another node), which is how the solution of a loop enters: derivatives of such a symbol come from
//! [`Calculus::symbol_derivative`], its value from the definition. [`inline`] removes the definitions and
//! leaves a plain graph of parameters and inputs, [`schedule`] slices and orders it as a
//! [`Program`](program::Program), and [`interpret`] runs that. [`Ex`] and [`Vector`] are what formulas are written with.
//!
//! No tokens, spans or syntax here.

mod build;
mod contract;
pub mod count;
mod differentiate;
mod display;
mod double_angles;
mod evaluate;
mod expression;
mod graph;
pub mod inline;
pub mod interpret;
mod multiples;
mod operation;
mod polynomial;
mod probe;
pub mod program;
pub mod rules;
pub mod schedule;
pub mod stages;
mod substitute;
mod terms;
pub mod unordered;
mod vector;

pub use differentiate::{Calculus, DerivativeMemo, differentiate, pull_back};
pub use evaluate::evaluate;
pub use expression::Ex;
pub use graph::{Binding, Graph, Node, NodeId, Symbol, SymbolId};
pub use multiples::share_multiples;
pub use polynomial::{Monomial, Polynomial, collect};
pub use probe::{agree, agree_within};
pub use substitute::substitute;
pub use vector::{V2, V3, Vector, Vn};
