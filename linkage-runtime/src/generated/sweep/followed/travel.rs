//! Many mechanisms on their straight ways to dimensions of their own, side by side: each takes its own steps, and whoever has arrived makes
//! room for the next.

mod groups;
mod history;
mod moving;
mod slots;
mod traveller;
mod walk;

pub(super) use groups::{Groups, Place};
pub use moving::Moving;
pub(super) use walk::travel;
