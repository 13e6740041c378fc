//! Reads the machine code of functions of this very process: of code without loops every path, of sweeps the loops.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

mod decode;
mod single;
mod sweep;
mod symbols;

pub use single::{Findings, chosen, inspect};
pub use sweep::{Loops, Set, loops, sweep};
