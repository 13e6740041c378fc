//! Many positions: a generated kernel over rows of arguments, into columns.

mod arguments;
mod blocks;
mod destination;
mod extended;
mod fill;
#[cfg(any(feature = "std", feature = "libm"))]
mod followed;
#[cfg(any(feature = "std", feature = "libm"))]
mod followed_sets;
mod instruction_set;
mod kernel;
mod over_inputs;
mod over_sets;
#[cfg(feature = "rayon")]
mod parallel;
mod staged;

pub use arguments::Arguments;
pub use fill::fill;
#[cfg(any(feature = "std", feature = "libm"))]
pub use followed::Moving;
#[cfg(all(feature = "rayon", any(feature = "std", feature = "libm")))]
pub use followed_sets::followed_sweep_sets_parallel_into;
#[cfg(any(feature = "std", feature = "libm"))]
pub use followed_sets::{FollowedStages, followed_sweep_sets, followed_sweep_sets_into};
pub use kernel::Kernel;
#[cfg(feature = "rayon")]
pub use over_inputs::sweep_parallel_into;
pub use over_inputs::{Slices, sweep, sweep_into};
#[cfg(feature = "rayon")]
pub use over_sets::sweep_sets_parallel_into;
pub use over_sets::{sweep_sets, sweep_sets_into};
pub use staged::{OverInputs, SetStages, columns_of};
