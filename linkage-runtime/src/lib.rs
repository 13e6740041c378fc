//! The library that mechanisms compiled by `linkage` call at run time. It includes the items of
//! `linkage-core`, which the compiler uses as well.
//!
//! Users reach everything here through the facade crate `linkage`.
//!
//! Features: `std` or `libm` (where the elementary functions come from; one of them is needed for
//! everything that computes angles), `alloc` (part of `std`: `Columns`, `Scene`), `nalgebra`
//! (`Vector2` and `Vector3` are those of nalgebra), `rayon` (sweeps on all threads).
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod circuits;
#[cfg(feature = "alloc")]
mod columns;
mod data;
mod dimensions;
mod error;
mod frame;
pub mod jacobian;
mod motion;
mod plane_frame;
mod programs;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod range_check;
#[cfg(feature = "alloc")]
mod result_columns;
mod result_row;
#[cfg(all(feature = "alloc", target_has_atomic = "ptr"))]
mod scene;
mod screw;
mod structure;
#[doc(hidden)]
pub mod support;
mod table;
mod vectors;

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use circuits::{Branch, BranchEnd, Circuits, Estimate, Meeting, Undetermined};
#[cfg(feature = "alloc")]
pub use columns::Columns;
pub use data::{AssemblyMode, Input, Operations, Parameter};
pub use dimensions::{DimensionSet, Dimensions};
pub use error::{AssemblyError, GroupRef, Halt, NotFollowed};
#[cfg(feature = "alloc")]
pub use error::{ClosestApproach, CoupledCause, CoupledError, Missed, Placed, Value};
pub use frame::Frame;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::Cycle;
#[cfg(feature = "alloc")]
pub use linkage_core::numeric::roots::Unlisted;
pub use linkage_core::{
    Axis, Drive, DriveOn, Gear, Guide, GuideOn, GuideShape, JointShape, Meaning, Picture,
    PictureJoint, PictureLink, PicturePart, PicturePoint, PointKind, Scalar, WheelContact,
    WheelTurn,
};
#[cfg(any(feature = "std", feature = "libm"))]
pub use linkage_core::{Enclosure, Float};
#[doc(hidden)]
pub use linkage_core::{FUSED, numeric};
pub use motion::{true_acceleration, true_jerk, true_velocity};
#[cfg(feature = "nalgebra")]
pub use nalgebra;
pub use plane_frame::PlaneFrame;
pub use programs::Programs;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use range_check::{RangeFinding, RangeFindingKind, RangeMessage, RangeReport, Unchecked};
#[cfg(feature = "alloc")]
pub use result_columns::ResultColumns;
pub use result_row::ResultRow;
#[cfg(all(feature = "alloc", target_has_atomic = "ptr"))]
pub use scene::{Handle, Handles, Scene};
pub use screw::Screw;
pub use structure::{FunctionInfo, Group, Structure};
#[cfg(feature = "alloc")]
#[doc(hidden)]
pub use table::Headed;
pub use table::{Column, Heading, PictureColumns, Table};
pub use vectors::{Vector2, Vector3};
