//! The mechanism on numbers: closing the loops at the reference inputs, following its angles, running through its ranges.
//!
//! Runs the programs of a [`Closing`](crate::ir::Closing) by the interpreter. Ends with a [`Reference`]: the assembly that the start
//! estimates choose.

mod at_state;
mod check;
mod continuation;
mod courses;
mod dead_point;
mod degenerate;
mod directions;
mod estimates;
mod follow;
mod followed;
mod follower;
mod gap;
mod listing;
mod machine;
mod numbers;
mod parts;
mod perturbed;
mod places;
mod range_failure;
mod ranges;
mod redundant;
mod reference;
mod refusal;
mod several;
mod sizes;
mod unfollowed;
mod unused;
mod values;

pub(crate) use check::check_ranges;
pub(crate) use courses::check_courses;
pub(crate) use directions::check_directions;
pub(crate) use follow::followed_range;
pub(crate) use follower::check_names_of_follower;
pub(crate) use machine::Machine;
pub(crate) use parts::{Closed, inner_parts};
pub(crate) use perturbed::{ALTERATIONS, altered, scattered};
pub(crate) use places::places;
pub(crate) use redundant::check_redundant;
pub(crate) use reference::{Reference, assemble_reference};
pub(crate) use unused::warn_of_unused;
pub(crate) use values::check_values;
