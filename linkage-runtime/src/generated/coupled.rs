//! Groups without a closed form, as generated code sees them.

mod grid;
mod lanes;
mod solve;
mod starts;

pub use grid::CoupledGrid;
pub use lanes::Coupled;
pub use solve::{
    CoupledGroup, CoupledInput, CoupledPrograms, CoupledSolution, CoupledUnknown, couple, list,
};
pub use starts::{Start, Wanted, nothing, pairs, placed, put_state, starts, stepped};
