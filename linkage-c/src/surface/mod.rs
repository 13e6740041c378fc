//! The surface of a mechanism for users of the C, computed once: header and source both print it.

mod build;
mod constant;
mod data;
mod declared;
mod evaluator;
mod range_names;
mod refusal;
mod target;

pub(crate) use build::surface;
pub(crate) use constant::{API, FINITE_MATH, LOCAL, OFF};
pub(crate) use data::Surface;
pub(crate) use declared::Declared;
pub(crate) use evaluator::Evaluator;
pub(crate) use range_names::{KINDS, RangeNames};
pub(crate) use refusal::{Code, Why};
