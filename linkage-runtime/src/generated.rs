//! What only generated code calls.

mod close;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod follower;
#[cfg(feature = "nalgebra")]
mod named;
mod sealed;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod settle;
mod single;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod starts;
#[cfg(feature = "alloc")]
mod sweep;
#[cfg(any(feature = "std", feature = "libm"))]
mod turns;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod way;

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use crate::circuits::{
    Bounds, Chosen, Levels, NoPrograms, Searched, SurveyedUnknown, circuits,
};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use crate::range_check::{Ranged, check_range};
#[cfg(feature = "alloc")]
pub use alloc::{boxed::Box, vec::Vec};
#[cfg(feature = "alloc")]
pub use close::{assemblies, one};
pub use close::{close, explained, finite};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use follower::{Corrected, Standing, Stop, follow, put_corrected};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::numeric::continuation::Terms;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::numeric::continuation::{Correction, Range, Residuals, Step};
#[cfg(feature = "alloc")]
pub use linkage_core::numeric::roots::{Term, Variable};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::range_check::Slack;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::{Enclosure, Level};
#[cfg(feature = "nalgebra")]
pub use named::{Named, named};
pub use sealed::Sealed;
pub use single::{Single, as_in_sweeps, inlined, single};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use starts::{
    Coupled, CoupledGrid, CoupledGroup, CoupledInput, CoupledLoop, CoupledPrograms,
    CoupledSolution, CoupledUnknown, Start, Wanted, Which, couple, list, nothing, pairs, placed,
    prepared, prepared_over, put_state, starts, starts_of, stepped,
};
#[cfg(feature = "alloc")]
pub use sweep::{
    Arguments, Block, Inputs, Kernel, Sets, fill, fill_or_call, fill_slices, in_row, next_vectors,
    rows,
};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use sweep::{Extended, Followed, Moving, States, fill_followed};
#[cfg(feature = "rayon")]
pub use sweep::{fill_followed_parallel, fill_parallel};
#[cfg(any(feature = "std", feature = "libm"))]
pub use turns::{Along, Angle, Turns, turns, wind, wind_one};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use way::{Way, follow_way};

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

/// Its content if feature `report` or `design` is on, which read columns by their names, else nothing: what nobody reads need not
/// be compiled.
#[cfg(any(feature = "report", feature = "design"))]
#[doc(hidden)]
#[macro_export]
macro_rules! if_report {
    ($($item:tt)*) => { $($item)* };
}

/// Its content if feature `report` or `design` is on, which read columns by their names, else nothing: what nobody reads need not
/// be compiled.
#[cfg(not(any(feature = "report", feature = "design")))]
#[doc(hidden)]
#[macro_export]
macro_rules! if_report {
    ($($item:tt)*) => {};
}

/// Its content if feature `rayon` is on, else nothing.
#[cfg(feature = "rayon")]
#[doc(hidden)]
#[macro_export]
macro_rules! if_rayon {
    ($($item:tt)*) => { $($item)* };
}

/// Its content if feature `rayon` is on, else nothing.
#[cfg(not(feature = "rayon"))]
#[doc(hidden)]
#[macro_export]
macro_rules! if_rayon {
    ($($item:tt)*) => {};
}
