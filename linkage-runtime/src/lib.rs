//! What mechanisms compiled by `linkage` call at run time, and the numeric core that the compiler
//! shares with them.
//!
//! Users reach everything here through the facade crate `linkage`.
//!
//! Features: `std` or `libm` (where the elementary functions come from; one of them is needed for
//! everything that computes angles, and for the module `pins`), `alloc` (part of `std`: `Columns`, `Scene`, the module `summary`, with elementary functions the module `balancing`), `nalgebra`
//! (`Vector2`, `Vector3`, `Frame`), `simba` (`Lanes`), `num-dual` (`Dual`), `rayon` (sweeps on all threads),
//! `tolerance` and `monte-carlo` (the module `tolerance`), `report` (the module `report`).
#![no_std]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod balancing;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod circuits;
#[cfg(feature = "alloc")]
mod columns;
#[cfg(any(feature = "std", feature = "libm"))]
mod components;
mod data;
mod dimensions;
#[cfg(any(feature = "std", feature = "libm"))]
mod elementary;
mod error;
#[cfg(feature = "nalgebra")]
mod frame;
#[doc(hidden)]
pub mod generated;
#[doc(hidden)]
pub mod javascript;
#[cfg(any(feature = "std", feature = "libm"))]
mod math;
mod motion;
#[doc(hidden)]
pub mod numeric;
mod picture;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod pins;
#[cfg(feature = "report")]
pub mod report;
mod scalar;
#[cfg(all(feature = "alloc", target_has_atomic = "ptr"))]
mod scene;
mod structure;
#[cfg(feature = "alloc")]
pub mod summary;
mod table;
#[cfg(feature = "tolerance")]
pub mod tolerance;
mod words;

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use circuits::{Branch, BranchEnd, Circuits, Cycle, Estimate};
#[cfg(feature = "alloc")]
pub use columns::Columns;
pub use data::{AssemblyMode, Input, Operations, Parameter};
pub use dimensions::Dimensions;
pub use error::AssemblyError;
#[cfg(feature = "alloc")]
pub use error::{CoupledCause, CoupledError, Placed, Value};
#[cfg(feature = "nalgebra")]
pub use frame::Frame;
pub use javascript::Programs;
pub use motion::{true_acceleration, true_velocity};
#[cfg(feature = "nalgebra")]
pub use nalgebra::{self, Vector2, Vector3};
#[cfg(feature = "alloc")]
pub use numeric::roots::Unlisted;
pub use picture::{
    Axis, Drive, DriveOn, Gear, Guide, GuideOn, GuideShape, JointShape, Picture, PictureJoint,
    PictureLink, PicturePoint, PointKind,
};
#[cfg(feature = "num-dual")]
pub use scalar::Dual;
#[doc(hidden)]
pub use scalar::FUSED;
#[cfg(any(feature = "std", feature = "libm"))]
pub use scalar::Float;
#[cfg(all(feature = "simba", any(feature = "std", feature = "libm")))]
pub use scalar::Lanes;
pub use scalar::Scalar;
#[cfg(all(feature = "alloc", target_has_atomic = "ptr"))]
pub use scene::{Handle, Scene};
pub use structure::{FunctionInfo, Group, Structure};
pub use table::{Column, Heading, Meaning, PictureColumns, Table};
