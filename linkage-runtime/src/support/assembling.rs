//! The assembly of a mechanism: from its dimensions to closed loops.
//!
//! One code for all mechanisms. A mechanism is a [`Compiled`]: data and programs, which the macro
//! prints and the engine interprets.

#[cfg(any(feature = "std", feature = "libm"))]
mod assemble;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod assemblies;
#[cfg(any(feature = "std", feature = "libm"))]
mod close;
mod compiled;
mod description;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod group_programs;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod grouped;
mod list;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod mechanism_path;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod path;
#[cfg(any(feature = "std", feature = "libm"))]
mod preparation;
mod revolutions;
#[cfg(any(feature = "std", feature = "libm"))]
mod winding;

#[cfg(any(feature = "std", feature = "libm"))]
pub use assemble::assemble;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub(crate) use assemblies::with_lanes;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use assemblies::{assemble_coupled, assemblies, assemblies_at};
pub use compiled::{Compiled, CoreOf, DataOf, RevolutionsOf};
pub use description::Description;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use group_programs::GroupPrograms;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use grouped::{
    Bounds, GroupData, GroupProgram, Grouped, PlainGroups, SurveyedUnknown, bounds, slacks,
    surveyed,
};
pub use list::List;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use mechanism_path::CoupledParts;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub(crate) use mechanism_path::{MechanismPath, surveyor};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use path::{assemble_from, assemble_there};
pub use revolutions::{Along, Angle, ArrayRevolutions, Revolutions};
