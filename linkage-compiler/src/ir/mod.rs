//! A mechanism after lowering: programs, their inputs and outputs, and the description of the
//! groups. No token and no node of a graph.
//!
//! `emit` prints it as Rust, the interpreter runs it, golden files show it ([`dump`]); everything
//! that one of them must know of a mechanism is here. Data that only Rust needs (visibility,
//! attributes, spans) stays in `syntax` and is joined by index.

mod closure_programs;
mod dump;
mod format;
mod function;
mod generated;
mod group;
mod mechanism;
mod picture;
mod picture_words;
mod signature;

pub use crate::model::{COMPONENTS, Shape};
pub use closure_programs::{ClosurePrograms, Outputs};
pub use dump::dump;
pub use format::in_degrees;
pub use function::{Body, Column, Field, Function, Meaning};
pub use generated::Generated;
pub use group::{Coupled, Group, MissedLoop, Placed, PreparedTable, ShownNumber, Surveyed};
pub use mechanism::{CompiledMechanism, plain};
pub use picture::{
    Drive, DriveOn, Gear, Guide, GuideOn, GuideShape, Joint, JointShape, Link, Member, Picture,
    PicturePart, Point, PointKind, WheelContact, WheelTurn,
};
pub use signature::{Argument, ContinuousAngle, Input, Parameter, Phase, Role, Scalar, Unknown};
