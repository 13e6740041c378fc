//! Straight-line programs: their instructions, how they are ordered, counted and shown.

pub mod count;
mod display;
mod instruction;
mod print;
pub mod schedule;
mod straight_line;

pub use crate::graph::Source;
pub use crate::operation::{Binary, Call, Class, Fused, Row, Symmetry, Ternary, Unary};
pub use instruction::{Instruction, Value};
pub use print::{Language, print};
pub use straight_line::Program;
