//! Groups without a closed form, as generated code sees them.

mod estimate;
mod grid;
mod group;
mod lanes;
mod prepare;
mod reach;
mod solve;

pub use grid::CoupledGrid;
pub use group::{CoupledGroup, CoupledInput, CoupledLoop, CoupledUnknown};
pub use lanes::Coupled;
pub use prepare::{
    Start, Wanted, Which, nothing, pairs, placed, prepared, prepared_over, put_state, starts,
    starts_of, stepped,
};
pub use solve::{CoupledPrograms, CoupledSolution, couple, list};
