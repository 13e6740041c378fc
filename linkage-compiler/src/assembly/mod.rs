//! The mechanism on numbers: closing the loops at the reference inputs, following its angles, running through its ranges.
//!
//! Runs the programs of a [`Closing`](crate::ir::Closing) by the interpreter. Ends with a [`Reference`]: the assembly that the start
//! estimates choose.

pub(crate) mod at_state;
pub(crate) mod check;
pub(crate) mod continuation;
pub(crate) mod courses;
pub(crate) mod dead_point;
pub(crate) mod degenerate;
pub(crate) mod directions;
pub(crate) mod estimates;
pub(crate) mod follow;
pub(crate) mod followed;
pub(crate) mod follower;
pub(crate) mod gap;
pub(crate) mod listing;
pub(crate) mod machine;
pub(crate) mod numbers;
pub(crate) mod parts;
pub(crate) mod perturbed;
pub(crate) mod places;
pub(crate) mod range_failure;
pub(crate) mod ranges;
pub(crate) mod redundant;
pub(crate) mod reference;
pub(crate) mod refusal;
pub(crate) mod several;
pub(crate) mod sizes;
pub(crate) mod unfollowed;
pub(crate) mod unused;
pub(crate) mod values;

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
