//! Common ground of the compiler of `linkage` and the code that it generates: scalars with their
//! elementary functions, numeric searches and tables on plain `f64`, and texts of messages.
//!
//! Users reach what is theirs through the facade, the rest may change with every version. It stands
//! in a crate of its own so that the compiler, which runs on the machine that builds, needs nothing
//! else of the runtime.
//!
//! Features: `std` or `libm` (where the elementary functions come from), `alloc` (part of `std`),
//! `simba` (`Lanes`), `num-dual` (`Dual`).
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(feature = "alloc")]
#[doc(hidden)]
pub mod bytes;
#[doc(hidden)]
pub mod certificate;
#[cfg(any(feature = "std", feature = "libm"))]
mod elementary;
#[doc(hidden)]
pub mod format;
#[cfg(any(feature = "std", feature = "libm"))]
#[doc(hidden)]
pub mod math;
mod meaning;
#[doc(hidden)]
pub mod numeric;
mod picture;
#[cfg(feature = "alloc")]
#[doc(hidden)]
pub mod range_check;
mod scalar;
mod survey;

#[cfg(any(feature = "std", feature = "libm"))]
#[doc(hidden)]
pub use elementary::directions;
pub use meaning::Meaning;
pub use picture::{
    Axis, Drive, DriveOn, Gear, Guide, GuideOn, GuideShape, JointShape, Picture, PictureJoint,
    PictureLink, PicturePart, PicturePoint, PointKind, WheelContact, WheelTurn,
};
#[cfg(feature = "num-dual")]
pub use scalar::Dual;
#[doc(hidden)]
pub use scalar::FUSED;
#[cfg(all(feature = "simba", any(feature = "std", feature = "libm")))]
pub use scalar::Lanes;
pub use scalar::Scalar;
#[cfg(any(feature = "std", feature = "libm"))]
pub use scalar::{Enclosure, Float};
pub use survey::{Cycle, Level};
