//! Many positions: a generated kernel over rows of arguments, into columns.

mod arguments;
mod blocks;
#[cfg(any(feature = "std", feature = "libm"))]
mod extended;
mod fill;
#[cfg(any(feature = "std", feature = "libm"))]
mod followed;
mod instruction_set;
mod kernel;
#[cfg(feature = "rayon")]
mod parallel;
mod staged;

pub use arguments::{Arguments, Inputs, Sets};
#[cfg(any(feature = "std", feature = "libm"))]
pub use extended::{Extended, States};
pub use fill::{fill, fill_or_call, fill_results, fill_slices, in_row};
#[cfg(feature = "rayon")]
pub use followed::fill_followed_parallel;
#[cfg(any(feature = "std", feature = "libm"))]
pub use followed::{Followed, Moving, fill_followed};
pub use kernel::Kernel;
#[cfg(feature = "rayon")]
pub use parallel::fill_parallel;
pub use staged::{OverInputs, OverSets, RowNumbersMut, SetStages};
