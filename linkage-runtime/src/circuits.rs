//! Assemblies over the range of an input: those that run through it, and the ends of the others.

mod branch;
mod coupled;
mod curve;
mod find;
mod join;
mod leaf;
mod levels;
mod margins;
mod meetings;
mod one_input;
mod parts;
mod print;
mod search;
mod slab;
mod stretches;
#[cfg(test)]
mod tests;
mod trace;
mod undetermined;
mod unknowns;

pub use branch::{Branch, BranchEnd, Circuits, Estimate, Meeting, Undetermined};
pub use find::circuits;
pub use levels::{Chosen, Levels, Searched};
pub use one_input::circuits_of;
