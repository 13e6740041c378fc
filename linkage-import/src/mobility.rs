//! The reach of a drawing: its mobility, and the ranges in which its inputs keep all links joined.
//!
//! Bodies are moved by Newton steps from the drawn pose. The compiler of the language checks the
//! ranges again: these are only a proposal that it need not refuse.

use crate::document::{Document, InputKind};

mod built;
mod constraints;
mod elimination;
mod motor_limits;
mod ranges;

use built::system;
pub(crate) use ranges::ranges;

/// Returns the mobility with some inputs held, or `None` for mechanisms that are too large.
pub(crate) fn mobility(document: &Document, inputs: &[InputKind]) -> Option<usize> {
    let system = system(document, inputs)?;
    let pose = system.drawn();
    let values = vec![0.0; inputs.len()];
    let rows = system.rows(&pose, &values);
    let rank = elimination::solve(rows, system.unknowns()).rank;
    Some(system.unknowns() - rank)
}
