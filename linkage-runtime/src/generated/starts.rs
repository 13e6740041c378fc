//! Groups without a closed form, as generated code sees them.

mod estimate;
mod grid;
mod lanes;
mod prepare;
mod solve;

pub use grid::CoupledGrid;
pub use lanes::Coupled;
pub use prepare::{
    Start, Wanted, Which, nothing, pairs, placed, prepared, prepared_over, put_state, starts,
    starts_of, stepped,
};
pub use solve::{
    CoupledGroup, CoupledInput, CoupledPrograms, CoupledSolution, CoupledUnknown, couple, list,
};
