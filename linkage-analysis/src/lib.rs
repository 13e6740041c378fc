//! Analyses of mechanisms: the effect of tolerances, figures of a cycle, cyclograms, clearances,
//! cams, pins and counterweights.
//!
//! An analysis takes numbers and functions, as `mechanism!` generates them. It does not know how a
//! mechanism is solved.
//!
//! Users reach all items through the facade crate `linkage`, in the modules of the same names.
//!
//! Features: `std` or `libm` (where the elementary functions come from; one of them is needed for
//! `pins`), `alloc` (part of `std`: the modules `summary` and `cyclogram`, with elementary functions
//! `balancing`, `cam` and `clearance`), `nalgebra` (vectors of nalgebra as forces and
//! sensitivities), `tolerance` and `monte-carlo` (the module `tolerance`), `files` (files of
//! cyclograms and cams).
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod balancing;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod cam;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod clearance;
#[cfg(any(feature = "std", feature = "libm"))]
mod components;
#[cfg(feature = "alloc")]
pub mod cyclogram;
#[cfg(any(feature = "std", feature = "libm"))]
#[doc(hidden)]
pub mod internals;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod pins;
#[cfg(feature = "alloc")]
pub mod summary;
#[cfg(feature = "tolerance")]
pub mod tolerance;
