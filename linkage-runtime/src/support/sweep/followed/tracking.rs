//! Many mechanisms on straight paths to dimensions of their own, side by side: each takes its own
//! steps, and the next one takes the slot of one that has arrived.

mod groups;
mod history;
mod moving;
mod run;
mod slots;
mod tracker;

pub(super) use groups::{Groups, StateSpan};
pub use moving::Moving;
pub(super) use run::track_rows;
