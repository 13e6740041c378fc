//! Why a mechanism could not be assembled.

mod assembly;
#[cfg(feature = "alloc")]
mod closest_approach;
mod group;
mod not_followed;
#[cfg(feature = "alloc")]
mod unprepared;

pub use assembly::AssemblyError;
#[cfg(any(feature = "std", feature = "libm"))]
pub(crate) use assembly::LARGEST;
#[cfg(feature = "alloc")]
pub use closest_approach::{ClosestApproach, Missed};
pub use group::GroupRef;
pub use not_followed::{Halt, NotFollowed};
#[cfg(feature = "alloc")]
pub use unprepared::{CoupledCause, CoupledError, Placed, Value};
