//! Exported C, compiled by the system's compiler and run: against the same programs on the runtime's numbers, against published figures,
//! and for what it promises: no warning, no call, no double in single precision.

mod all_programs;
mod batch;
mod controller;
mod coupled;
mod emulated;
mod favorit;
mod given;
mod machine;
mod mechanisms;
mod numbers;
mod operations;
mod page;
mod programs;
mod promises;
mod reference;
mod refusals;
