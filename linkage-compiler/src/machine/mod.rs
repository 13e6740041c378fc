//! The mechanism on numbers: the interpreter runs the programs that close its loops.
//!
//! Types and positions that the checks of `assembly`, `forces` and `picture` have in common.

mod input_range;
mod interpreter;
mod numbers;
mod other_inputs;
mod perturbed;
mod reference;
mod staged;

pub(crate) use input_range::followed_range;
pub(crate) use interpreter::Machine;
pub(crate) use numbers::Numbers;
pub(crate) use other_inputs::other_inputs;
pub(crate) use perturbed::{ALTERATIONS, altered, scattered};
pub(crate) use reference::{AtReference, Reference};
pub(crate) use staged::StagedProgram;
