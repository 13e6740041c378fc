//! The library that mechanisms compiled by `linkage` call at run time. It includes the items of
//! `linkage-core`, which the compiler uses as well.
//!
//! Users reach everything here through the facade crate `linkage`.
//!
//! Features: `std` or `libm` (where the elementary functions come from; one of them is needed for
//! everything that computes angles, and for the module `pins`), `alloc` (part of `std`: `Columns`,
//! `Scene`, the modules `summary` and `cyclogram`, with elementary functions `balancing`, `cam` and
//! `clearance`), `nalgebra` (`Vector2`, `Vector3`, `Frame`, `Screw`), `simba` (`Lanes`), `num-dual`
//! (`Dual`), `rayon` (sweeps on all threads), `tolerance` and `monte-carlo` (the module
//! `tolerance`), `design` (the module `design`), `report` (the module `report`).
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
mod circuits;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod clearance;
#[cfg(feature = "alloc")]
mod columns;
#[cfg(any(feature = "std", feature = "libm"))]
mod components;
#[cfg(feature = "alloc")]
pub mod cyclogram;
mod data;
#[cfg(feature = "design")]
pub mod design;
mod dimensions;
mod error;
mod format;
#[cfg(feature = "nalgebra")]
mod frame;
pub mod jacobian;
#[doc(hidden)]
pub mod javascript;
mod motion;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod pins;
#[cfg(feature = "nalgebra")]
mod plane_frame;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod range_check;
#[cfg(feature = "report")]
pub mod report;
#[cfg(feature = "alloc")]
mod result_columns;
mod result_row;
#[cfg(all(feature = "alloc", target_has_atomic = "ptr"))]
mod scene;
#[cfg(feature = "nalgebra")]
mod screw;
mod structure;
#[cfg(feature = "alloc")]
pub mod summary;
#[doc(hidden)]
pub mod support;
mod table;
#[cfg(feature = "tolerance")]
pub mod tolerance;

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use circuits::{Branch, BranchEnd, Circuits, Estimate, Meeting};
#[cfg(feature = "alloc")]
pub use columns::Columns;
pub use data::{AssemblyMode, Input, Operations, Parameter};
pub use dimensions::Dimensions;
pub use error::{AssemblyError, GroupRef, Halt, NotFollowed};
#[cfg(feature = "alloc")]
pub use error::{ClosestApproach, CoupledCause, CoupledError, Missed, Placed, Value};
#[cfg(feature = "nalgebra")]
pub use frame::Frame;
pub use javascript::Programs;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::Cycle;
#[cfg(feature = "num-dual")]
pub use linkage_core::Dual;
#[cfg(all(feature = "simba", any(feature = "std", feature = "libm")))]
pub use linkage_core::Lanes;
#[cfg(feature = "alloc")]
pub use linkage_core::numeric::roots::Unlisted;
pub use linkage_core::{
    Axis, Drive, DriveOn, Gear, Guide, GuideOn, GuideShape, JointShape, Meaning, Picture,
    PictureJoint, PictureLink, PicturePart, PicturePoint, PointKind, Scalar,
};
#[cfg(any(feature = "std", feature = "libm"))]
pub use linkage_core::{Enclosure, Float};
#[doc(hidden)]
pub use linkage_core::{FUSED, numeric};
pub use motion::{true_acceleration, true_jerk, true_velocity};
#[cfg(feature = "nalgebra")]
pub use nalgebra::{self, Vector2, Vector3};
#[cfg(feature = "nalgebra")]
pub use plane_frame::PlaneFrame;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use range_check::{RangeFinding, RangeFindingKind, RangeMessage, RangeReport, Unchecked};
#[cfg(feature = "alloc")]
pub use result_columns::ResultColumns;
pub use result_row::ResultRow;
#[cfg(all(feature = "alloc", target_has_atomic = "ptr"))]
pub use scene::{Handle, Handles, Scene};
#[cfg(feature = "nalgebra")]
pub use screw::Screw;
pub use structure::{FunctionInfo, Group, Structure};
#[cfg(feature = "alloc")]
#[doc(hidden)]
pub use table::Headed;
pub use table::{Column, Heading, PictureColumns, Table};
