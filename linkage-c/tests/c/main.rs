//! Exported C, compiled by the system's compiler and run: against the same programs on the runtime's numbers, against published figures,
//! and for what it promises: no warning, no call, no double in single precision.

mod all_programs;
mod api;
mod arithmetic;
mod batch;
mod constants;
mod controller;
mod coupled;
mod emulated;
mod favorit;
mod finite;
mod foreign;
mod fused;
mod headers;
mod machine;
mod mechanisms;
mod names;
mod operations;
mod page;
mod preprocessor;
mod promises;
mod quotients;
mod ranges;
mod refusals;
mod rows;
mod soft_float;
mod turns;
mod users;
