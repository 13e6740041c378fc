//! The surface of a mechanism for users of the C, chosen once: header and source both print it.

mod build;
mod constant;
mod data;
mod declared;
mod evaluator;
mod notes;
mod places;
mod range_names;
mod refusal;
mod renamed;

pub(crate) use build::surface;
pub(crate) use data::{Evaluator, FINITE_MATH, Surface};
pub(crate) use notes::reference;
pub(crate) use places::places;
pub(crate) use range_names::{KINDS, OFF, RangeNames};
pub(crate) use refusal::{Code, Why};
pub use renamed::Renamed;
pub(crate) use renamed::listed;
