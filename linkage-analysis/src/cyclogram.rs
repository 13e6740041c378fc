//! Cyclograms: from which to which angle of the shaft each member of a machine advances, dwells and
//! returns.
//!
//! A [`Member`] is made of the [`Curve`](crate::summary::Curve) of a quantity and of the [`Band`]s
//! in which it dwells. Its [`Event`]s, where one motion ends and the next one begins, are roots of
//! exact derivatives, with their sensitivities to the dimensions by the implicit function theorem.
//! A [`Cyclogram`] contains all members of a shaft: the order of their events, the angles between
//! these, and simultaneous motions.

mod accuracy;
mod band;
mod error;
mod event;
#[cfg(feature = "files")]
pub(crate) mod files;
mod lag;
mod machine;
mod member;
mod moment;
mod overlap;
mod print;
mod setting;
mod steps;

pub use band::Band;
pub use error::{BandMistake, CyclogramError};
pub use event::{Cause, Event, Motion};
pub use lag::Lag;
pub use machine::Cyclogram;
pub use member::Member;
pub use moment::Moment;
pub use overlap::{Overlap, Overlaps};
pub use setting::{Setting, SettingError, set_event};
pub use steps::{Slot, nearest_slot};
