//! The programs that close the loops at compile time: gaps and unknowns of all groups in one
//! program, and the programs of coupled groups.

use linkage_symbolic::program::Program;

use super::Coupled;

/// The groups as programs from parameters and inputs alone, made before any function is looked at.
#[derive(Clone, Debug, Default)]
pub struct ClosurePrograms {
    /// Computes the numbers that [`Outputs`] names, group by group, then [`Self::valued`].
    pub program: Program,
    /// The indices of each group's numbers, in the order of the groups.
    pub groups: Vec<Outputs>,
    /// Angles whose values the groups themselves use, and their outputs (cosine; the sine follows).
    pub valued: Vec<(usize, usize)>,
    /// The programs of the coupled groups.
    pub coupled: Vec<Coupled>,
}

/// The indices of a group's numbers among the program's outputs.
#[derive(Clone, Debug, Default)]
pub struct Outputs {
    /// Unknowns that are compared with their estimates here: (unknown, first output).
    pub unknowns: Vec<(usize, usize)>,
    /// Of a group without unknowns of the mechanism, the angles of links that are compared with
    /// their estimates instead: (angle, first output).
    pub links: Vec<(usize, usize)>,
    /// The amount by which it misses closing.
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
