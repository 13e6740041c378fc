//! A group as errors name it.

use crate::structure::Group;
use core::fmt;
use linkage_core::format::{join, numbers};

/// A group of a mechanism, as errors name it.
///
/// Printed, it is `CrankRocker: loop 1 (theta, psi; RRR)`; a group without loops is named by its
/// number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GroupRef {
    /// Name of the mechanism.
    pub mechanism: &'static str,
    /// Index of the group in `STRUCTURE`.
    pub index: usize,
    /// Its kind, such as `RRR`.
    pub kind: &'static str,
    /// Its loops, the first loop of the mechanism being 1.
    pub loops: &'static [usize],
    /// Its unknowns.
    pub unknowns: &'static [&'static str],
}

impl GroupRef {
    /// The group with this index in the structure of a mechanism.
    pub(crate) fn new(mechanism: &'static str, index: usize, group: &'static Group) -> Self {
        Self {
            mechanism,
            index,
            kind: group.kind,
            loops: group.loops,
            unknowns: group.unknowns,
        }
    }
}

impl fmt::Display for GroupRef {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            mechanism,
            index,
            kind,
            loops,
            unknowns,
        } = self;
        write!(f, "{mechanism}: ")?;
        match loops {
            [] => write!(f, "group {}", index + 1)?,
            [only] => write!(f, "loop {only}")?,
            [first @ .., last] => write!(f, "loops {} and {last}", numbers(first, ", "))?,
        }
        let separator = if unknowns.is_empty() || kind.is_empty() {
            ""
        } else {
            "; "
        };
        match (unknowns, *kind) {
            ([], "") => Ok(()),
            _ => write!(f, " ({}{separator}{kind})", join(unknowns, ", ")),
        }
    }
}
