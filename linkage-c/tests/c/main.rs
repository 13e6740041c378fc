//! Exported C, compiled by the system's compiler and run: against the same programs on the runtime's numbers, against published figures,
//! and for what it promises: no warning, no call, no double in single precision.

mod all_programs;
mod batch;
mod controller;
mod coupled;
mod emulated;
mod favorit;
mod machine;
mod mechanisms;
mod operations;
mod page;
mod promises;
mod quotients;
mod ranges;
mod refusals;
