//! The symbolic engine of the linkage compiler.
//!
//! A [`Graph`] is a flat arena of hash-consed operations, children before parents; its constructors simplify by [`rules`].
//! Symbols are its leaves; a symbol may have a definition (another node), which is how the solution of a loop enters: derivatives of such a symbol come from
//! [`Calculus::symbol_derivative`], its value from the definition. [`inline`] removes the definitions and
//! leaves a plain graph of parameters and inputs, [`schedule`] slices and orders it as a
//! [`Program`](program::Program), [`passes`] polish that, and [`interpret`] runs it. [`Ex`] and [`Vector`] are what formulas are written with.
//!
//! No tokens, spans or syntax here.

mod build;
pub mod count;
mod differentiate;
mod display;
mod evaluate;
mod expression;
mod graph;
mod half_angles;
pub mod inline;
pub mod interpret;
mod multiples;
mod operation;
mod partial;
pub mod passes;
mod polynomial;
mod probe;
pub mod program;
mod roots_last;
pub mod rules;
pub mod schedule;
mod substitute;
mod terms;
pub mod unordered;
mod vector;

pub use differentiate::{Calculus, DerivativeMemo, differentiate, pull_back};
pub use evaluate::{evaluate, evaluate_given};
pub use expression::Ex;
pub use graph::{Binding, Graph, Node, NodeId, Symbol, SymbolId};
pub use half_angles::by_half_angles;
pub use multiples::share_multiples;
pub use polynomial::{MAX_DEGREE, Monomial, Obstacle, Polynomial, collect, obstacle};
pub use probe::{agree, agree_within};
pub use roots_last::roots_last;
pub use substitute::substitute;
pub use vector::{V2, V3, Vector, Vn};
