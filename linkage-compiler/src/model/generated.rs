//! Names of what the macro generates beside a function or a type of the user: nothing else may have them.

use crate::syntax::vocabulary;

vocabulary! {
    /// What is generated beside a function `NAME`, by what follows the name.
    pub(crate) enum Sweep {
        Owned = "_sweep",
        Into = "_sweep_into",
        Slices = "_sweep_slices",
        ParallelInto = "_sweep_parallel_into",
        Sets = "_sweep_sets",
        SetsInto = "_sweep_sets_into",
        SetsParallelInto = "_sweep_sets_parallel_into",
    }
}

/// The type of a mechanism's assemblies, by what follows the mechanism's name.
pub(crate) const ASSEMBLY: &str = "Assembly";

/// The type of what follows an assembly of a mechanism with several inputs, by what follows the mechanism's name.
pub(crate) const FOLLOWER: &str = "Follower";

/// Beside the functions: how a follower comes about, and what it has.
pub(crate) const METHODS_OF_FOLLOWER: [&str; 4] = ["follower", "follow", "assembly", "inputs"];

/// The type of the columns of sweeps, by what follows the name of the result type.
pub(crate) const COLUMNS: &str = "Columns";

/// The scalar type of all types that are generated: no type can have its name.
pub(crate) const TYPE_PARAMETER: &str = "T";
