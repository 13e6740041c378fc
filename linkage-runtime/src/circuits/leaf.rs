//! An assembly of the first groups over a part of the range, as the search has it.

use super::branch::BranchEnd;
use super::levels::Chosen;
use super::slab::Slab;
use crate::data::AssemblyMode;
use alloc::vec::Vec;
use linkage_core::numeric::continuation::Range;

/// An end of an assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum End {
    Range,
    /// A turning point of a group; turning points are numbered.
    Turning {
        number: usize,
        group: usize,
    },
    Lost,
}

/// The assembly of one group.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum GroupAssembly {
    Mode(AssemblyMode),
    /// The states of a coupled group at both ends.
    States([Vec<f64>; 2]),
}

/// An assembly of all groups between two ends.
#[derive(Clone, Debug)]
pub(super) struct Leaf {
    pub(super) chosen: Chosen,
    /// Group by group, those with one assembly excepted.
    pub(super) ways: Vec<(usize, GroupAssembly)>,
    pub(super) inputs: [f64; 2],
    pub(super) ends: [End; 2],
    /// A place between the ends where it is known, if a coupled group has one.
    pub(super) known: Option<f64>,
}

impl Leaf {
    /// The range of its table: the whole range, or the inputs between its ends, however near these
    /// are to each other.
    pub(super) fn range(&self, whole: Range) -> Range {
        let [low, high] = self.inputs;
        match self.ends {
            [End::Range, End::Range] => whole,
            _ => Range { low, high, ..whole },
        }
    }

    pub(super) fn slab(&self) -> Slab {
        let [low, high] = self.inputs;
        Slab { low, high }
    }

    /// Returns true if a coupled group is among the assembled ones.
    pub(super) fn is_coupled(&self) -> bool {
        let of_states = |(_, way): &(usize, GroupAssembly)| matches!(way, GroupAssembly::States(_));
        self.ways.iter().any(of_states)
    }

    /// Returns true if it ends at a turning point.
    pub(super) fn turns(&self) -> bool {
        let turning = |end: &End| matches!(end, End::Turning { .. });
        self.ends.iter().any(turning)
    }

    pub(super) fn branch_ends(&self) -> [BranchEnd; 2] {
        [0, 1].map(|side| match self.ends[side] {
            End::Range => BranchEnd::Range(self.inputs[side]),
            End::Turning { .. } => BranchEnd::TurningPoint(self.inputs[side]),
            End::Lost => BranchEnd::Lost(self.inputs[side]),
        })
    }
}
