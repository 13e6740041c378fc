//! Turns of angles: what `assemble()` finds without following them is what following finds, for random dimensions of mechanisms of every kind.

mod follow;
mod plane;
mod space;
