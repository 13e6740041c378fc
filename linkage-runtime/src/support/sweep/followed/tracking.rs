//! Many mechanisms on their straight ways to dimensions of their own, side by side: each takes its own steps, and whoever has arrived makes
//! room for the next.

mod groups;
mod history;
mod moving;
mod run;
mod slots;
mod tracker;

pub(super) use groups::{Groups, StateSpan};
pub use moving::Moving;
pub(super) use run::track_rows;
