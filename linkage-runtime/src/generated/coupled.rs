//! Groups without a closed form, as generated code sees them.

mod grid;
mod lanes;
#[cfg(any(feature = "std", feature = "libm"))]
mod solve;
#[cfg(any(feature = "std", feature = "libm"))]
mod starts;

pub use grid::CoupledGrid;
pub use lanes::Coupled;
#[cfg(any(feature = "std", feature = "libm"))]
pub use solve::{
    CoupledGroup, CoupledInput, CoupledPrograms, CoupledSolution, CoupledUnknown, couple, list,
};
#[cfg(any(feature = "std", feature = "libm"))]
pub use starts::{Start, Wanted, pairs, placed, put_state, starts, stepped};
