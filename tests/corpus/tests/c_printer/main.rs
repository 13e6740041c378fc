//! Every program of a unit printed as C, compiled by the system's compiler, and compared with the interpreter to the last bit: for
//! all mechanisms of the golden files and for random ones. And every operation alone: C, interpreter, generated Rust.
//!
//! Nothing but the unit is known to the printer, so it shows that a unit is free of Rust.

mod agreement;
mod fields;
mod instruction;
mod machine;
mod mechanisms;
mod numbers;
mod operations;
mod printer;
