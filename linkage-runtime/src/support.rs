//! Items that only generated code calls.

mod assembling;
mod assembly_data;
mod constants;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod continuation;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod coupled;
mod dispatch;
mod evaluation;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod follower;
mod named;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod settle;
mod stages;
#[cfg(feature = "alloc")]
mod sweep;

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use crate::circuits::{Chosen, Levels, Searched, circuits, circuits_of};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use crate::range_check::{Ranged, check_range, check_range_of};
#[cfg(feature = "alloc")]
pub use alloc::{boxed::Box, vec::Vec};
#[cfg(any(feature = "std", feature = "libm"))]
pub use assembling::assemble;
pub use assembling::{
    Along, Angle, ArrayRevolutions, Compiled, CoreOf, DataOf, Description, List, Revolutions,
    RevolutionsOf,
};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use assembling::{
    Bounds, CoupledParts, GroupData, GroupProgram, GroupPrograms, Grouped, PlainGroups,
    SurveyedUnknown, assemble_coupled, assemble_from, assemble_there, assemblies, assemblies_at,
    bounds, slacks, surveyed,
};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub(crate) use assembling::{surveyor, with_lanes};
pub use assembly_data::{AssemblyData, Core};
pub use constants::{
    derivative_of, drawn, function, function_names, margin, operations, parameter, rate,
    sensitivity, value,
};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use coupled::{
    Coupled, CoupledGrid, CoupledGroup, CoupledInput, CoupledLoop, CoupledPrograms,
    CoupledSolution, CoupledUnknown, InitialState, NoPrograms, Which, initial_states,
    list_solutions, nearest_solution, pairs, prepared,
};
pub use dispatch::{Dispatch, dispatch, inlined};
pub use evaluation::{Function, FunctionNames, NoStates, States, call, call_inlined, evaluate};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use follower::{Corrected, Standing, Stop, follow, put_corrected};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::numeric::continuation::Terms;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::numeric::continuation::{Correction, Range, Residuals, Step};
#[cfg(feature = "alloc")]
pub use linkage_core::numeric::roots::{Term, Variable, solve as list_roots};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::range_check::Slack;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_core::{Enclosure, Level};
pub use named::{Named, named};
pub use stages::{
    Block, FinishedRows, Memory, RowNumbers, RowNumbersMut, RunStages, Stage, StageData, StageRow,
    Staged, once,
};
#[cfg(feature = "alloc")]
pub use sweep::{
    Arguments, Kernel, OverInputs, SetStages, Slices, columns_of, fill, sweep, sweep_into,
    sweep_sets, sweep_sets_into,
};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use sweep::{FollowedStages, Moving, followed_sweep_sets, followed_sweep_sets_into};
#[cfg(feature = "rayon")]
pub use sweep::{followed_sweep_sets_parallel_into, sweep_parallel_into, sweep_sets_parallel_into};
