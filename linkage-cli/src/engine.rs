//! Mechanisms on numbers: the functions of the macro's code, by an interpreter of the same programs
//! and with the same parts of the runtime.

mod assemble;
mod circuits;
mod coupled;
mod numbers;
mod operations;
mod range_check;
mod revolutions;
mod winding;

pub use assemble::Assembly;
