//! Printed structured text, read and run by an interpreter of its own, against the same mechanisms on Rust's numbers.

mod mechanisms;
mod names;
mod operations;
mod page;
mod parser;
mod runner;
mod syntax;
mod tokens;
