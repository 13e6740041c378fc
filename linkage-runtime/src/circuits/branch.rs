//! Assemblies over the range of an input, as they are reported.

use crate::error::GroupRef;
use alloc::vec::Vec;
use linkage_core::Cycle;

/// All assemblies over the range of an input.
///
/// Printed, it is a table; angles are in degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct Circuits<A> {
    /// The range.
    pub cycle: Cycle,
    /// Name of the input.
    pub input: &'static str,
    /// The assemblies, in the order of the inputs where they begin.
    pub branches: Vec<Branch<A>>,
    /// The pairs of assemblies that meet in change points.
    pub meetings: Vec<Meeting>,
    /// The assemblies of first groups with which a later one is at a dead point throughout.
    pub undetermined: Vec<Undetermined>,
}

/// Assemblies that are no branches: a group is at a dead point over a part of the range, because its
/// links lie on each other or in one line, and rounding alone would decide their position.
#[derive(Clone, Debug, PartialEq)]
pub struct Undetermined {
    /// The group.
    pub group: GroupRef,
    /// Both ends of that part.
    pub ends: [f64; 2],
    /// The input at which `unknowns` are: the reference if it is in that part.
    pub input: f64,
    /// The values of the unknowns of the groups before.
    pub unknowns: Vec<Estimate>,
}

/// Two assemblies that meet, and both go on: from a change point the mechanism can go on in either.
#[derive(Clone, Debug, PartialEq)]
pub struct Meeting {
    /// Their places among the branches.
    pub branches: [usize; 2],
    /// The inputs at which they meet; of a turn that begins at one, its end is none.
    pub at: Vec<f64>,
}

/// An assembly and how far it reaches.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch<A> {
    /// The assembly.
    pub assembly: A,
    /// Number of its circuit. Without being taken apart, a mechanism reaches all assemblies of a
    /// circuit, through turning points, and no other.
    pub circuit: usize,
    /// Both ends.
    pub ends: [BranchEnd; 2],
    /// True if a full turn of the input leads back to the same position.
    pub closed: bool,
    /// Its smallest margin, 0 at a turning point.
    pub margin: f64,
    /// The input where the margin is smallest.
    pub at: f64,
    /// The input at which `unknowns` are: the reference if the assembly exists there.
    pub input: f64,
    /// The values of the unknowns, to be copied as start estimates for that input.
    pub unknowns: Vec<Estimate>,
}

/// A value of an unknown. Printed, it is a start estimate: `theta = 40.2074deg`.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// The unknown.
    pub name: &'static str,
    /// Unit of a length; empty for a number.
    pub unit: &'static str,
    /// True for an angle, from -pi to pi, which is printed in degrees.
    pub angle: bool,
    /// Its value, or the components of a point.
    pub numbers: Vec<f64>,
}

/// An end of an assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BranchEnd {
    /// With the range.
    Range(f64),
    /// At a turning point, a dead point of the input, where it meets another assembly of its
    /// circuit.
    TurningPoint(f64),
    /// It is not known beyond this input, although there is no turning point: a slide runs off to
    /// infinity, or two circuits cross.
    Lost(f64),
}

impl BranchEnd {
    /// The input.
    #[must_use]
    pub fn x(self) -> f64 {
        match self {
            Self::Range(x) | Self::TurningPoint(x) | Self::Lost(x) => x,
        }
    }
}

impl<A> Branch<A> {
    /// Returns true if the assembly runs through the whole range.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let through = |end: &BranchEnd| matches!(end, BranchEnd::Range(_));
        self.ends.iter().all(through)
    }
}

impl<A> Circuits<A> {
    /// The assemblies that run through the whole range.
    pub fn whole(&self) -> impl Iterator<Item = &Branch<A>> {
        self.branches.iter().filter(|branch| branch.is_whole())
    }
}
