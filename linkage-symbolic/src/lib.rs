//! The symbolic engine of the linkage compiler.
//!
//! A [`Graph`] is a flat arena of hash-consed operations, children before parents; its constructors simplify by [`rules`].
//! Symbols are its leaves; a symbol may have a definition (another node), which is how the solution of a loop enters: derivatives of such a symbol come from
//! [`Calculus::symbol_derivative`], its value from the definition. [`inline`] removes the definitions and
//! leaves a plain graph of parameters and inputs, [`schedule`] slices and orders it as a
//! [`Program`](program::Program), [`passes`] polish that, and [`interpret`] runs it. [`Ex`] and [`Vector`] are what formulas are written with.
//!
//! No tokens, spans or syntax here.

mod differentiate;
mod expression;
mod graph;
pub mod interpret;
pub mod lookup;
mod operation;
pub mod passes;
pub mod program;
pub mod rules;

pub use differentiate::{Calculus, DerivativeMemo, differentiate, pull_back};
pub use expression::{
    Ex, MAX_DEGREE, Monomial, Obstacle, Polynomial, V2, V3, Vector, Vn, agree, agree_within,
    collect, evaluate, evaluate_given, obstacle, substitute,
};
pub use graph::{Binding, Graph, Node, NodeId, Symbol, SymbolId};
pub use lookup as unordered;
pub use passes::common_factors::share_multiples;
pub use passes::half_angles::by_half_angles;
pub use passes::inline;
pub use passes::late_roots::roots_last;
pub use program::{count, schedule};
