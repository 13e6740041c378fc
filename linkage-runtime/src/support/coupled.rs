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
pub use outputs::pairs;
pub(super) use outputs::{placed, stepped};
pub(super) use prepare::prepared_over;
pub use prepare::{Which, initial_states, prepared};
pub use programs::{CoupledPrograms, NoPrograms};
pub use solution::CoupledSolution;
pub use solve::{list_solutions, nearest_solution};
