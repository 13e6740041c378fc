//! Cyclograms: from which to which angle of the shaft each organ of a machine advances, dwells and returns.
//!
//! An [`Member`] is made of the [`Curve`](crate::summary::Curve) of a quantity and of the [`Band`]s in which it is
//! said to dwell. Its [`Event`]s, where one motion ends and the next one begins, are roots of exact derivatives, with
//! their sensitivities to the dimensions by the implicit function theorem. A [`Cyclogram`] is all organs of a shaft:
//! what follows what, by how many degrees, and what happens at the same time.

mod accuracy;
mod band;
mod error;
mod event;
mod lag;
mod machine;
mod member;
mod overlap;
mod print;
mod setting;
mod steps;

pub use band::Band;
pub use error::{BandMistake, CyclogramError};
pub use event::{Cause, Event, Motion};
pub use lag::Lag;
pub use machine::{Cyclogram, Moment};
pub use member::Member;
pub use overlap::{Overlap, Overlaps};
pub use setting::{Setting, SettingError, set_event};
pub use steps::{Slot, nearest_slot};
