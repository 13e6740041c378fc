//! What generated code says of a group without a closed form.

use alloc::vec::Vec;
use linkage_core::numeric::continuation::{Range, Terms};
use linkage_core::numeric::roots::{Term, Variable};

/// A group without a closed form.
#[derive(Clone, Copy, Debug)]
pub struct CoupledGroup {
    /// Name of the mechanism.
    pub mechanism: &'static str,
    /// Index of the group in `STRUCTURE`.
    pub group: usize,
    /// Its kind.
    pub kind: &'static str,
    /// Its loops, the first loop of the mechanism being 1.
    pub loops: &'static [usize],
    /// Its unknowns, for messages.
    pub names: &'static [&'static str],
    /// Its unknowns that have start estimates, in the order of [`CoupledPrograms::placed`](super::CoupledPrograms::placed).
    pub unknowns: &'static [CoupledUnknown],
    /// The variables of its polynomial system.
    pub variables: &'static [Variable],
    /// The terms of its polynomial system; none of a group that is followed from its estimates.
    pub terms: &'static [Term<'static>],
    /// The loops of a group that is followed from its estimates, in the order of [`CoupledPrograms::missed`](super::CoupledPrograms::missed); none if
    /// that cannot be told.
    pub missed: &'static [CoupledLoop],
    /// The inputs that it depends on.
    pub inputs: &'static [CoupledInput],
    /// What a grid over two of them knows in its cells.
    pub in_cells: Terms,
}

impl CoupledGroup {
    /// Whether its assembly is followed from the estimates, since its solutions cannot be listed.
    pub(crate) fn is_followed(&self) -> bool {
        self.terms.is_empty()
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
    /// Where it is at the reference inputs, about.
    pub estimate: f64,
    /// The length that counts as much as a radian; 1 for an angle.
    pub scale: f64,
    /// Unit of a length; empty for a number.
    pub unit: &'static str,
    /// Whether it is an angle.
    pub angle: bool,
}

/// A loop by which is told how near to closing a group comes.
#[derive(Clone, Copy, Debug)]
pub struct CoupledLoop {
    /// Its number, the first loop of the mechanism being 1.
    pub number: usize,
    /// How many components its sides have.
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
    /// Whether its range was declared.
    pub declared: bool,
    /// Its range.
    pub range: Range,
}
