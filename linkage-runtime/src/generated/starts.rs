//! Groups without a closed form, as generated code sees them.

mod estimate;
mod grid;
mod lanes;
mod prepare;
mod reach;
mod solve;

pub use grid::CoupledGrid;
pub use lanes::Coupled;
pub use prepare::{
    Start, Wanted, Which, nothing, pairs, placed, prepared, prepared_over, put_state, starts,
    starts_of, stepped,
};
pub use solve::{
    CoupledGroup, CoupledInput, CoupledLoop, CoupledPrograms, CoupledSolution, CoupledUnknown,
    couple, list,
};
