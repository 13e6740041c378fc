//! Straight-line programs: their instructions, how they are ordered, counted and shown.

pub mod count;
mod display;
mod instruction;
mod language;
pub mod schedule;
mod straight_line;

pub use crate::graph::Source;
pub use crate::operation::{
    Binary, Class, Fused, OperationRow, RustCall, Symmetry, Ternary, Unary,
};
pub use instruction::{Instruction, Value};
pub use language::{Language, print};
pub use straight_line::Program;
