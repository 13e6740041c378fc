//! Groups without a closed form, as generated code sees them.

mod closest_approach;
mod errors;
mod estimate;
mod grid;
mod group;
mod initial_state;
mod lanes;
mod outputs;
mod prepare;
mod programs;
mod solution;
mod solve;

pub use grid::CoupledGrid;
pub use group::{CoupledGroup, CoupledInput, CoupledLoop, CoupledUnknown};
pub use initial_state::InitialState;
pub use lanes::Coupled;
pub use outputs::{pairs, placed, put_state, stepped};
pub use prepare::{
    Wanted, Which, initial_states, initial_states_of, no_initial_states, prepared, prepared_over,
    prepared_over_in,
};
pub use programs::CoupledPrograms;
pub use solution::CoupledSolution;
pub use solve::{list_solutions, nearest_solution};
