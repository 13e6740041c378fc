//! Groups without a closed form, as generated code sees them.

mod errors;
mod estimate;
mod grid;
mod group;
mod lanes;
mod outputs;
mod prepare;
mod programs;
mod reach;
mod solution;
mod solve;
mod start;

pub use grid::CoupledGrid;
pub use group::{CoupledGroup, CoupledInput, CoupledLoop, CoupledUnknown};
pub use lanes::Coupled;
pub use outputs::{pairs, placed, put_state, stepped};
pub use prepare::{Wanted, Which, nothing, prepared, prepared_over, starts, starts_of};
pub use programs::CoupledPrograms;
pub use solution::CoupledSolution;
pub use solve::{couple, list};
pub use start::Start;
