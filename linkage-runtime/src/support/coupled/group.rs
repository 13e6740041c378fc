//! Data of a coupled group in generated code.

use crate::structure::Group;
use alloc::vec::Vec;
use linkage_core::numeric::continuation::{Range, Terms};
use linkage_core::numeric::roots::{self, Term, Variable};

/// A group without a closed form.
#[derive(Clone, Copy, Debug)]
pub struct CoupledGroup {
    /// Name of the mechanism.
    pub mechanism: &'static str,
    /// Index of the group in `STRUCTURE`.
    pub group: usize,
    /// The group in `STRUCTURE`.
    pub described: &'static Group,
    /// Its unknowns that have start estimates, in the order of
    /// [`CoupledPrograms::placed`](super::CoupledPrograms::placed).
    pub unknowns: &'static [CoupledUnknown],
    /// The variables of its polynomial system.
    pub variables: &'static [Variable],
    /// The terms of its polynomial system; none of a group that is followed from its estimates.
    pub terms: &'static [Term<'static>],
    /// The listing of all solutions of that system, [`roots::solve`]. Given with the data, so that
    /// crates without coupled groups do not build it.
    pub list: roots::Solve,
    /// The loops of a group that is followed from its estimates, in the order of
    /// [`CoupledPrograms::missed`](super::CoupledPrograms::missed); empty if there are no programs
    /// for them.
    pub missed: &'static [CoupledLoop],
    /// The inputs that it depends on.
    pub inputs: &'static [CoupledInput],
    /// Data in the cells of a grid over two of them.
    pub in_cells: Terms,
    /// The reach of the links in the default dimensions.
    pub reach: f64,
    /// The number of continuous angles on which it depends.
    pub turning: usize,
}

impl CoupledGroup {
    /// Returns true if its assembly is followed from the estimates, since its solutions cannot be
    /// listed.
    pub(crate) fn is_followed(&self) -> bool {
        self.terms.is_empty()
    }

    /// The inputs of the group among all inputs of the mechanism.
    pub(in crate::support) fn inputs_among(&self, all: &[f64]) -> Vec<f64> {
        self.inputs.iter().map(|input| all[input.index]).collect()
    }

    /// The ranges of its inputs.
    pub(super) fn ranges(&self) -> Vec<Range> {
        self.inputs.iter().map(|input| input.range).collect()
    }
}

/// An unknown with a start estimate.
#[derive(Clone, Copy, Debug)]
pub struct CoupledUnknown {
    /// Its name.
    pub name: &'static str,
    /// The estimate at the reference inputs.
    pub estimate: f64,
    /// The length that counts as much as a radian; 1 for an angle.
    pub scale: f64,
    /// Unit of a length; empty for a number.
    pub unit: &'static str,
    /// True for an angle.
    pub angle: bool,
}

/// A loop that measures the closest approach of a group.
#[derive(Clone, Copy, Debug)]
pub struct CoupledLoop {
    /// Its number, the first loop of the mechanism being 1.
    pub number: usize,
    /// The joint or link that it stands for; empty for a loop as it is written.
    pub joint: &'static str,
    /// The number of components of its sides.
    pub rows: usize,
    /// Its unit; empty for a number.
    pub unit: &'static str,
    /// The difference that counts as much as a radian.
    pub scale: f64,
}

/// An input that a group depends on.
#[derive(Clone, Copy, Debug)]
pub struct CoupledInput {
    /// Its name.
    pub name: &'static str,
    /// Unit of a length; empty for a number.
    pub unit: &'static str,
    /// Its index among all inputs.
    pub index: usize,
    /// True if its range was declared.
    pub declared: bool,
    /// Its range.
    pub range: Range,
}
