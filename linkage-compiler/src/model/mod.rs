//! Syntax tree to model: names become ids, dimensions are checked, numbers get one unit.

mod angles;
mod argument;
mod bare;
mod call_messages;
mod calls;
mod conversion;
mod course;
mod decimal;
mod derivative;
mod dimension;
mod dump;
mod embed;
mod evaluators;
mod expression;
mod factors;
mod frame;
mod functions;
mod generated;
mod given;
mod items;
mod leaf;
mod library;
mod mechanics;
mod names;
mod operators;
mod parameter;
mod part;
mod part_frame;
mod part_messages;
mod part_place;
mod passes;
mod picture;
mod place;
mod plane_and_space;
mod presentation;
mod rate;
mod refused;
mod screw;
mod shape;
mod slopes;
#[cfg(test)]
mod tests;
mod types;
mod unitless;
mod units;
mod unknown_frame;
mod usage;
mod variable;
mod walk;
mod words;
mod zeros;

pub(crate) use dump::dump;
pub(crate) use frame::{PARTS as FRAME_PARTS, PLANE_PARTS, VECTORS_OF_PLANE};
pub(crate) use functions::{MechanicsWord, MotionWord, QuantityWord};
pub(crate) use generated::{
    ASSEMBLY, COLUMNS, FOLLOWER, METHODS_OF_FOLLOWER, Sweep, TYPE_PARAMETER,
};
pub(crate) use library::{Library, Model, resolve};
pub use parameter::COMPONENTS;
pub use shape::Shape;
pub(crate) use types::*;
pub(crate) use usage::AskedPicture;
pub(crate) use walk::Derived;
