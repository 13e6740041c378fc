//! Programs in C: instructions, and the helpers that they call.

mod helper;
mod instruction;

pub(crate) use helper::{helper_text, helpers};
pub(crate) use instruction::{Printed, Printer};
