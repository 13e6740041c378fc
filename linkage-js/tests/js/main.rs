//! Printed JavaScript in a real browser, against the same mechanisms on Rust's numbers.

mod all_programs;
mod constants;
mod integrator;
mod interpreted;
mod module;
mod names;
mod page;
mod quotients;
