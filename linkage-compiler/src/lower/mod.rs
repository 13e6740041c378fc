//! Lowering of expressions to programs: definitions inlined, values shared, sliced and ordered.
//!
//! [`mechanism`] makes all programs of a compiled mechanism. [`closure_programs`] makes those that
//! close the loops at the reference inputs, which are run by the interpreter before functions are
//! looked at.

mod closure_programs;
mod continuous_angles;
mod formulas;
mod functions;
mod groups;
mod mechanism;
mod missed;
mod passes;
mod plain;
mod signature;
mod survey;

pub(crate) use closure_programs::closure_programs;
pub(crate) use formulas::Formulas;
pub(crate) use functions::FunctionExpressions;
pub(crate) use mechanism::mechanism;
pub(crate) use plain::solved_groups;
