//! Programs in C: instructions, and the helpers that they call.

mod helper;
mod instruction;

pub(crate) use helper::Helpers;
pub(crate) use instruction::{Printed, Printer};
