//! The assembly at the reference inputs: closing the loops, following angles, running through
//! ranges.
//!
//! The interpreter runs [`ClosurePrograms`](crate::ir::ClosurePrograms). [`assemble`] returns the
//! assembly that the start estimates choose.

mod assemble;
mod assembler;
mod at_state;
mod check;
mod closed_part;
mod continuation;
mod coupled_state;
mod dead_point;
mod degenerate;
mod drawn_length;
mod estimates;
mod follow;
mod followed;
mod gap;
mod listing;
mod parts;
mod range_failure;
mod ranges;
mod redundant;
mod reference;
mod refusal;
mod refused_range;
mod several;
mod sizes;
mod unfollowed;

pub(crate) use assemble::assemble;
pub(crate) use closed_part::AssembledPart;
#[cfg(test)]
pub(crate) use reference::assemble_reference;
