//! What only generated code calls.

mod close;
#[cfg(feature = "alloc")]
mod sweep;
#[cfg(any(feature = "std", feature = "libm"))]
mod turns;

#[cfg(feature = "alloc")]
pub use alloc::vec::Vec;
#[cfg(feature = "alloc")]
pub use close::assemblies;
pub use close::close;
#[cfg(feature = "alloc")]
pub use sweep::{Kernel, fill};
#[cfg(any(feature = "std", feature = "libm"))]
pub use turns::{Along, Angle, Turns, turns, wind};

/// Its content if feature `alloc` is on, else nothing: generated code cannot see the features.
#[cfg(feature = "alloc")]
#[doc(hidden)]
#[macro_export]
macro_rules! if_alloc {
    ($($item:tt)*) => { $($item)* };
}

/// Its content if feature `alloc` is on, else nothing: generated code cannot see the features.
#[cfg(not(feature = "alloc"))]
#[doc(hidden)]
#[macro_export]
macro_rules! if_alloc {
    ($($item:tt)*) => {};
}
