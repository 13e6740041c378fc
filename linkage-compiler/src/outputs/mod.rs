//! Functions as expressions: quantities, derivatives, sensitivities and pictures.
//!
//! [`expressions`] returns the results of each function in a plain graph of its own. Among several
//! ways to the same results it takes the one whose code is shortest.

mod choice;
mod columns;
mod dependencies;
mod doc_text;
mod effort;
mod expressions;
mod fields;
mod isolated;
mod needs;
mod part_graph;
mod quantity;
mod state;
#[cfg(test)]
mod tests;

pub(crate) use expressions::{expressions, requested};
pub(crate) use state::State;
