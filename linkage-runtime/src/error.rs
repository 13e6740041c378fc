//! Why a mechanism could not be assembled.

mod assembly;
mod group;
mod not_followed;
#[cfg(feature = "alloc")]
mod reach;
#[cfg(feature = "alloc")]
mod unprepared;

pub use assembly::AssemblyError;
pub(crate) use assembly::LARGEST;
pub use group::GroupRef;
pub use not_followed::{Halt, NotFollowed};
#[cfg(feature = "alloc")]
pub use reach::{Missed, Reach};
#[cfg(feature = "alloc")]
pub use unprepared::{CoupledCause, CoupledError, Placed, Value};
