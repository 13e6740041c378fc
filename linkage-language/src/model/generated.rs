//! Names of items that the macro generates in addition to a function or a type of the user. Nothing
//! else can have these names.

use crate::syntax::vocabulary;

vocabulary! {
    /// Functions that are generated in addition to a function `NAME`, by the suffix of the name.
    pub enum Sweep {
        /// Returns new columns.
        Owned = "_sweep",
        /// Writes into columns.
        Into = "_sweep_into",
        /// Writes into slices.
        Slices = "_sweep_slices",
        /// Writes into columns, on all cores.
        ParallelInto = "_sweep_parallel_into",
        /// Returns the columns of several sets of dimensions.
        Sets = "_sweep_sets",
        /// Writes the columns of several sets of dimensions.
        SetsInto = "_sweep_sets_into",
        /// Writes the columns of several sets of dimensions, on all cores.
        SetsParallelInto = "_sweep_sets_parallel_into",
    }
}

/// The suffix of the type of a mechanism's assemblies.
pub const ASSEMBLY: &str = "Assembly";

/// The suffix of the type that follows an assembly of a mechanism with several inputs.
pub const FOLLOWER: &str = "Follower";

/// The functions and methods of a follower.
pub const METHODS_OF_FOLLOWER: [&str; 4] = ["follower", "follow", "assembly", "inputs"];

/// The suffix of the type of the columns of sweeps, after the name of the result type.
pub const COLUMNS: &str = "Columns";

/// The scalar type of all types that are generated: no type can have its name.
pub const TYPE_PARAMETER: &str = "T";
