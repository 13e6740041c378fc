//! What closes the loops at compile time: gaps and unknowns of all groups in one program, and the programs of coupled groups.

use linkage_symbolic::program::Program;

use super::Coupled;

/// The groups as programs from parameters and inputs alone, made before any function is looked at.
#[derive(Clone, Debug, Default)]
pub struct Closing {
    /// Computes what [`Outputs`] names, group by group, then [`Closing::valued`].
    pub program: Program,
    /// Where a group's numbers stand, in the order of the groups.
    pub groups: Vec<Outputs>,
    /// Angles whose values the groups themselves use, and their outputs (cosine; the sine follows).
    pub valued: Vec<(usize, usize)>,
    /// The programs of the coupled groups.
    pub coupled: Vec<Coupled>,
}

/// Where a group's numbers stand among the program's outputs.
#[derive(Clone, Debug, Default)]
pub struct Outputs {
    /// Unknowns that are compared with their estimates here: (unknown, first output).
    pub unknowns: Vec<(usize, usize)>,
    /// By how much it misses.
    pub gap: usize,
    /// See `Closed::slack`.
    pub slack: usize,
    /// See `Closed::margin`.
    pub margin: usize,
    /// See `Closed::slack_scale`.
    pub slack_scale: usize,
    /// Instructions up to here compute this group and those before.
    pub end: usize,
}
