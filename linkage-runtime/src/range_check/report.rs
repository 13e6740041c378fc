//! Input and result of the check of a range.

use crate::data::Input;
use crate::structure::Group;
use alloc::vec::Vec;
use linkage_core::range_check::{Slack, Unchecked};

/// Result of `check_range()` of an assembly.
///
/// Printed, it has a paragraph for each thing that it finds, in the words of the compiler.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeReport {
    /// Name of the mechanism.
    pub mechanism: &'static str,
    /// The input that runs through its range, the others being at their references. `None` if
    /// nothing is checked.
    pub input: Option<Input>,
    /// The range; a turn about the reference where an angle has none.
    pub range: [f64; 2],
    /// The stretch around the reference that works.
    pub works: [f64; 2],
    /// The places where the assembly ends, or may go on in another one, from the lower end of the
    /// range on.
    pub findings: Vec<RangeFinding>,
    /// Why nothing is checked.
    pub unchecked: Option<Unchecked>,
    pub(super) groups: &'static [Group],
    pub(super) units: Vec<&'static str>,
}

/// A place in the range of an input where a group of an assembly has a dead point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RangeFinding {
    /// The kind of dead point.
    pub kind: RangeFindingKind,
    /// Index of the group in `STRUCTURE`.
    pub group: usize,
    /// The input where it begins.
    pub from: f64,
    /// The input where it ends: the same one for a change point.
    pub to: f64,
    /// The largest gap of the group, in the unit of `AssemblyError::CannotClose`; 0 at a change
    /// point.
    pub miss: f64,
}

/// Kinds of ends of an assembly in a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RangeFindingKind {
    /// Two assemblies meet, and both go on: the mechanism may go on in either.
    ChangePoint,
    /// The assembly ends, and does not close again in the range. Or a group with one assembly is
    /// singular there.
    DeadPoint,
    /// The assembly ends, and closes again at `to`.
    Gap,
    /// A division by zero, or a root or an arc function out of its range; or the range is longer
    /// than the preparation of a coupled group.
    Undefined,
}

/// An assembled mechanism, as its check sees it.
#[derive(Clone, Copy, Debug)]
pub struct Ranged<'a> {
    /// Name of the mechanism.
    pub mechanism: &'static str,
    /// Its inputs.
    pub inputs: &'static [Input],
    /// Its groups.
    pub groups: &'static [Group],
    /// The kind of slack of each.
    pub slacks: &'a [Slack],
    /// The unit of the gap of each.
    pub units: &'a [&'static str],
    /// True if whole turns of an angle are alike: nothing is prepared over the range.
    pub repeats: bool,
}

impl RangeReport {
    /// Returns true if the assembly runs through the whole range, as far as it is checked.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.findings.is_empty()
    }
}
